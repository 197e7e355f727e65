// Services without the types: requests on rq/NAMERequest, replies on rr/NAMEReply, joined by the identity of
// the request's sample as rmw_fastrtps does it, or by a header as rmw_cyclonedds does it, whichever the other
// side speaks (docs/design/072). service.h adds the types.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "components/ros/clock.h"
#include "components/ros/endpoint.h"
#include "components/ros/event_loop.h"
#include "components/ros/timer.h"

namespace goalnet::ros {

struct ServiceTypes {
  const idl::TypeSupport* request;
  const idl::TypeSupport* response;
};

// Where a reply goes: the identity that it is related to, and the number of the client where that is one of
// rmw_cyclonedds; request.sequence is then the client's own count.
struct ReplyTo {
  SampleId request;
  std::uint64_t cyclone_client = 0;
};

// Everything but creation happens in the event loop's thread.
class ServiceServerBase : public std::enable_shared_from_this<ServiceServerBase> {
 public:
  // Gets a request (own it) and where its reply must go.
  using Handler = std::function<void(std::shared_ptr<void> request, const ReplyTo& reply_to)>;
  using DropReport = std::function<void(const std::string& why)>;

  ServiceServerBase(EventLoop& loop, Handler handler, DropReport report);
  Expected<void> open(const std::shared_ptr<detail::Participant>& participant, const std::string& service,
                      const std::string& node, ServiceTypes types, const Qos& qos);

  // Answers. A client whose reply reader is not matched yet gets its answer once it is, within ten seconds.
  // `response` is kept until then.
  void reply(const ReplyTo& reply_to, std::shared_ptr<const void> response);

  // To see a request at once, in the thread that delivers it and after it was queued; the handler's turn
  // comes as ever. What is called must not wait: this participant receives nothing else meanwhile.
  using Glance = std::function<void(const void* request)>;
  void set_glance(Glance glance) {
    std::lock_guard lock(mutex_);
    glance_ = std::move(glance);
  }
  bool wait_for_acknowledgments(std::chrono::nanoseconds timeout) {
    return replies_->wait_for_acknowledgments(timeout);
  }

  // As the reader calls it; public for tests.
  void on_request(std::vector<std::uint8_t> payload, const SampleInfo& info);

 private:
  struct Entry {
    std::shared_ptr<void> request;
    ReplyTo reply_to;
  };
  struct Waiting {
    ReplyTo reply_to;
    std::shared_ptr<const void> response;
    std::chrono::steady_clock::time_point since;
  };
  void on_dropped(const std::string& why);
  void handle_one();
  bool can_be_answered(const ReplyTo& reply_to);
  bool cyclone_can_be_answered(const Gid& client);
  void send(const ReplyTo& reply_to, const void* response);
  void flush_waiting();

  EventLoop& loop_;
  Handler handler_;
  Glance glance_;
  DropReport report_;
  ServiceTypes types_{};
  std::shared_ptr<detail::Participant> participant_;
  std::mutex mutex_;  // guards glance_, requests_ and dropped_
  std::deque<Entry> requests_;
  std::uint64_t dropped_ = 0;
  std::deque<Waiting> waiting_;
  bool has_replied_ = false;
  // Clients of rmw_cyclonedds whose reply readers were matched, and from when on they may be answered.
  std::map<Gid, std::chrono::steady_clock::time_point> met_;
  Clock wall_;
  std::shared_ptr<Timer> look_again_;  // active while anything is waiting
  std::shared_ptr<Writer> replies_;
  std::shared_ptr<Reader> requests_reader_;
};

// Used from the event loop's thread.
class ServiceClientBase : public std::enable_shared_from_this<ServiceClientBase> {
 public:
  // Gets the response (own it), or an error where no answer came: kTimeLimit, or kComponentLost soon after
  // every server that got the request has gone. One that was started again in its place knows nothing of it.
  using Callback = std::function<void(Expected<std::shared_ptr<void>>)>;

  explicit ServiceClientBase(EventLoop& loop);
  ~ServiceClientBase();
  Expected<void> open(const std::shared_ptr<detail::Participant>& participant, const std::string& service,
                      const std::string& node, ServiceTypes types, const Qos& qos);

  // Sends; the callback comes exactly once, later, from the loop.
  void call(const void* request, std::chrono::nanoseconds timeout, Callback callback);
  // Forgets all calls that wait: their callbacks never come.
  void cancel_all() { pending_.clear(); }

  bool ready() const;
  bool wait_for_service(std::chrono::nanoseconds timeout) const;
  EventLoop& loop() { return loop_; }

 private:
  struct Pending {
    Callback callback;
    std::chrono::steady_clock::time_point until;
    std::vector<Gid> servers;  // who got the request; empty: nobody was known
    std::optional<std::chrono::steady_clock::time_point> gone_since = {};
  };
  bool servers_gone(Pending& pending, std::chrono::steady_clock::time_point now) const;
  void on_reply(std::vector<std::uint8_t> payload, const SampleInfo& info);
  bool send(const void* request, SampleId* id);
  void finish(std::int64_t sequence, std::shared_ptr<void> response);
  void drop_hopeless();

  EventLoop& loop_;
  Clock wall_;
  std::string service_;
  ServiceTypes types_{};
  std::map<std::int64_t, Pending> pending_;  // by sequence number of the request
  std::int64_t cyclone_sequence_ = 0;        // of the last request in rmw_cyclonedds's format
  std::shared_ptr<Timer> watch_;             // active while anything is pending
  std::shared_ptr<Writer> requests_;
  std::shared_ptr<Reader> replies_;
};

}  // namespace goalnet::ros
