// What a message may ask for: each thing that can be done here with what it names.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/gist/message.h"
#include "components/goalnet/sym_state.h"

namespace goalnet::inference::gist {

enum class Ask : std::uint8_t {
  kOpen,
  kTake,
  kMoveAway,
  kEmpty,
  kFillWithWater,
  kFill,  // with other
  kDiscard,
  kPut,  // on or into other
  kHeat,
  kTurnOn,
  kTurnOff,
  kLightBurner,
  kPutOutBurner,
  kChannel,
  kMute,
  kUnmute,
  kGo,
  kClose,
  kRelease,
};

struct Request {
  Ask ask = Ask::kTake;
  int thing = -1, other = -1;            // which of Message::named; -1: none
  std::string thing_class, other_class;  // names of classes, or of what a vessel is filled with
  int number = 0;                        // of a burner or channel
  std::size_t at = 0;                    // the word that it is about, where it has no thing
  int view = 0;                          // of Views, whose message it is about
  bool holds = false;                    // it is so already, where that can be told
  // The same for requests that want the same: "at mug sink". Of them the likeliest counts.
  std::string what;
};

// One way of looking at a message, and what it may ask for.
struct View {
  Message message;
  std::vector<Request> requests;
};
// As it was said, and as the grammar reads it first: who is not understood by one is by the other.
using Views = std::vector<View>;

std::vector<Request> possible_requests(const Message& message, int view, const Instruction& here,
                                       const SymState& start, const Lexicon& lexicon, const Symbols& symbols);

// "FridgeLeft" -> "fridge", "Mug_1" -> "mug"; the class as requests name it.
std::string class_name(Symbol object, const Instruction& here, const Lexicon& lexicon,
                       const Symbols& symbols);

}  // namespace goalnet::inference::gist
