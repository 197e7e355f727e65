// CPU time of one thread, also read from another: on a busy machine the clock on the wall counts the others
// too.
#pragma once

#include <pthread.h>

#include <ctime>
#include <stdexcept>

namespace goalnet::tools {

class CpuClock {
 public:
  // Of the calling thread. Throws where the system has no such clock.
  CpuClock() {
    if (pthread_getcpuclockid(pthread_self(), &clock_) != 0)
      throw std::runtime_error("no CPU clock for this thread");
  }
  double microseconds() const {
    timespec now{};
    clock_gettime(clock_, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
  }

 private:
  clockid_t clock_{};
};

}  // namespace goalnet::tools
