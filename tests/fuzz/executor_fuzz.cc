// The executor against any sequence of trajectories, commands, measurements and clock steps: whatever comes
// in, the command stays finite and within the limits, and nothing crashes.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "executor/trajectory_executor.h"

namespace {

using goalnet::executor::JointSample;
using goalnet::executor::JointTrajectory;

// Takes values off the front of the input; zeros when it is used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool empty() const { return size_ == 0; }
  template <class T>
  T take() {
    T value{};
    const std::size_t count = std::min(size_, sizeof value);
    std::memcpy(&value, data_, count);
    data_ += count;
    size_ -= count;
    return value;
  }
  // Mostly a number of a useful size, sometimes any bit pattern (not-a-number, infinity, 1e300).
  double number() {
    const auto kind = take<std::uint8_t>();
    return kind < 16 ? take<double>() : static_cast<double>(take<std::int16_t>()) / 8192.0;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

JointTrajectory trajectory(Bytes& bytes, const JointSample& command) {
  JointTrajectory made;
  const auto flags = bytes.take<std::uint8_t>();
  if ((flags & 1) != 0) made.joints.push_back("a");
  if ((flags & 2) != 0) made.joints.push_back("b");
  if ((flags & 4) != 0) made.joints.push_back((flags & 8) != 0 ? "a" : "c");
  std::int64_t time = (flags & 16) != 0 ? 500'000'000 : 0;
  const int points = bytes.take<std::uint8_t>() % 8;
  for (int k = 0; k < points; ++k) {
    goalnet::executor::TrajectoryPoint point;
    point.time_ns = time;
    for (std::size_t j = 0; j < made.joints.size(); ++j)
      point.position.push_back(k == 0 && (flags & 32) != 0 ? command.position[j] : bytes.number());
    if ((flags & 64) != 0)
      for (std::size_t j = 0; j < made.joints.size(); ++j) point.velocity.push_back(bytes.number());
    made.points.push_back(point);
    const std::uint64_t step = (flags & 128) != 0 ? bytes.take<std::uint64_t>()
                                                  : std::uint64_t{1'000'000} * bytes.take<std::uint16_t>();
    time = static_cast<std::int64_t>(static_cast<std::uint64_t>(time) + step);  // may wrap around
  }
  return made;
}

void check(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  goalnet::executor::ExecutorParams params;
  for (const char* name : {"a", "b"}) {
    goalnet::executor::JointLimits joint;
    joint.name = name;
    joint.position_min = -1.0;
    joint.position_max = 2.0;
    joint.velocity = 1.5;
    joint.acceleration = 6.0;
    params.joints.push_back(joint);
  }
  params.joints[1].tracking_tolerance = params.joints[1].goal_tolerance = 0.3;
  auto executor = goalnet::executor::TrajectoryExecutor::create(params).value();

  JointSample measured, command;
  std::int64_t time = 1'000'000;
  executor->cycle(time, measured, command);
  double velocity[2] = {};
  Bytes bytes(data, size);
  for (int rounds = 0; rounds < 200 && !bytes.empty(); ++rounds) {
    const auto what = bytes.take<std::uint8_t>();
    if (what % 8 == 0) executor->stop();
    if (what % 32 == 1) executor->emergency_stop();
    if (what % 8 == 2) executor->reset();
    if (what % 2 == 1) static_cast<void>(executor->submit(trajectory(bytes, command)));
    const int cycles = bytes.take<std::uint8_t>();
    const bool hostile = what % 16 == 6;
    for (int n = 0; n < cycles; ++n) {
      measured.position = command.position;
      if (hostile) measured.position[n % 2] = bytes.number();
      const JointSample before = command;
      executor->cycle(time += 1'000'000, measured, command);
      for (int j = 0; j < 2; ++j) {
        const double v = (command.position[j] - before.position[j]) / 0.001;
        check(std::isfinite(command.position[j]) && std::isfinite(command.velocity[j]));
        check(std::abs(command.velocity[j]) <= 1.5 + 1e-6);
        // After a reset the command starts anew where the joint is measured: the only jump there is.
        const bool moved_by_hand = hostile || what % 8 == 2;
        check(moved_by_hand || std::abs(v) <= 1.5 + 1e-6);
        check(moved_by_hand || std::abs(v - velocity[j]) <= 6.0 * 0.001 + 1e-6);
        check(moved_by_hand || before.position[j] > 2.0 || before.position[j] < -1.0 ||
              (command.position[j] <= 2.0 + 1e-9 && command.position[j] >= -1.0 - 1e-9));
        velocity[j] = moved_by_hand && std::abs(v) > 1.5 ? 0.0 : v;
      }
    }
    static_cast<void>(executor->status());
  }
  return 0;
}
