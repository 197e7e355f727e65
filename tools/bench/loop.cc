#include "tools/bench/loop.h"

#include <chrono>
#include <stdexcept>

#include "tools/goalnet/lockstep_loop.h"

namespace goalnet::tools {
namespace {

using SteadyClock = std::chrono::steady_clock;

double since(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

struct Measured {
  double start_wall = 0.0;  // [s] from nothing to a world at rest
  double sim = 0.0;         // [s]
  double wall = 0.0;        // [s]
  std::size_t actions = 0;
};

Measured run_once(const Goal& goal, std::uint64_t seed) {
  Measured measured;
  coordinator::Report last;
  LoopOptions options;
  options.seed = seed;
  options.process_only = true;
  LoopEvents events;
  events.on_status = [&last](const coordinator::Report& report) { last = report; };
  const auto created = SteadyClock::now();
  auto loop = LockstepLoop::create(options, std::move(events));
  if (!loop) throw std::runtime_error(loop.error().message);
  if (const auto settled = (*loop)->settle(); !settled) throw std::runtime_error(settled.error().message);
  measured.start_wall = since(created);
  const auto started = SteadyClock::now();
  const double sim_start = (*loop)->sim_time();
  (*loop)->pursue(goal);
  while (!last.finished) (*loop)->step();
  measured.sim = (*loop)->sim_time() - sim_start;
  measured.wall = since(started);
  measured.actions = last.actions.size();
  if (last.outcome != Outcome::kDone)
    throw std::runtime_error("the run ended with " + std::string(to_string(last.outcome)) + ": " +
                             last.message);
  return measured;
}

// How fast the simulation alone runs: nothing asked, everything published.
double idle_factor(double sim_seconds) {
  LoopOptions options;
  options.process_only = true;
  auto loop = LockstepLoop::create(options, {});
  if (!loop) throw std::runtime_error(loop.error().message);
  if (const auto settled = (*loop)->settle(); !settled) throw std::runtime_error(settled.error().message);
  const auto started = SteadyClock::now();
  const double sim_start = (*loop)->sim_time();
  while ((*loop)->sim_time() - sim_start < sim_seconds) (*loop)->step();
  return sim_seconds / since(started);
}

}  // namespace

nlohmann::json bench_loop(const BenchOptions& options) {
  const Goal goal{{{"On", "Mug_1", "Sink"}, {"state", "Mug_1", "Water"}}, {}, 1.0};
  const int runs = options.quick ? 1 : 3;
  double sim = 0.0, wall = 0.0;
  std::vector<double> starts, walls;
  std::size_t actions = 0;
  for (int i = 0; i < runs; ++i) {
    const Measured measured = run_once(goal, options.seed + static_cast<std::uint64_t>(i));
    sim += measured.sim;
    wall += measured.wall;
    actions += measured.actions;
    starts.push_back(measured.start_wall);
    walls.push_back(measured.wall);
  }
  return {{"task", "(On Mug_1 Sink) (state Mug_1 Water)"},
          {"runs", runs},
          {"actions", actions},
          {"sim_time_s", sim},
          {"wall_time_s", wall},
          {"real_time_factor", sim / wall},
          {"real_time_factor_idle", idle_factor(options.quick ? 5.0 : 20.0)},
          {"start", summary(starts, "s")},
          {"run", summary(walls, "s")}};
}

}  // namespace goalnet::tools
