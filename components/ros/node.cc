#include "components/ros/node.h"

#include <algorithm>

#include "components/ros/detail/participant.h"
#include "components/ros/names.h"
#include "components/ros/node_services.h"
#include "components/ros/parameter_file.h"
#include "rcl_interfaces/msg/Log.h"
#include "rosgraph_msgs/msg/Clock.h"

namespace goalnet::ros {
namespace {

template <class T>
T value_or_throw(Expected<T> expected) {
  if (!expected) throw std::runtime_error(expected.error().message);
  return std::move(*expected);
}

rcl_interfaces::msg::Log to_msg(const LogRecord& record, Time now) {
  rcl_interfaces::msg::Log message;
  message.stamp(now.to_msg());
  message.level(static_cast<std::uint8_t>(record.level));
  message.name(record.name);
  message.msg(record.text);
  message.file(record.where.file_name());
  message.function(record.where.function_name());
  message.line(record.where.line());
  return message;
}

}  // namespace

struct Node::Internals {
  std::shared_ptr<Publisher<rcl_interfaces::msg::Log>> rosout;
  std::shared_ptr<Subscription<rosgraph_msgs::msg::Clock>> clock, own_clock;
  bool own_clock_heard = false;
  std::unique_ptr<NodeServices> services;
};

Node::Node(Context& context, EventLoop& loop, NodeOptions options)
    : context_(context), loop_(loop), internals_(std::make_unique<Internals>()) {
  name_ = options.arguments.node_name(options.name).value_or(options.name);
  const auto name_ok = check_node_name(name_);
  if (!name_ok) throw std::runtime_error(name_ok.error().message);
  namespace_ = value_or_throw(
      normalize_namespace(options.arguments.node_namespace(name_).value_or(options.node_namespace)));
  full_name_ = (namespace_ == "/" ? "" : namespace_) + "/" + name_;
  logger_ = std::make_unique<Logger>(logger_name(namespace_, name_));
  take_arguments(options.arguments);
  context_.participant()->add_node(namespace_, name_);
  try {
    if (options.rosout && options.arguments.rosout) open_rosout();
    if (options.services) internals_->services = std::make_unique<NodeServices>(*this);
    const bool simulated = value_or_throw(declare_parameter("use_sim_time", options.use_sim_time));
    if (context_.distro() == Distro::kJazzy) open_jazzy_services(options.logger_services);
    follow_simulated_time(simulated);
    parameters_.add_observer([this](const ParameterChange& change) {
      for (const Parameter& parameter : change.changed) {
        if (parameter.name == "use_sim_time") follow_simulated_time(std::get<bool>(parameter.value));
      }
    });
  } catch (...) {
    context_.participant()->remove_node(full_name_);
    throw;
  }
}

Expected<std::unique_ptr<Node>> Node::create(Context& context, EventLoop& loop, NodeOptions options) {
  try {
    return std::make_unique<Node>(context, loop, std::move(options));
  } catch (const std::runtime_error& error) {
    return fail(Outcome::kInvalidRequest, error.what());
  }
}

Node::~Node() {
  logger_->set_sink({});
  internals_.reset();
  context_.participant()->remove_node(full_name_);
}

void Node::take_arguments(const Arguments& arguments) {
  for (const Remap& remap : arguments.remaps) {
    if (remap.kind == RemapKind::kNodeName || remap.kind == RemapKind::kNamespace) continue;
    if (!remap.node.empty() && !matches_node(remap.node, full_name_) && remap.node != name_) continue;
    remaps_.push_back({"", remap.kind, value_or_throw(expand_name(remap.from, namespace_, name_)),
                       value_or_throw(expand_name(remap.to, namespace_, name_))});
  }
  for (const ParameterOverride& parameter : arguments.parameters) {
    // -p NODE:NAME:=VALUE names the node without its namespace, as remapping rules do.
    const bool by_name = parameter.origin == "-p" && parameter.node == name_;
    if (!by_name && !matches_node(parameter.node, full_name_)) continue;
    parameters_.set_override(parameter.name, parameter.value, parameter.origin);
  }
  if (const auto level = arguments.level_of(logger_->name())) logger_->set_level(*level);
  logger_->set_console(arguments.console);
}

void Node::open_rosout() {
  internals_->rosout = advertise<rcl_interfaces::msg::Log>("/rosout", Qos::rosout());
  logger_->set_sink(
      [this](const LogRecord& record) { internals_->rosout->publish(to_msg(record, clock_.now())); });
}

void Node::open_jazzy_services(bool loggers) {
  ParameterDescriptor descriptor;  // word for word as in ROS 2
  descriptor.description = "If enabled, start the ~/get_type_description service.";
  descriptor.read_only = true;
  const bool describe = value_or_throw(declare_parameter("start_type_description_service", true, descriptor));
  if (internals_->services && describe) internals_->services->open_type_description();
  if (internals_->services && loggers) internals_->services->open_loggers();
}

void Node::follow_simulated_time(bool use) {
  clock_.use_simulated(use);
  internals_->clock.reset();
  internals_->own_clock.reset();
  if (!use) return;
  using Message = rosgraph_msgs::msg::Clock;
  internals_->clock = subscribe<Message>("/clock", Qos::clock(), [this](const Message& message) {
    if (!internals_->own_clock_heard) clock_.set_simulated(Time(message.clock()));
  });
  if (namespace_ == "/") return;
  // Two robots on one network have a simulator each: the time of our own namespace, once heard, is the one
  // that counts.
  internals_->own_clock = subscribe<Message>("clock", Qos::clock(), [this](const Message& message) {
    internals_->own_clock_heard = true;
    clock_.set_simulated(Time(message.clock()));
  });
}

std::string Node::resolve(const std::string& name, RemapKind kind) const {
  const std::string full = value_or_throw(expand_name(name, namespace_, name_));
  for (const Remap& remap : remaps_) {
    if (remap.from == full && (remap.kind == RemapKind::kName || remap.kind == kind)) return remap.to;
  }
  return full;
}

std::shared_ptr<Writer> Node::open_writer(const std::string& topic, const idl::TypeSupport& support,
                                          const Qos& qos) {
  return value_or_throw(Writer::create(context_.participant(),
                                       EndpointOptions::of(support, topic_to_dds(topic), qos, full_name_)));
}

std::shared_ptr<SubscriptionBase> Node::open_subscription(const std::string& topic,
                                                          const idl::TypeSupport& support, const Qos& qos,
                                                          SubscriptionBase::Callback arrival,
                                                          SubscriptionBase::Callback callback,
                                                          SubscribeOptions options) {
  auto report = [this, topic, name = std::string(support.ros_name)](const char* why) {
    log().warn("dropped a malformed message on {} ({}): {}", topic, name, why);
  };
  auto base = std::make_shared<SubscriptionBase>(
      loop_, qos.keep_all ? 10'000 : std::max<std::uint32_t>(qos.depth, 1), options.immediate,
      std::move(arrival), std::move(callback), std::move(report));
  const auto opened =
      base->open(context_.participant(), EndpointOptions::of(support, topic_to_dds(topic), qos, full_name_));
  if (!opened) throw std::runtime_error(opened.error().message);
  return base;
}

std::shared_ptr<Timer> Node::create_timer(std::chrono::nanoseconds period, std::function<void()> callback) {
  return Timer::create(loop_, clock_, period, std::move(callback));
}

}  // namespace goalnet::ros
