#include "components/ros/parameter_messages.h"

#include <cmath>

namespace goalnet::ros {
namespace msg = rcl_interfaces::msg;

msg::ParameterValue to_message(const ParameterValue& value) {
  msg::ParameterValue message;
  message.type(static_cast<std::uint8_t>(value.index()));
  switch (value.index()) {
    case 1:
      message.bool_value(std::get<1>(value));
      break;
    case 2:
      message.integer_value(std::get<2>(value));
      break;
    case 3:
      message.double_value(std::get<3>(value));
      break;
    case 4:
      message.string_value(std::get<4>(value));
      break;
    case 5:
      message.byte_array_value(std::get<5>(value));
      break;
    case 6:
      message.bool_array_value(std::get<6>(value));
      break;
    case 7:
      message.integer_array_value(std::get<7>(value));
      break;
    case 8:
      message.double_array_value(std::get<8>(value));
      break;
    case 9:
      message.string_array_value(std::get<9>(value));
      break;
    default:
      break;
  }
  return message;
}

msg::Parameter to_message(const Parameter& parameter) {
  msg::Parameter message;
  message.name(parameter.name);
  message.value(to_message(parameter.value));
  return message;
}

msg::ParameterDescriptor to_message(const std::string& name, const ParameterDescriptor& descriptor,
                                    const ParameterValue& value) {
  msg::ParameterDescriptor message;
  message.name(name);
  message.type(static_cast<std::uint8_t>(value.index()));
  message.description(descriptor.description);
  message.additional_constraints(descriptor.additional_constraints);
  message.read_only(descriptor.read_only);
  if (!descriptor.range) return message;
  const bool whole =
      std::holds_alternative<std::int64_t>(value) || std::holds_alternative<std::vector<std::int64_t>>(value);
  if (whole) {
    msg::IntegerRange range;
    range.from_value(static_cast<std::int64_t>(descriptor.range->from));
    range.to_value(static_cast<std::int64_t>(descriptor.range->to));
    range.step(static_cast<std::uint64_t>(descriptor.range->step));
    message.integer_range({range});
  } else {
    msg::FloatingPointRange range;
    range.from_value(descriptor.range->from);
    range.to_value(descriptor.range->to);
    range.step(descriptor.range->step);
    message.floating_point_range({range});
  }
  return message;
}

Expected<ParameterValue> from_message(const msg::ParameterValue& message) {
  switch (message.type()) {
    case 0:
      return ParameterValue();
    case 1:
      return ParameterValue(message.bool_value());
    case 2:
      return ParameterValue(message.integer_value());
    case 3:
      return ParameterValue(message.double_value());
    case 4:
      return ParameterValue(message.string_value());
    case 5:
      return ParameterValue(message.byte_array_value());
    case 6:
      return ParameterValue(message.bool_array_value());
    case 7:
      return ParameterValue(message.integer_array_value());
    case 8:
      return ParameterValue(message.double_array_value());
    case 9:
      return ParameterValue(message.string_array_value());
    default:
      return fail(Outcome::kInvalidRequest, "unknown parameter type " + std::to_string(message.type()));
  }
}

}  // namespace goalnet::ros
