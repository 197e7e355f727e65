// A ROS 2 node: names, publishers, subscriptions, timers, parameters, a clock and a log.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "components/core/outcome.h"
#include "components/ros/arguments.h"
#include "components/ros/clock.h"
#include "components/ros/context.h"
#include "components/ros/event_loop.h"
#include "components/ros/logger.h"
#include "components/ros/parameters.h"
#include "components/ros/publisher.h"
#include "components/ros/qos.h"
#include "components/ros/subscription.h"
#include "components/ros/timer.h"

namespace goalnet::ros {

struct NodeOptions {
  std::string name;
  std::string node_namespace = "/";
  Arguments arguments;        // remaps, parameters, levels; -r __node and __ns win over the two above
  bool rosout = true;         // write the log to /rosout too
  bool use_sim_time = false;  // default of the parameter use_sim_time
  bool services = true;       // offer parameter and, in Jazzy, type description services
  // Offer ~/get_logger_levels and ~/set_logger_levels. Only in Jazzy: Humble's tools do not know their types.
  bool logger_services = true;
};

// What a component's shell derives from, so that a launcher can hold any of them.
class Component {
 public:
  virtual ~Component() = default;
};

// Belongs to the thread of its event loop, which with the context must outlive it. Construction throws
// std::runtime_error, with a message for people, on bad names, bad parameter values and where DDS refuses; so
// do advertise() and subscribe(), because a component without its topics cannot live.
class Node {
 public:
  Node(Context& context, EventLoop& loop, NodeOptions options);
  // The same, as a value: for names and parameters that people typed.
  static Expected<std::unique_ptr<Node>> create(Context& context, EventLoop& loop, NodeOptions options);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  template <class Message>
  std::shared_ptr<Publisher<Message>> advertise(const std::string& topic, const Qos& qos = Qos::standard()) {
    const std::string name = resolve(topic);
    return std::make_shared<Publisher<Message>>(open_writer(name, idl::type_support<Message>(), qos), name);
  }

  // `callback` runs on the event loop, in order of arrival; the queue holds qos.depth messages. `arrival`, if
  // given, runs before it for each message, at once in the thread that delivers: it may only raise flags.
  template <class Message>
  std::shared_ptr<Subscription<Message>> subscribe(const std::string& topic, const Qos& qos,
                                                   std::function<void(const Message&)> callback,
                                                   SubscribeOptions options = {},
                                                   std::function<void(const Message&)> arrival = {}) {
    const std::string name = resolve(topic);
    const auto untyped = [](std::function<void(const Message&)> call) -> SubscriptionBase::Callback {
      if (!call) return {};
      return [call = std::move(call)](const void* message, const SampleInfo&) {
        call(*static_cast<const Message*>(message));
      };
    };
    return std::make_shared<Subscription<Message>>(
        open_subscription(name, idl::type_support<Message>(), qos, untyped(std::move(arrival)),
                          untyped(std::move(callback)), options),
        name);
  }

  // On the node's clock; the first call comes one period from now.
  std::shared_ptr<Timer> create_timer(std::chrono::nanoseconds period, std::function<void()> callback);

  // Declares a parameter and returns its value: the default, or what a file or -p says. Fails with
  // kInvalidRequest, naming the origin, if that has the wrong type or is out of range.
  template <class T>
  Expected<T> declare_parameter(const std::string& name, const T& default_value,
                                const ParameterDescriptor& descriptor = {}) {
    using Stored = typename ParameterTypeOf<T>::Type;
    auto value = parameters_.declare(name, ParameterValue(Stored(default_value)), descriptor);
    if (!value) return tl::unexpected(value.error());
    return static_cast<T>(std::get<Stored>(*value));
  }
  Expected<std::string> declare_parameter(const std::string& name, const char* default_value,
                                          const ParameterDescriptor& descriptor = {}) {
    return declare_parameter<std::string>(name, std::string(default_value), descriptor);
  }
  // Current value of a declared parameter of exactly this type.
  template <class T>
  T parameter(const std::string& name) const {
    const ParameterValue* value = parameters_.find(name);
    if (value == nullptr) throw std::logic_error("parameter '" + name + "' was never declared");
    return static_cast<T>(std::get<typename ParameterTypeOf<T>::Type>(*value));
  }
  Parameters& parameters() { return parameters_; }

  Clock& clock() { return clock_; }
  Time now() const { return clock_.now(); }
  Logger& log() { return *logger_; }

  const std::string& name() const { return name_; }
  const std::string& node_namespace() const { return namespace_; }
  const std::string& full_name() const { return full_name_; }
  Context& context() { return context_; }
  EventLoop& loop() { return loop_; }

  // The absolute name of a topic, a service or (kName) an action after expansion and remapping.
  std::string resolve(const std::string& name, RemapKind kind = RemapKind::kTopic) const;

  // For components/ros: services, actions and tools build on these.
  std::shared_ptr<Writer> open_writer(const std::string& topic, const idl::TypeSupport& support,
                                      const Qos& qos);
  std::shared_ptr<SubscriptionBase> open_subscription(const std::string& topic,
                                                      const idl::TypeSupport& support, const Qos& qos,
                                                      SubscriptionBase::Callback arrival,
                                                      SubscriptionBase::Callback callback,
                                                      SubscribeOptions options);

 private:
  struct Internals;  // endpoints that every node has: /rosout, /clock, parameter services
  void take_arguments(const Arguments& arguments);
  void open_rosout();
  void open_jazzy_services(bool loggers);
  void follow_simulated_time(bool use);

  Context& context_;
  EventLoop& loop_;
  std::string name_;
  std::string namespace_;
  std::string full_name_;
  std::vector<Remap> remaps_;  // expanded
  std::unique_ptr<Logger> logger_;
  Clock clock_;
  Parameters parameters_;
  std::unique_ptr<Internals> internals_;
};

}  // namespace goalnet::ros
