#include "components/ros/service_base.h"

#include <algorithm>

#include "components/ros/detail/cyclone_service.h"
#include "components/ros/detail/message_type.h"
#include "components/ros/detail/participant.h"
#include "components/ros/names.h"

namespace goalnet::ros {
namespace {

constexpr std::size_t kMostRequests = 1000;  // waiting in one server
constexpr std::size_t kMostReplies = 1000;   // waiting for their client's reader
constexpr auto kReplyPatience = std::chrono::seconds(10);
// A client that has just found us takes in nothing until a heartbeat tells it where to begin; meanwhile it
// keeps ten replies, those to others included. After 100 ms its own was among those that it dropped.
constexpr auto kHeartbeat = std::chrono::milliseconds(20);
constexpr auto kAcquaintance = std::chrono::milliseconds(100);  // five heartbeats: machines are busy
constexpr auto kLookAgain = std::chrono::milliseconds(5);
constexpr auto kTimeoutResolution = std::chrono::milliseconds(20);
// What a server said last may still be on its way to the loop when it is known to be gone.
constexpr auto kLastWords = std::chrono::milliseconds(500);

bool is_reader(const Gid& gid) { return (gid[15] & 0x3f) == 0x04 || (gid[15] & 0x3f) == 0x07; }

EndpointOptions request_options(ServiceTypes types, const std::string& service, const Qos& qos,
                                const std::string& node) {
  auto options = EndpointOptions::of(*types.request, service_request_to_dds(service), qos, node);
  options.heartbeat = kHeartbeat;
  return options;
}

EndpointOptions reply_options(ServiceTypes types, const std::string& service, const Qos& qos,
                              const std::string& node) {
  auto options = EndpointOptions::of(*types.response, service_reply_to_dds(service), qos, node);
  options.heartbeat = kHeartbeat;
  return options;
}

// Readers get the bytes: what they mean depends on who sent them.
EndpointOptions raw(EndpointOptions options) {
  options.support = nullptr;
  return options;
}

struct Decoded {
  std::shared_ptr<void> message;
  const char* fault = nullptr;
};

Decoded decode(const idl::TypeSupport& support, std::span<const std::uint8_t> payload) {
  Decoded out{std::shared_ptr<void>(support.create(), support.destroy)};
  out.fault = detail::decode(support, detail::layout_of(support), payload, out.message.get());
  return out;
}

std::vector<std::uint8_t> encode_for_cyclone(const idl::TypeSupport& support, const void* message,
                                             const detail::CycloneHeader& header) {
  return detail::with_cyclone_header(detail::encode(support, message), header);
}

}  // namespace

ServiceServerBase::ServiceServerBase(EventLoop& loop, Handler handler, DropReport report)
    : loop_(loop), handler_(std::move(handler)), report_(std::move(report)) {}

Expected<void> ServiceServerBase::open(const std::shared_ptr<detail::Participant>& participant,
                                       const std::string& service, const std::string& node,
                                       ServiceTypes types, const Qos& qos) {
  types_ = types;
  participant_ = participant;
  Reader::Callbacks callbacks;
  callbacks.on_payload = [this](std::vector<std::uint8_t> payload, const SampleInfo& info) {
    on_request(std::move(payload), info);
  };
  callbacks.on_dropped = [this](const char* why) { on_dropped(why); };
  // The reader first, as rmw does: node lists then show the endpoints in the same order.
  auto reader =
      Reader::create(participant, raw(request_options(types, service, qos, node)), std::move(callbacks));
  if (!reader) return tl::unexpected(reader.error());
  auto writer =
      Writer::create(participant, reply_options(types, service, qos, node), [weak = weak_from_this(), this] {
        loop_.post([weak] {
          if (auto self = weak.lock()) self->flush_waiting();
        });
      });
  if (!writer) return tl::unexpected(writer.error());
  requests_reader_ = std::move(*reader);
  replies_ = std::move(*writer);
  return {};
}

void ServiceServerBase::on_request(std::vector<std::uint8_t> payload, const SampleInfo& info) {
  ReplyTo reply_to{info.id};
  if (detail::from_cyclone(info.id.writer)) {
    const auto header = detail::take_cyclone_header(payload);
    if (!header) return on_dropped("it is too short for the header that rmw_cyclonedds sends");
    reply_to.request.sequence = header->sequence;
    reply_to.cyclone_client = header->client;
  } else if (info.related.writer != Gid{}) {
    reply_to.request.writer = info.related.writer;
  }
  auto [request, fault] = decode(*types_.request, payload);
  if (fault != nullptr) return on_dropped(fault);
  Glance glance;
  {
    std::lock_guard lock(mutex_);
    if (requests_.size() >= kMostRequests) return;  // the client times out, as with any overloaded server
    requests_.push_back({request, reply_to});
    glance = glance_;
  }
  loop_.post([weak = weak_from_this()] {
    if (auto self = weak.lock()) self->handle_one();
  });
  if (glance) glance(request.get());
}

void ServiceServerBase::on_dropped(const std::string& why) {
  {
    std::lock_guard lock(mutex_);
    if (++dropped_ != 1) return;
  }
  loop_.post([weak = weak_from_this(), why] {
    if (auto self = weak.lock()) self->report_(why);
  });
}

void ServiceServerBase::handle_one() {
  Entry entry;
  {
    std::lock_guard lock(mutex_);
    if (requests_.empty()) return;
    entry = std::move(requests_.front());
    requests_.pop_front();
  }
  handler_(std::move(entry.request), entry.reply_to);
}

bool ServiceServerBase::can_be_answered(const ReplyTo& reply_to) {
  const Gid& client = reply_to.request.writer;
  if (detail::from_cyclone(client)) return cyclone_can_be_answered(client);
  return !is_reader(client) || replies_->matched_with(client);
}

// Where our writer has earlier samples, Fast DDS puts a gap and a heartbeat in front of the first one that it
// sends to a new reader. Cyclone DDS begins behind what the first heartbeat names, which is that very sample.
// A client that asks us knows our writer; a heartbeat that it gets from then on and before the reply, which
// names nothing new, lets it begin in time. They come periodically until it has answered one.
bool ServiceServerBase::cyclone_can_be_answered(const Gid& client) {
  const auto now = std::chrono::steady_clock::now();
  auto met = met_.find(client);
  if (met == met_.end()) {
    const bool matched = participant_->cyclone_clients().can_be_answered(
        client, [this](const Gid& reader) { return replies_->matched_with(reader); });
    if (!matched) return false;
    if (met_.size() >= kMostRequests) met_.clear();
    met = met_.emplace(client, has_replied_ ? now + kAcquaintance : now).first;
  }
  return now >= met->second;
}

void ServiceServerBase::send(const ReplyTo& reply_to, const void* response) {
  has_replied_ = true;
  if (!detail::from_cyclone(reply_to.request.writer)) {
    replies_->write_related(response, reply_to.request, nullptr);
    return;
  }
  // With the related identity too: clients of rmw_fastrtps hear it, and know by it that it is not for them.
  replies_->write_raw(
      encode_for_cyclone(*types_.response, response, {reply_to.cyclone_client, reply_to.request.sequence}),
      &reply_to.request);
}

void ServiceServerBase::reply(const ReplyTo& reply_to, std::shared_ptr<const void> response) {
  if (can_be_answered(reply_to)) return send(reply_to, response.get());
  if (waiting_.size() >= kMostReplies) waiting_.pop_front();
  waiting_.push_back({reply_to, std::move(response), std::chrono::steady_clock::now()});
  flush_waiting();  // it may have matched in between
}

void ServiceServerBase::flush_waiting() {
  const auto now = std::chrono::steady_clock::now();
  std::erase_if(waiting_, [&](const Waiting& waiting) {
    if (!can_be_answered(waiting.reply_to)) return now - waiting.since > kReplyPatience;
    send(waiting.reply_to, waiting.response.get());
    return true;
  });
  if (waiting_.empty()) {
    if (look_again_) look_again_->cancel();
  } else if (look_again_) {
    look_again_->reset();
  } else {
    look_again_ = Timer::create(loop_, wall_, kLookAgain, [this] { flush_waiting(); });
  }
}

ServiceClientBase::ServiceClientBase(EventLoop& loop) : loop_(loop) {}
ServiceClientBase::~ServiceClientBase() = default;

Expected<void> ServiceClientBase::open(const std::shared_ptr<detail::Participant>& participant,
                                       const std::string& service, const std::string& node,
                                       ServiceTypes types, const Qos& qos) {
  service_ = service;
  types_ = types;
  Reader::Callbacks callbacks;
  callbacks.on_payload = [this](std::vector<std::uint8_t> payload, const SampleInfo& info) {
    on_reply(std::move(payload), info);
  };
  auto reader =
      Reader::create(participant, raw(reply_options(types, service, qos, node)), std::move(callbacks));
  if (!reader) return tl::unexpected(reader.error());
  auto writer = Writer::create(participant, request_options(types, service, qos, node));
  if (!writer) return tl::unexpected(writer.error());
  requests_ = std::move(*writer);
  replies_ = std::move(*reader);
  watch_ = Timer::create(loop_, wall_, kTimeoutResolution, [this] { drop_hopeless(); });
  watch_->cancel();
  return {};
}

bool ServiceClientBase::send(const void* request, SampleId* id) {
  const auto servers = requests_->matched_readers();
  if (servers.empty() || !std::all_of(servers.begin(), servers.end(), detail::from_cyclone))
    return requests_->write_related(request, {replies_->gid(), kUnknownSequence}, id);
  // Counts from where no sequence number of a writer gets to, so that both kinds can be told apart.
  constexpr std::int64_t kFirst = std::int64_t{1} << 62;
  id->sequence = kFirst + ++cyclone_sequence_;
  return requests_->write_raw(encode_for_cyclone(
      *types_.request, request, {detail::cyclone_client_number(requests_->gid()), id->sequence}));
}

void ServiceClientBase::call(const void* request, std::chrono::nanoseconds timeout, Callback callback) {
  SampleId id;
  if (!send(request, &id)) {
    loop_.post([callback = std::move(callback), name = service_] {
      callback(fail(Outcome::kInternal, "the request to " + name + " could not be sent"));
    });
    return;
  }
  pending_[id.sequence] = {std::move(callback), std::chrono::steady_clock::now() + timeout,
                           requests_->matched_readers()};
  if (pending_.size() == 1) watch_->reset();
}

void ServiceClientBase::on_reply(std::vector<std::uint8_t> payload, const SampleInfo& info) {
  // All clients of a service get all replies; only ours bear our name.
  if (!replies_) return;
  std::int64_t sequence = info.related.sequence;
  if (detail::from_cyclone(info.id.writer)) {
    const auto header = detail::take_cyclone_header(payload);
    if (!header || header->client != detail::cyclone_client_number(requests_->gid())) return;
    sequence = header->sequence;
  } else if (info.related.writer != replies_->gid() && info.related.writer != requests_->gid()) {
    return;
  }
  auto [response, fault] = decode(*types_.response, payload);
  if (fault != nullptr) return;
  loop_.post([weak = weak_from_this(), response = std::move(response), sequence]() mutable {
    if (auto self = weak.lock()) self->finish(sequence, std::move(response));
  });
}

void ServiceClientBase::finish(std::int64_t sequence, std::shared_ptr<void> response) {
  const auto found = pending_.find(sequence);
  if (found == pending_.end()) return;  // too late, or answered before
  const Callback callback = std::move(found->second.callback);
  pending_.erase(found);
  if (pending_.empty()) watch_->cancel();
  callback(std::move(response));
}

bool ServiceClientBase::servers_gone(Pending& pending, std::chrono::steady_clock::time_point now) const {
  const bool gone = !pending.servers.empty() &&
                    std::none_of(pending.servers.begin(), pending.servers.end(),
                                 [this](const Gid& server) { return requests_->matched_with(server); });
  if (!gone) {
    pending.gone_since.reset();
    return false;
  }
  if (!pending.gone_since) pending.gone_since = now;
  return now - *pending.gone_since > kLastWords;
}

void ServiceClientBase::drop_hopeless() {
  const auto now = std::chrono::steady_clock::now();
  std::vector<std::pair<Callback, Error>> hopeless;
  for (auto it = pending_.begin(); it != pending_.end();) {
    const bool late = it->second.until <= now;
    if (!late && !servers_gone(it->second, now)) {
      ++it;
      continue;
    }
    hopeless.emplace_back(
        std::move(it->second.callback),
        late ? Error{Outcome::kTimeLimit, "no answer from the service " + service_}
             : Error{Outcome::kComponentLost, "the service " + service_ + " went away before it answered"});
    it = pending_.erase(it);
  }
  if (pending_.empty()) watch_->cancel();
  for (auto& [callback, error] : hopeless) callback(tl::unexpected<Error>(std::move(error)));
}

bool ServiceClientBase::ready() const { return requests_->matched() > 0 && replies_->matched() > 0; }

bool ServiceClientBase::wait_for_service(std::chrono::nanoseconds timeout) const {
  const auto end = std::chrono::steady_clock::now() + timeout;
  return requests_->wait_for_matched(1, timeout) &&
         replies_->wait_for_matched(
             1, std::max(end - std::chrono::steady_clock::now(), std::chrono::nanoseconds(0)));
}

}  // namespace goalnet::ros
