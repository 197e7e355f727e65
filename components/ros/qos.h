// Quality of service as ROS 2 names it. The standard profiles are those of rmw's qos_profiles.h.
#pragma once

#include <chrono>
#include <cstdint>

namespace goalnet::ros {

struct Qos {
  bool reliable = true;
  bool transient_local = false;  // late subscribers get the last `depth` messages
  bool keep_all = false;         // otherwise keep last `depth`
  std::uint32_t depth = 10;
  std::chrono::nanoseconds lifespan{0};  // older messages are dropped; 0: never
  std::chrono::nanoseconds deadline{0};  // a message is expected at least that often; 0: none

  static Qos standard() { return {}; }
  static Qos sensor_data() { return {.reliable = false, .depth = 5}; }
  static Qos latched() { return {.transient_local = true, .depth = 1}; }
  static Qos clock() { return {.reliable = false, .depth = 1}; }
  static Qos tf() { return {.depth = 100}; }
  static Qos tf_static() { return latched(); }
  static Qos rosout() {
    return {.transient_local = true, .depth = 1000, .lifespan = std::chrono::seconds(10)};
  }
  // On the wire as every ROS 2 service; a deeper history than rmw's 10, so that bursts lose nothing.
  static Qos services() { return {.depth = 1000}; }
  static Qos parameters() { return {.depth = 1000}; }

  Qos keep_last(std::uint32_t n) const {
    Qos copy = *this;
    copy.depth = n;
    copy.keep_all = false;
    return copy;
  }
  Qos best_effort() const {
    Qos copy = *this;
    copy.reliable = false;
    return copy;
  }

  bool operator==(const Qos&) const = default;
};

// What a publisher offers, as far as the graph shows it.
struct OfferedQos {
  Qos qos;
  bool history_known = false;   // DDS does not announce it: only known of publishers of this process
  std::uint8_t liveliness = 1;  // rmw's numbers: 1 automatic, 2 by node, 3 by topic
  std::chrono::nanoseconds liveliness_lease{0};  // 0: infinite

  bool operator==(const OfferedQos&) const = default;
};

}  // namespace goalnet::ros
