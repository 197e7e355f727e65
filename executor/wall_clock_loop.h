// The executor on the wall clock: the real-time thread, and a neighbour that carries samples to and from DDS.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "executor/cyclic_thread.h"
#include "executor/trajectory_executor.h"
#include "executor/triple_buffer.h"

namespace goalnet::executor {

// Three threads meet here, through lock-free buffers only:
// - the real-time thread (SCHED_FIFO) runs TrajectoryExecutor::cycle() and nothing else;
// - the neighbour (ordinary priority) hands commands to `send`, which may publish, allocate and wait;
// - the thread that receives measurements calls set_measured().
// Nothing is commanded before the first measurement.
class WallClockLoop {
 public:
  using Send = std::function<void(const JointSample& command)>;

  // `executor` must outlive the loop.
  WallClockLoop(TrajectoryExecutor& executor, const CyclicThreadParams& thread, double command_period,
                Send send);
  ~WallClockLoop();  // stops both threads

  // Returns one warning where the system does not permit real-time scheduling.
  std::optional<std::string> start();
  void stop();

  // One thread. `time_ns` is on the clock of steady_time_source(): the moment of arrival counts as that of
  // measurement, so that the clocks of sender and receiver need not agree.
  void set_measured(const JointSample& measured);

  CyclicStatistics statistics() const { return real_time_.statistics(); }

 private:
  bool cycle(std::int64_t time_ns);
  bool carry();

  TrajectoryExecutor& executor_;
  Send send_;
  TripleBuffer<JointSample> measured_, commands_;
  JointSample latest_, command_;  // real-time thread's
  bool measured_once_ = false;    // real-time thread's
  CyclicThread real_time_, neighbour_;
};

}  // namespace goalnet::executor
