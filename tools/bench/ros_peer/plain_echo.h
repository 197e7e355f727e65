// Fast DDS as a program without components/ros would use it: what the ROS 2 layer is measured against.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace goalnet::tools {

// How a program hears of a message: from a listener, in the thread that received it, or in a thread of its
// own that waits with a WaitSet, as rmw's executors do.
enum class Hearing { kListener, kWaitSet };

// Reads std_msgs/String on one topic and writes it on another; reliable, keep last 10, data sharing off.
class PlainEndpoint {
 public:
  PlainEndpoint(int domain, const std::string& read, const std::string& write,
                std::function<void(const std::string&)> on_message, Hearing hearing = Hearing::kListener);
  ~PlainEndpoint();
  void write(const std::string& text);
  bool matched() const;  // both ways

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::tools
