// Drawings as visualization_msgs/MarkerArray.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "builtin_interfaces/msg/Time.h"
#include "components/visualization/drawing.h"
#include "visualization_msgs/msg/MarkerArray.h"

namespace goalnet::visualization {

// Every message has all that is there now (ADD) and names all that ever was and is not (DELETE): the topic is
// latched, keeping the last message only, so that each one must be right for a viewer who saw none of those
// before.
class MarkerWriter {
 public:
  visualization_msgs::msg::MarkerArray write(const std::vector<Drawing>& drawings,
                                             const builtin_interfaces::msg::Time& stamp);

 private:
  std::set<std::pair<std::string, std::int32_t>> ever_;
};

}  // namespace goalnet::visualization
