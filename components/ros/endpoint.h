// One DDS writer or reader without its message type: what publishers, subscriptions, services and actions are
// made of. Users take those; this header is for components/ros and for tools that handle any type.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/qos.h"
#include "idl/type_support.h"

namespace goalnet::ros {

using Gid = std::array<std::uint8_t, 16>;  // names a DDS endpoint or participant everywhere

// The sequence number that a request carries in its related identity: none.
inline constexpr std::int64_t kUnknownSequence = -(std::int64_t{1} << 32);

// Names one sample; in a reply, the request that it answers.
struct SampleId {
  Gid writer{};
  std::int64_t sequence = 0;
  auto operator<=>(const SampleId&) const = default;
};

struct SampleInfo {
  SampleId id;
  SampleId related;                   // as sent along; zero where nothing was
  std::int64_t source_timestamp = 0;  // [ns] wall clock of the writer
  bool from_this_participant = false;
};

struct EndpointOptions {
  std::string dds_topic;                      // rt/...
  std::string dds_type;                       // pkg::msg::dds_::T_
  std::string type_hash;                      // RIHS01_..., "" if unknown
  const idl::TypeSupport* support = nullptr;  // nullptr: raw payloads
  Qos qos;
  std::string node;  // full name of the node it belongs to; "" for none
  // Of a reliable writer, while anything is unacknowledged: how soon a reader that missed something, or has
  // just come, can tell. Costs a small datagram each time.
  std::chrono::milliseconds heartbeat{100};
  static EndpointOptions of(const idl::TypeSupport& support, std::string dds_topic, const Qos& qos,
                            std::string node);
};

namespace detail {
class Participant;
}

// Thread-safe.
class Writer {
 public:
  // `on_matched` is called from a DDS thread whenever a reader came or went.
  static Expected<std::shared_ptr<Writer>> create(const std::shared_ptr<detail::Participant>& participant,
                                                  const EndpointOptions& options,
                                                  std::function<void()> on_matched = {});
  ~Writer();
  Writer(const Writer&) = delete;

  // Encodes and sends; readers of this process have it on return. False where DDS refused or encoding failed.
  bool write(const void* message);
  // As write(), with the identity that marks it as the reply to (or the request of) somebody. Fills *id, if
  // not null, with the identity the sample got.
  bool write_related(const void* message, const SampleId& related, SampleId* id);
  // Sends bytes as they are: 4 of encapsulation and the message. Where `related` is given it goes along as in
  // write_related().
  bool write_raw(std::span<const std::uint8_t> payload, const SampleId* related = nullptr);

  std::size_t matched() const;
  // Waits until at least `count` readers are matched. Returns whether they are.
  bool wait_for_matched(std::size_t count, std::chrono::nanoseconds timeout) const;
  bool matched_with(const Gid& reader) const;
  std::vector<Gid> matched_readers() const;
  // Waits until all reliable readers have everything written so far.
  bool wait_for_acknowledgments(std::chrono::nanoseconds timeout);
  const Gid& gid() const;

 private:
  struct Impl;
  explicit Writer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// Callbacks come from DDS threads, or from the writer's thread where both are in one process; never two at
// once.
class Reader {
 public:
  struct Callbacks {
    // A decoded message of options.support (own it).
    std::function<void(std::shared_ptr<void> message, const SampleInfo& info)> on_message;
    // Instead, where support is nullptr: the payload as received.
    std::function<void(std::vector<std::uint8_t> payload, const SampleInfo& info)> on_payload;
    // A sample was dropped; `why` is a static text.
    std::function<void(const char* why)> on_dropped;
    // The number of matched writers changed.
    std::function<void(std::size_t matched)> on_matched;
  };
  static Expected<std::shared_ptr<Reader>> create(const std::shared_ptr<detail::Participant>& participant,
                                                  const EndpointOptions& options, Callbacks callbacks);
  ~Reader();
  Reader(const Reader&) = delete;

  std::size_t matched() const;
  bool wait_for_matched(std::size_t count, std::chrono::nanoseconds timeout) const;
  bool matched_with(const Gid& writer) const;
  const Gid& gid() const;

 private:
  struct Impl;
  explicit Reader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::ros
