// How anything in goalnet ends: one enum in four blocks, shared by messages, JSON and exit codes.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace goalnet {

// The numbers are part of the interface: they are process exit codes and travel in messages.
enum class Outcome : int {
  kDone = 0,
  // 10-19: refused. Nothing was moved; asking differently may help.
  kNotUnderstood = 10,   // the sentence means nothing to the model
  kUnknownObject = 11,   // a name that this world or domain does not have
  kNoPlan = 12,          // the goal cannot be reached from here
  kInvalidRequest = 13,  // malformed input: arguments, files, messages
  kBusy = 14,            // another instruction is running
  // 20-29: an expected limit was met; the robot stopped safely.
  kTimeLimit = 20,
  kStepLimit = 21,
  kCancelled = 22,
  // 30-39: a fault; the robot stopped safely and somebody should look.
  kMotionFailed = 30,
  kWorldStale = 31,
  kComponentLost = 32,
  kEmergencyStop = 33,
  kInternal = 39,
};

// Short lower-case name used in JSON and traces, for example "no_plan".
std::string_view to_string(Outcome outcome);

// The inverse; kInternal for a number that is no outcome.
Outcome outcome_from_int(int code);

// Why something did not work: a typed outcome and one message that says what, where and what to do.
struct Error {
  Outcome outcome = Outcome::kInternal;
  std::string message;
};

template <class T>
using Expected = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(Outcome outcome, std::string message) {
  return tl::unexpected<Error>(Error{outcome, std::move(message)});
}

}  // namespace goalnet
