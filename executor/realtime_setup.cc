#include "executor/realtime_setup.h"

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace goalnet::executor {

std::optional<std::string> lock_process_memory() {
  // Never give the top of the heap back to the system: it would have to be faulted in again.
  mallopt(M_TRIM_THRESHOLD, -1);
  // Serve large blocks from the heap as well: mapped ones are returned, and faulted in anew, each time.
  mallopt(M_MMAP_MAX, 0);
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return std::nullopt;
  return std::string("memory is not locked (") + std::strerror(errno) +
         "; allow it with LimitMEMLOCK or CAP_IPC_LOCK)";
}

void unlock_process_memory() {
  munlockall();
  mallopt(M_TRIM_THRESHOLD, 128 * 1024);  // the defaults of glibc
  mallopt(M_MMAP_MAX, 65536);
}

void prefault_stack() {
  constexpr std::size_t kBytes = 256 * 1024;  // several times what the loop needs
  volatile unsigned char stack[kBytes];
  for (std::size_t i = 0; i < kBytes; i += 4096) stack[i] = 0;
  static_cast<void>(stack[0]);
}

std::optional<std::string> use_realtime_scheduling(int priority) {
  sched_param parameter{};
  parameter.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
  if (error == 0) return std::nullopt;
  return "no SCHED_FIFO priority " + std::to_string(priority) + " (" + std::strerror(error) +
         "; allow it with LimitRTPRIO or CAP_SYS_NICE)";
}

std::optional<std::string> pin_to_cpu(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (cpu < 0 || cpu >= CPU_SETSIZE) return "no CPU " + std::to_string(cpu);
  CPU_SET(static_cast<std::size_t>(cpu), &set);
  const int error = pthread_setaffinity_np(pthread_self(), sizeof set, &set);
  if (error == 0) return std::nullopt;
  return "not pinned to CPU " + std::to_string(cpu) + " (" + std::strerror(error) + ")";
}

void name_thread(const std::string& name) { pthread_setname_np(pthread_self(), name.substr(0, 15).c_str()); }

}  // namespace goalnet::executor
