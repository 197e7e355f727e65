// What ROS 2 tools ask every node: its parameters, its log levels and what its types look like.
#pragma once

#include <memory>

namespace goalnet::ros {

class Node;

// Made by Node; runs in its loop.
class NodeServices {
 public:
  // The six parameter services and /parameter_events.
  explicit NodeServices(Node& node);
  ~NodeServices();

  void open_type_description();  // ~/get_type_description
  void open_loggers();           // ~/get_logger_levels and ~/set_logger_levels

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;  // shared: observers of the parameters may outlive it
};

}  // namespace goalnet::ros
