#include "tools/goalnet/parameter_check.h"

#include <algorithm>
#include <set>
#include <string>

#include "components/planner/symbols.h"
#include "components/ros/parameter_file.h"

namespace goalnet::tools {
namespace {

bool meant(const ros::ParameterOverride& given, const ros::Node& node) {
  return given.node == node.name() || ros::matches_node(given.node, node.full_name());
}

bool has(ros::Node& node, const std::string& name) {
  const auto names = node.parameters().names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The nodes that have the parameter: "world_model, visualization".
std::string owners(const std::string& name, const std::vector<ros::Node*>& nodes) {
  std::string text;
  for (ros::Node* node : nodes) {
    if (has(*node, name)) text += (text.empty() ? "" : ", ") + node->name();
  }
  return text;
}

}  // namespace

Expected<void> check_given_parameters(const ros::Arguments& arguments, const std::vector<ros::Node*>& nodes,
                                      bool all) {
  for (const ros::ParameterOverride& given : arguments.parameters) {
    if (given.origin != "-p") continue;
    std::vector<ros::Node*> those;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(those),
                 [&](ros::Node* node) { return meant(given, *node); });
    if (those.empty()) {
      if (!all) continue;
      std::vector<std::string> names;
      for (ros::Node* node : nodes) names.push_back(node->name());
      return fail(Outcome::kInvalidRequest,
                  "-p " + given.node.substr(0, 60) + ":" + given.name.substr(0, 60) + ": there is no node '" +
                      given.node.substr(0, 60) + "'" + planner::did_you_mean(given.node, names));
    }
    if (std::any_of(those.begin(), those.end(), [&](ros::Node* node) { return has(*node, given.name); }))
      continue;
    std::set<std::string> known;
    for (ros::Node* node : those) {
      for (const std::string& name : node->parameters().names()) known.insert(name);
    }
    const std::string nearest = planner::nearest_name(given.name, {known.begin(), known.end()});
    return fail(
        Outcome::kInvalidRequest,
        "-p " + given.name.substr(0, 60) + ": " +
            (those.size() == 1 ? those[0]->name() + " has no such parameter"
                               : "no node has such a parameter") +
            (nearest.empty() ? "" : "; did you mean " + nearest + " (of " + owners(nearest, those) + ")?"));
  }
  return {};
}

}  // namespace goalnet::tools
