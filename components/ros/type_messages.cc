#include "components/ros/type_messages.h"

namespace goalnet::ros {
namespace type_msg = type_description_interfaces::msg;

namespace {

type_msg::IndividualTypeDescription individual(const idl::TypeDescription& type) {
  type_msg::IndividualTypeDescription out;
  out.type_name(type.name);
  for (const idl::FieldDescription& field : type.all_fields()) {
    type_msg::Field one;
    one.name(field.name);
    one.type().type_id(field.type_id);
    one.type().capacity(field.capacity);
    one.type().string_capacity(field.string_capacity);
    one.type().nested_type_name(field.nested);
    one.default_value(field.default_value);
    out.fields().push_back(one);
  }
  return out;
}

type_msg::TypeSource source(const idl::TypeDescription& type) {
  type_msg::TypeSource out;
  out.type_name(type.name);
  out.encoding(type.encoding);
  out.raw_file_contents(type.source);
  return out;
}

}  // namespace

type_msg::TypeDescription to_message(const idl::TypeDescription& type) {
  type_msg::TypeDescription out;
  out.type_description(individual(type));
  for (const char* const* name = type.referenced; *name != nullptr; ++name) {
    if (const auto* part = idl::find_type(*name))
      out.referenced_type_descriptions().push_back(individual(*part));
  }
  return out;
}

void describe_type(const type_description_interfaces::srv::GetTypeDescription_Request& request,
                   type_description_interfaces::srv::GetTypeDescription_Response& response) {
  const idl::TypeDescription* type = idl::find_type(request.type_name());
  if (type == nullptr) {
    response.failure_reason("unknown type " + request.type_name().substr(0, 200));
    return;
  }
  if (request.type_hash() != type->hash) {
    response.failure_reason("type " + request.type_name() + " has the hash " + type->hash + " here");
    return;
  }
  response.successful(true);
  response.type_description(to_message(*type));
  if (!request.include_type_sources()) return;
  response.type_sources().push_back(source(*type));
  for (const char* const* name = type->referenced; *name != nullptr; ++name) {
    if (const auto* part = idl::find_type(*name)) response.type_sources().push_back(source(*part));
  }
}

}  // namespace goalnet::ros
