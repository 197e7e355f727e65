#include "executor/wall_clock_loop.h"

#include <cmath>
#include <utility>

namespace goalnet::executor {

WallClockLoop::WallClockLoop(TrajectoryExecutor& executor, const CyclicThreadParams& thread,
                             double command_period, Send send)
    : executor_(executor),
      send_(std::move(send)),
      real_time_(thread, [this](std::int64_t time_ns) { return cycle(time_ns); }),
      neighbour_({.name = "goalnet_carrier",
                  .period_ns = std::llround(1e9 * command_period),
                  .priority = 0,
                  .lock_memory = false},
                 [this](std::int64_t) { return carry(); }) {}

WallClockLoop::~WallClockLoop() { stop(); }

std::optional<std::string> WallClockLoop::start() {
  auto warning = real_time_.start();
  neighbour_.start();
  return warning;
}

void WallClockLoop::stop() {
  real_time_.stop();
  neighbour_.stop();
}

void WallClockLoop::set_measured(const JointSample& measured) { measured_.write(measured); }

bool WallClockLoop::cycle(std::int64_t time_ns) {
  measured_once_ = measured_.read(latest_) || measured_once_;
  if (!measured_once_) return true;
  executor_.cycle(time_ns, latest_, command_);
  commands_.write(command_);
  return true;
}

bool WallClockLoop::carry() {
  JointSample command;
  if (commands_.read(command)) send_(command);
  return true;
}

}  // namespace goalnet::executor
