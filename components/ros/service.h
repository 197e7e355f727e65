// Services: a Server answers requests, a Client sends them. #include "std_srvs/srv/Trigger_service.h" and say
// Server<std_srvs::srv::Trigger>.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "components/ros/node.h"
#include "components/ros/service_base.h"

namespace goalnet::ros {

// Answers one request, at once or later, from the loop's thread. Copies answer the same request: only once.
template <class Service>
class Responder {
 public:
  Responder(std::weak_ptr<ServiceServerBase> server, const ReplyTo& reply_to)
      : server_(std::move(server)), reply_to_(reply_to) {}
  // Nothing happens if the server is gone.
  void send(typename Service::Response response) const {
    if (auto server = server_.lock()) {
      server->reply(reply_to_, std::make_shared<typename Service::Response>(std::move(response)));
    }
  }

 private:
  std::weak_ptr<ServiceServerBase> server_;
  ReplyTo reply_to_;
};

template <class Service>
ServiceTypes service_types() {
  return {&idl::type_support<typename Service::Request>(), &idl::type_support<typename Service::Response>()};
}

// Callbacks run in the node's loop and end with the server. Construction throws std::runtime_error as Node
// does.
template <class Service>
class Server {
 public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  using Callback = std::function<void(const Request& request, Response& response)>;
  using DeferredCallback =
      std::function<void(std::shared_ptr<const Request> request, Responder<Service> responder)>;

  Server(Node& node, const std::string& service, Callback callback, const Qos& qos = Qos::services())
      : Server(
            node, service,
            [call = std::move(callback)](std::shared_ptr<const Request> request,
                                         Responder<Service> responder) {
              Response response;
              call(*request, response);
              responder.send(std::move(response));
            },
            qos, 0) {}

  // For answers that take their time.
  static std::unique_ptr<Server> deferred(Node& node, const std::string& service, DeferredCallback callback,
                                          const Qos& qos = Qos::services()) {
    return std::unique_ptr<Server>(new Server(node, service, std::move(callback), qos, 0));
  }

  // Besides the callback: each request as it arrives, in a thread of DDS. For what cannot wait until the loop
  // is free.
  void set_glance(std::function<void(const Request&)> glance) {
    if (!glance) return base_->set_glance({});
    base_->set_glance(
        [call = std::move(glance)](const void* request) { call(*static_cast<const Request*>(request)); });
  }
  // Waits until all clients have the answers given so far.
  bool wait_for_acknowledgments(std::chrono::nanoseconds timeout) {
    return base_->wait_for_acknowledgments(timeout);
  }

  const std::string& name() const { return name_; }

 private:
  Server(Node& node, const std::string& service, DeferredCallback callback, const Qos& qos, int)
      : name_(node.resolve(service, RemapKind::kService)) {
    // The handler finds its own server through this slot: the base cannot exist before its handler.
    auto slot = std::make_shared<std::weak_ptr<ServiceServerBase>>();
    auto handler = [slot, call = std::move(callback)](std::shared_ptr<void> request,
                                                      const ReplyTo& reply_to) {
      call(std::static_pointer_cast<const Request>(std::move(request)), Responder<Service>(*slot, reply_to));
    };
    auto report = [&node, name = name_](const std::string& why) {
      node.log().warn("dropped a request to {}: {}", name, why);
    };
    base_ = std::make_shared<ServiceServerBase>(node.loop(), std::move(handler), std::move(report));
    *slot = base_;
    const auto opened =
        base_->open(node.context().participant(), name_, node.full_name(), service_types<Service>(), qos);
    if (!opened) throw std::runtime_error(opened.error().message);
  }

  std::string name_;
  std::shared_ptr<ServiceServerBase> base_;
};

// Used from the loop's thread. Destroying it forgets what waits.
template <class Service>
class Client {
 public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  using Callback = std::function<void(Expected<std::shared_ptr<Response>>)>;

  Client(Node& node, const std::string& service, const Qos& qos = Qos::services())
      : name_(node.resolve(service, RemapKind::kService)),
        base_(std::make_shared<ServiceClientBase>(node.loop())) {
    const auto opened =
        base_->open(node.context().participant(), name_, node.full_name(), service_types<Service>(), qos);
    if (!opened) throw std::runtime_error(opened.error().message);
  }

  // The callback comes exactly once from the loop: the response, kTimeLimit, or kComponentLost where the
  // servers that got the request have gone.
  void call(const Request& request, Callback callback,
            std::chrono::nanoseconds timeout = std::chrono::seconds(10)) {
    base_->call(&request, timeout, [call = std::move(callback)](Expected<std::shared_ptr<void>> response) {
      if (!response) {
        call(tl::unexpected(response.error()));
      } else {
        call(std::static_pointer_cast<Response>(std::move(*response)));
      }
    });
  }

  // Calls and runs the loop until the answer is there. Not from within a callback.
  Expected<Response> call_and_run(const Request& request,
                                  std::chrono::nanoseconds timeout = std::chrono::seconds(10)) {
    auto result = std::make_shared<std::optional<Expected<Response>>>();
    call(
        request,
        [result](Expected<std::shared_ptr<Response>> response) {
          if (response) {
            *result = **response;
          } else {
            *result = tl::unexpected(response.error());
          }
        },
        timeout);
    base_->loop().run_for(timeout + std::chrono::seconds(1), [&] { return result->has_value(); });
    if (!*result) return fail(Outcome::kCancelled, "the loop was stopped before " + name_ + " answered");
    return std::move(**result);
  }

  bool ready() const { return base_->ready(); }
  bool wait_for_service(std::chrono::nanoseconds timeout = std::chrono::seconds(5)) const {
    return base_->wait_for_service(timeout);
  }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::shared_ptr<ServiceClientBase> base_;
};

}  // namespace goalnet::ros
