// The planner: finds a cheapest sequence of actions from a state to a goal, or says that there is none.
//
// Parse a domain once, make one Planner of it per thread, and ask it again and again: after the first calls
// it hardly allocates. Nothing is shared between Planner objects.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/planner/domain.h"
#include "components/planner/plan.h"
#include "components/planner/problem.h"

namespace goalnet::planner {

struct SolveOptions {
  // Zero: none. After it the best plan so far is returned (optimal = false), or kTimeLimit if there is none.
  std::chrono::nanoseconds time_limit{0};
  // From when a plan is known, at most this long is spent on proving it optimal or finding a better one.
  // Zero: up to time_limit.
  std::chrono::nanoseconds proof_limit{0};
  // States expanded by the optimal search before a satisficing one takes over. Zero: no limit. Unlike a time
  // limit it gives the same answer on every machine.
  std::int64_t node_limit = 0;
  // Memory for the search's tables before a satisficing search takes over. [bytes]
  std::int64_t memory_limit = std::int64_t{1} << 30;
  // Do not prove optimality: the first plan of the satisficing search will do.
  bool satisficing = false;
  // Asked at least every millisecond, also while grounding: then the answer is kCancelled.
  std::stop_token stop;
  // Told every plan that is cheaper than those before while the search goes on for a better one or a proof,
  // in the thread that solves; so that who stops the search can have the best plan so far. May be empty.
  std::function<void(const Plan&)> on_plan;
};

// Not thread-safe: one per thread. The domain must outlive it.
class Planner {
 public:
  // Prepares the domain. Where `stop` asks meanwhile, every solve() answers kCancelled.
  explicit Planner(const Domain& domain, const std::stop_token& stop = {});
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  // Errors: kNoPlan (there is none, or the goal contradicts itself), kTimeLimit, kCancelled, kInvalidRequest
  // (the problem belongs to another domain).
  Expected<Plan> solve(const Problem& problem, const SolveOptions& options = {});

  // The same from facts. Errors besides: kUnknownObject, kInvalidRequest (see make_problem in world.h).
  Expected<Plan> solve(const WorldState& state, const Goal& goal, const SolveOptions& options = {});

  const Domain& domain() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// For a single call.
Expected<Plan> solve(const Domain& domain, const Problem& problem, const SolveOptions& options = {});

}  // namespace goalnet::planner
