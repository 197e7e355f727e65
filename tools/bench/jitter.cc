#include "tools/bench/jitter.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "executor/cyclic_thread.h"
#include "executor/realtime_setup.h"
#include "executor/trajectory_executor.h"

namespace goalnet::tools {
namespace {

using executor::CyclicThread;
using executor::JointSample;
using executor::TrajectoryExecutor;

constexpr std::int64_t kPeriodNs = 1'000'000;
constexpr int kPriority = 80;
constexpr int kCpu = 0;
constexpr std::size_t kJoints = 22;  // those of the default robot

std::unique_ptr<TrajectoryExecutor> make_executor() {
  executor::ExecutorParams params;
  for (std::size_t j = 0; j < kJoints; ++j) {
    executor::JointLimits joint;
    joint.name = "joint_" + std::to_string(j);
    joint.velocity = 2.0;
    joint.acceleration = 8.0;
    joint.tracking_tolerance = joint.goal_tolerance = 0.1;
    params.joints.push_back(joint);
  }
  return TrajectoryExecutor::create(params).value();
}

// All joints swing between 0 and 1 rad, with a point every 8 ms as the planner makes them; `seconds` long.
executor::JointTrajectory swing(double seconds) {
  executor::JointTrajectory trajectory;
  for (std::size_t j = 0; j < kJoints; ++j) trajectory.joints.push_back("joint_" + std::to_string(j));
  const int periods = static_cast<int>(seconds / 4.0) + 1;
  const int points = periods * 500;
  for (int k = 0; k <= points; ++k) {
    const double phase = 2.0 * 3.14159265358979 * k / 500.0;
    const double position = 0.5 - 0.5 * std::cos(phase), velocity = 0.25 * 3.14159265358979 * std::sin(phase);
    trajectory.points.push_back(
        {k * 8'000'000LL, std::vector<double>(kJoints, position), std::vector<double>(kJoints, velocity)});
  }
  return trajectory;
}

// A perfect robot with the executor: its cycle is what the thread runs while it is measured.
struct Controller {
  std::unique_ptr<TrajectoryExecutor> executor = make_executor();
  JointSample measured, command;

  void cycle(std::int64_t time_ns) {
    measured.position = command.position;
    executor->cycle(time_ns, measured, command);
  }
};

struct Lateness {
  std::vector<double> us;
  std::optional<std::string> warning;
};

Lateness run_ours(double seconds) {
  Lateness result;
  const auto cycles = static_cast<std::size_t>(seconds * 1e9 / kPeriodNs);
  result.us.reserve(cycles);
  Controller controller;
  controller.cycle(1);
  if (const auto ok = controller.executor->submit(swing(seconds)); !ok)
    throw std::runtime_error(ok.error().message);
  executor::TimeSource time = executor::steady_time_source();
  std::int64_t due = 0;
  const auto sleep = time.sleep_until_ns;
  time.sleep_until_ns = [&](std::int64_t until) {
    due = until;
    sleep(until);
  };
  std::atomic<bool> done{false};
  CyclicThread thread(
      {.name = "bench_jitter", .period_ns = kPeriodNs, .priority = kPriority, .cpu = kCpu},
      [&](std::int64_t now) {
        result.us.push_back(1e-3 * static_cast<double>(now - due));
        controller.cycle(now);
        done = result.us.size() >= cycles;
        return !done;
      },
      time);
  result.warning = thread.start();
  while (!done) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  thread.stop();
  return result;
}

// Microsecond -> count, from cyclictest's histogram; its maximum counts for what lies beyond the histogram.
std::map<int, std::uint64_t> run_cyclictest(double seconds) {
  const std::string command = "cyclictest -q -m -i 1000 -p " + std::to_string(kPriority) + " -a " +
                              std::to_string(kCpu) + " -t 1 -h 20000 -l " +
                              std::to_string(static_cast<int>(seconds * 1000.0)) + " 2>&1";
  std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) throw std::runtime_error("cyclictest cannot be started");
  std::map<int, std::uint64_t> histogram;
  std::array<char, 256> line;
  std::string said;
  int overflows = 0, maximum = 0;
  while (fgets(line.data(), line.size(), pipe.get()) != nullptr) {
    int us = 0;
    unsigned long long count = 0;
    if (std::sscanf(line.data(), "%d %llu", &us, &count) == 2) {
      if (count > 0) histogram[us] += count;
    } else if (std::sscanf(line.data(), "# Histogram Overflows: %d", &overflows) != 1 &&
               std::sscanf(line.data(), "# Max Latencies: %d", &maximum) != 1 && said.size() < 200) {
      said += line.data();
    }
  }
  if (histogram.empty()) throw std::runtime_error("cyclictest (package rt-tests) measured nothing: " + said);
  if (overflows > 0) histogram[maximum] += static_cast<std::uint64_t>(overflows);
  return histogram;
}

// What a cycle costs, one by one, in a loop without sleeping.
nlohmann::json cycle_cost(std::size_t cycles) {
  Controller controller;
  controller.cycle(1);
  if (const auto ok = controller.executor->submit(swing(1e-3 * static_cast<double>(cycles))); !ok)
    throw std::runtime_error(ok.error().message);
  std::vector<double> ns;
  ns.reserve(cycles);
  std::int64_t time_ns = 1;
  for (std::size_t n = 0; n < cycles; ++n) {
    const auto start = std::chrono::steady_clock::now();
    controller.cycle(time_ns += kPeriodNs);
    ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  const auto status = controller.executor->status();
  if (status.state != executor::ExecutorState::kExecuting)
    throw std::runtime_error("the executor did not move while it was measured: " + status.message);
  nlohmann::json result = summary(ns, "ns");
  result["joints"] = kJoints;
  return result;
}

nlohmann::json ratio(const nlohmann::json& ours, const nlohmann::json& theirs) {
  nlohmann::json result;
  for (const char* key : {"median_us", "p99_us", "max_us"})
    if (theirs[key].get<double>() > 0.0) result[key] = ours[key].get<double>() / theirs[key].get<double>();
  return result;
}

}  // namespace

nlohmann::json bench_jitter(const BenchOptions& options) {
  const int blocks = options.quick ? 2 : 4;
  const double seconds = options.quick ? 1.0 : 5.0;
  std::vector<double> ours, theirs;
  std::string warning, missing;
  for (int block = 0; block < blocks; ++block) {
    const Lateness lateness = run_ours(seconds);
    ours.insert(ours.end(), lateness.us.begin(), lateness.us.end());
    if (lateness.warning) warning = *lateness.warning;
    if (!missing.empty()) continue;
    try {
      for (const auto& [us, count] : run_cyclictest(seconds)) theirs.insert(theirs.end(), count, us);
    } catch (const std::runtime_error& error) {
      missing = error.what();
    }
  }
  executor::unlock_process_memory();  // other benchmarks follow in this process
  nlohmann::json result = {{"period_us", 1e-3 * kPeriodNs},
                           {"priority", kPriority},
                           {"real_time", warning.empty()},
                           {"lateness", summary(ours, "us")},
                           {"cycle", cycle_cost(options.quick ? 20'000 : 200'000)}};
  if (!warning.empty()) result["warning"] = warning;
  if (missing.empty()) {
    result["cyclictest"] = summary(theirs, "us");  // whole microseconds
    result["ratio"] = ratio(result["lateness"], result["cyclictest"]);
  } else {
    result["cyclictest"] = {{"error", missing}};
  }
  return result;
}

}  // namespace goalnet::tools
