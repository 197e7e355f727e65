// The components of the loop by name: how each becomes a node. The only place that knows them all.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "components/core/outcome.h"
#include "components/ros/managed_component.h"

namespace goalnet::tools {

struct ComponentKind {
  std::string_view name;  // of the component and of its node
  std::string_view summary;
  Expected<std::unique_ptr<ros::ManagedComponent>> (*create)(ros::Node& node);
  std::string (*parameters)(bool markdown);  // its table, for people or for a README
};

// In the order in which data flows.
std::span<const ComponentKind> component_kinds();

// nullptr if there is none of that name.
const ComponentKind* find_component_kind(std::string_view name);

}  // namespace goalnet::tools
