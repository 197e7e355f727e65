#include "components/ros/node_services.h"

#include <algorithm>
#include <set>

#include "components/ros/parameter_messages.h"
#include "components/ros/service.h"
#include "components/ros/type_messages.h"
#include "rcl_interfaces/msg/ParameterEvent.h"
#include "rcl_interfaces/srv/DescribeParameters_service.h"
#include "rcl_interfaces/srv/GetLoggerLevels_service.h"
#include "rcl_interfaces/srv/GetParameterTypes_service.h"
#include "rcl_interfaces/srv/GetParameters_service.h"
#include "rcl_interfaces/srv/ListParameters_service.h"
#include "rcl_interfaces/srv/SetLoggerLevels_service.h"
#include "rcl_interfaces/srv/SetParametersAtomically_service.h"
#include "rcl_interfaces/srv/SetParameters_service.h"
#include "type_description_interfaces/srv/GetTypeDescription_service.h"

namespace goalnet::ros {
namespace {

namespace srv = rcl_interfaces::srv;

// Names below `prefixes` (all, if there are none), at most `depth` dots below them (0: any depth).
void list(const Parameters& parameters, const srv::ListParameters_Request& request,
          rcl_interfaces::msg::ListParametersResult& result) {
  std::set<std::string> prefixes;
  const auto deep_enough = [&](std::string_view below) {
    return request.depth() == 0 ||
           static_cast<std::uint64_t>(std::count(below.begin(), below.end(), '.')) < request.depth();
  };
  for (const std::string& name : parameters.names()) {
    bool listed = request.prefixes().empty() && deep_enough(name);
    for (const std::string& prefix : request.prefixes()) {
      listed =
          listed || name == prefix ||
          (name.starts_with(prefix + ".") && deep_enough(std::string_view(name).substr(prefix.size() + 1)));
    }
    if (!listed) continue;
    result.names().push_back(name);
    if (const auto dot = name.rfind('.'); dot != std::string::npos) prefixes.insert(name.substr(0, dot));
  }
  result.prefixes().assign(prefixes.begin(), prefixes.end());
}

// rclcpp and rclpy answer with nothing at all where one of the names is unknown: `ros2 param get` then says
// that the parameter is not set, and fails.
bool all_declared(const Parameters& parameters, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(), [&](const auto& name) { return parameters.has(name); });
}

rcl_interfaces::msg::SetParametersResult result_of(const Expected<void>& outcome) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful(outcome.has_value());
  if (!outcome) result.reason(outcome.error().message);
  return result;
}

Expected<std::vector<Parameter>> from_messages(const std::vector<rcl_interfaces::msg::Parameter>& messages) {
  std::vector<Parameter> parameters;
  for (const auto& message : messages) {
    auto value = from_message(message.value());
    if (!value) return tl::unexpected(value.error());
    parameters.push_back({message.name(), std::move(*value)});
  }
  return parameters;
}

Expected<void> set(Parameters& parameters, const std::vector<rcl_interfaces::msg::Parameter>& messages) {
  auto values = from_messages(messages);
  if (!values) return tl::unexpected(values.error());
  return parameters.set(*values);
}

}  // namespace

struct NodeServices::Impl {
  Node& node;
  std::shared_ptr<Publisher<rcl_interfaces::msg::ParameterEvent>> events;
  std::unique_ptr<Server<srv::DescribeParameters>> describe;
  std::unique_ptr<Server<srv::GetParameters>> get;
  std::unique_ptr<Server<srv::GetParameterTypes>> get_types;
  std::unique_ptr<Server<srv::ListParameters>> list_names;
  std::unique_ptr<Server<srv::SetParameters>> set_each;
  std::unique_ptr<Server<srv::SetParametersAtomically>> set_all;
  std::unique_ptr<Server<type_description_interfaces::srv::GetTypeDescription>> describe_type;
  std::unique_ptr<Server<srv::GetLoggerLevels>> get_levels;
  std::unique_ptr<Server<srv::SetLoggerLevels>> set_levels;

  explicit Impl(Node& n) : node(n) {}
  void open_parameters();
  void open_loggers();
  void publish(const ParameterChange& change);
};

void NodeServices::Impl::publish(const ParameterChange& change) {
  rcl_interfaces::msg::ParameterEvent event;
  event.stamp(node.now().to_msg());
  event.node(node.full_name());
  for (const Parameter& one : change.added) event.new_parameters().push_back(to_message(one));
  for (const Parameter& one : change.changed) event.changed_parameters().push_back(to_message(one));
  events->publish(event);
}

void NodeServices::Impl::open_parameters() {
  // In rclcpp's and rclpy's order, so that node lists look alike.
  Parameters& parameters = node.parameters();
  events = node.advertise<rcl_interfaces::msg::ParameterEvent>("/parameter_events", Qos::parameters());
  const Qos qos = Qos::parameters();
  describe = std::make_unique<Server<srv::DescribeParameters>>(
      node, "~/describe_parameters",
      [&parameters](const auto& request, auto& response) {
        if (!all_declared(parameters, request.names())) return;
        for (const std::string& name : request.names())
          response.descriptors().push_back(
              to_message(name, *parameters.descriptor(name), *parameters.find(name)));
      },
      qos);
  get = std::make_unique<Server<srv::GetParameters>>(
      node, "~/get_parameters",
      [&parameters](const auto& request, auto& response) {
        if (!all_declared(parameters, request.names())) return;
        for (const std::string& name : request.names())
          response.values().push_back(to_message(*parameters.find(name)));
      },
      qos);
  get_types = std::make_unique<Server<srv::GetParameterTypes>>(
      node, "~/get_parameter_types",
      [&parameters](const auto& request, auto& response) {
        if (!all_declared(parameters, request.names())) return;
        for (const std::string& name : request.names())
          response.types().push_back(static_cast<std::uint8_t>(parameters.find(name)->index()));
      },
      qos);
  list_names = std::make_unique<Server<srv::ListParameters>>(
      node, "~/list_parameters",
      [&parameters](const auto& request, auto& response) { list(parameters, request, response.result()); },
      qos);
  set_each = std::make_unique<Server<srv::SetParameters>>(
      node, "~/set_parameters",
      [&parameters](const auto& request, auto& response) {
        for (const auto& one : request.parameters())
          response.results().push_back(result_of(set(parameters, {one})));
      },
      qos);
  set_all = std::make_unique<Server<srv::SetParametersAtomically>>(
      node, "~/set_parameters_atomically",
      [&parameters](const auto& request, auto& response) {
        response.result(result_of(set(parameters, request.parameters())));
      },
      qos);
}

void NodeServices::Impl::open_loggers() {
  get_levels = std::make_unique<Server<srv::GetLoggerLevels>>(
      node, "~/get_logger_levels", [this](const auto& request, auto& response) {
        for (const std::string& name : request.names()) {
          rcl_interfaces::msg::LoggerLevel level;
          level.name(name);
          if (name == node.log().name()) level.level(static_cast<std::uint32_t>(node.log().level()));
          response.levels().push_back(level);
        }
      });
  set_levels = std::make_unique<Server<srv::SetLoggerLevels>>(
      node, "~/set_logger_levels", [this](const auto& request, auto& response) {
        for (const auto& level : request.levels()) {
          rcl_interfaces::msg::SetLoggerLevelsResult result;
          const bool known = level.name() == node.log().name();
          const bool valid = level.level() % 10 == 0 && level.level() <= 50;
          if (!known) result.reason("this node's logger is called " + node.log().name());
          if (known && !valid)
            result.reason("a level is 10 (debug), 20, 30, 40 or 50 (fatal), or 0 for the default");
          result.successful(known && valid);
          const auto wanted = level.level() == 0 ? LogLevel::kInfo : static_cast<LogLevel>(level.level());
          if (known && valid) node.log().set_level(wanted);
          response.results().push_back(result);
        }
      });
}

NodeServices::NodeServices(Node& node) : impl_(std::make_shared<Impl>(node)) {
  impl_->open_parameters();
  node.parameters().add_observer([weak = std::weak_ptr<Impl>(impl_)](const ParameterChange& change) {
    if (const auto impl = weak.lock()) impl->publish(change);
  });
}

void NodeServices::open_type_description() {
  impl_->describe_type = std::make_unique<Server<type_description_interfaces::srv::GetTypeDescription>>(
      impl_->node, "~/get_type_description",
      [](const auto& request, auto& response) { ros::describe_type(request, response); });
}

void NodeServices::open_loggers() { impl_->open_loggers(); }

NodeServices::~NodeServices() = default;

}  // namespace goalnet::ros
