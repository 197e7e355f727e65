#include "components/ros/service_base.h"

#include <thread>

#include "components/ros/names.h"

namespace goalnet::ros {
namespace {

constexpr std::size_t kMostRequests = 1000;  // waiting in one server
constexpr std::size_t kMostReplies = 1000;   // waiting for their client's reader
constexpr auto kReplyPatience = std::chrono::seconds(2);
constexpr auto kTimeoutResolution = std::chrono::milliseconds(20);

// rmw_cyclonedds puts 16 bytes in front of requests and replies. Its participants bear Eclipse's vendor id.
bool from_cyclone(const Gid& gid) { return gid[0] == 0x01 && gid[1] == 0x10; }

bool is_reader(const Gid& gid) { return (gid[15] & 0x3f) == 0x04 || (gid[15] & 0x3f) == 0x07; }

EndpointOptions request_options(ServiceTypes types, const std::string& service, const Qos& qos,
                                const std::string& node) {
  return EndpointOptions::of(*types.request, service_request_to_dds(service), qos, node);
}

EndpointOptions reply_options(ServiceTypes types, const std::string& service, const Qos& qos,
                              const std::string& node) {
  return EndpointOptions::of(*types.response, service_reply_to_dds(service), qos, node);
}

}  // namespace

ServiceServerBase::ServiceServerBase(EventLoop& loop, Handler handler, DropReport report)
    : loop_(loop), handler_(std::move(handler)), report_(std::move(report)) {}

Expected<void> ServiceServerBase::open(const std::shared_ptr<detail::Participant>& participant,
                                       const std::string& service, const std::string& node,
                                       ServiceTypes types, const Qos& qos) {
  Reader::Callbacks callbacks;
  callbacks.on_message = [this](std::shared_ptr<void> request, const SampleInfo& info) {
    on_request(std::move(request), info);
  };
  callbacks.on_dropped = [this](const char* why) { on_dropped(why); };
  // The reader first, as rmw does: node lists then show the endpoints in the same order.
  auto reader = Reader::create(participant, request_options(types, service, qos, node), std::move(callbacks));
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

void ServiceServerBase::on_request(std::shared_ptr<void> request, const SampleInfo& info) {
  if (from_cyclone(info.id.writer)) {
    on_dropped(
        "it comes from rmw_cyclonedds, whose service format differs; use rmw_fastrtps_cpp on both sides");
    return;
  }
  SampleId reply_to = info.id;
  if (info.related.writer != Gid{}) reply_to.writer = info.related.writer;
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

void ServiceServerBase::reply(const SampleId& reply_to, std::shared_ptr<const void> response) {
  if (!is_reader(reply_to.writer) || replies_->matched_with(reply_to.writer)) {
    replies_->write_related(response.get(), reply_to, nullptr);
    return;
  }
  if (waiting_.size() >= kMostReplies) waiting_.pop_front();
  waiting_.push_back({reply_to, std::move(response), std::chrono::steady_clock::now() + kReplyPatience});
  flush_waiting();  // it may have matched in between
}

void ServiceServerBase::flush_waiting() {
  const auto now = std::chrono::steady_clock::now();
  std::erase_if(waiting_, [&](const Waiting& waiting) {
    if (!replies_->matched_with(waiting.reply_to.writer)) return waiting.until < now;
    replies_->write_related(waiting.response.get(), waiting.reply_to, nullptr);
    return true;
  });
}

ServiceClientBase::ServiceClientBase(EventLoop& loop) : loop_(loop) {}
ServiceClientBase::~ServiceClientBase() = default;

Expected<void> ServiceClientBase::open(const std::shared_ptr<detail::Participant>& participant,
                                       const std::string& service, const std::string& node,
                                       ServiceTypes types, const Qos& qos) {
  service_ = service;
  Reader::Callbacks callbacks;
  callbacks.on_message = [this](std::shared_ptr<void> response, const SampleInfo& info) {
    on_reply(std::move(response), info);
  };
  auto reader = Reader::create(participant, reply_options(types, service, qos, node), std::move(callbacks));
  if (!reader) return tl::unexpected(reader.error());
  auto writer = Writer::create(participant, request_options(types, service, qos, node));
  if (!writer) return tl::unexpected(writer.error());
  requests_ = std::move(*writer);
  replies_ = std::move(*reader);
  watch_ = Timer::create(loop_, wall_, kTimeoutResolution, [this] { drop_late(); });
  watch_->cancel();
  return {};
}

void ServiceClientBase::call(const void* request, std::chrono::nanoseconds timeout, Callback callback) {
  SampleId id;
  if (!requests_->write_related(request, {replies_->gid(), kUnknownSequence}, &id)) {
    loop_.post([callback = std::move(callback), name = service_] {
      callback(fail(Outcome::kInternal, "the request to " + name + " could not be sent"));
    });
    return;
  }
  pending_[id.sequence] = {std::move(callback), std::chrono::steady_clock::now() + timeout};
  if (pending_.size() == 1) watch_->reset();
}

void ServiceClientBase::on_reply(std::shared_ptr<void> response, const SampleInfo& info) {
  // All clients of a service get all replies; only ours bear our name.
  if (from_cyclone(info.id.writer)) return;
  const Gid& asked = info.related.writer;
  if (!replies_ || (asked != replies_->gid() && asked != requests_->gid())) return;
  loop_.post(
      [weak = weak_from_this(), response = std::move(response), sequence = info.related.sequence]() mutable {
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

void ServiceClientBase::drop_late() {
  const auto now = std::chrono::steady_clock::now();
  std::vector<Callback> late;
  for (auto it = pending_.begin(); it != pending_.end();) {
    if (it->second.until > now) {
      ++it;
      continue;
    }
    late.push_back(std::move(it->second.callback));
    it = pending_.erase(it);
  }
  if (pending_.empty()) watch_->cancel();
  for (const Callback& callback : late)
    callback(fail(Outcome::kTimeLimit, "no answer from the service " + service_));
}

bool ServiceClientBase::ready() const { return requests_->matched() > 0 && replies_->matched() > 0; }

bool ServiceClientBase::wait_for_service(std::chrono::nanoseconds timeout) const {
  const auto end = std::chrono::steady_clock::now() + timeout;
  return requests_->wait_for_matched(1, timeout) &&
         replies_->wait_for_matched(
             1, std::max(end - std::chrono::steady_clock::now(), std::chrono::nanoseconds(0)));
}

}  // namespace goalnet::ros
