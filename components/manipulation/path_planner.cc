#include "components/manipulation/path_planner.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

namespace goalnet::manipulation {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Joint space in units of time: each coordinate is the joint's position times `scale`, and the distance of
// two states is the largest coordinate difference, that is how long the slowest joint needs.
class TimeSpace : public ob::RealVectorStateSpace {
 public:
  using ob::RealVectorStateSpace::RealVectorStateSpace;
  double distance(const ob::State* a, const ob::State* b) const override {
    const auto* x = a->as<StateType>()->values;
    const auto* y = b->as<StateType>()->values;
    double largest = 0, sum = 0;
    for (unsigned i = 0; i < dimension_; ++i) {
      largest = std::max(largest, std::abs(x[i] - y[i]));
      sum += std::abs(x[i] - y[i]);
    }
    return largest + 0.05 * sum;  // the sum breaks ties: useless motion of other joints costs a little
  }
};

JointVector from_state(const ob::State* state, const JointVector& scale) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return Eigen::Map<const JointVector>(values, scale.size()).cwiseQuotient(scale);
}

void to_state(const JointVector& q, const JointVector& scale, ob::State* state) {
  auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  for (Eigen::Index i = 0; i < q.size(); ++i) values[i] = q[i] * scale[i];
}

class Sampler : public ob::RealVectorStateSampler {
 public:
  Sampler(const ob::StateSpace* space, const PathQuery& query)
      : RealVectorStateSampler(space), query_(query) {}
  void sampleUniform(ob::State* state) override {
    JointVector q;
    const auto uniform = [this](double a, double b) { return rng_.uniformReal(a, b); };
    for (int attempt = 0; query_.sample && attempt < 20; ++attempt) {
      if (query_.sample(uniform, q)) return to_state(q, query_.scale, state);
    }
    RealVectorStateSampler::sampleUniform(state);
  }

 private:
  const PathQuery& query_;
};

// Both ends were checked by the planner or are given; checks the inside from coarse to fine.
class EdgeCheck : public ob::MotionValidator {
 public:
  EdgeCheck(const ob::SpaceInformationPtr& si, const PathQuery& query, double resolution)
      : MotionValidator(si), query_(query), resolution_(resolution) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const JointVector from = from_state(a, query_.scale), to = from_state(b, query_.scale);
    if (!query_.is_free(to)) return false;
    const int n = static_cast<int>(std::ceil(scaled_distance(from, to, query_.scale) / resolution_));
    for (int stride = 1 << 8; stride >= 1; stride /= 2) {
      for (int k = stride; k < n; k += 2 * stride) {
        if (!query_.is_free(from + (to - from) * (static_cast<double>(k) / n))) return false;
      }
    }
    return true;
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last) const override {
    last.second = 0;
    return checkMotion(a, b);
  }

 private:
  const PathQuery& query_;
  double resolution_;
};

}  // namespace

namespace {

// Every call draws the same random numbers, whatever was planned before it: results do not depend on history.
// OMPL hands a fresh seed to each new generator; seeding its source anew repeats them. It warns that
// generators made earlier keep theirs, which is no loss here: none outlives a call. Hence the silence.
void seed_planner() {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(1);
}

}  // namespace

Expected<JointPath> plan_path(const PathQuery& query, const PlannerLimits& limits) {
  seed_planner();
  const auto n = static_cast<unsigned>(query.start.size());
  auto space = std::make_shared<TimeSpace>(n);
  ob::RealVectorBounds bounds(n);
  for (unsigned i = 0; i < n; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    bounds.low[i] = std::min({query.lower[k], query.start[k], query.goal[k]}) * query.scale[k] - 1e-6;
    bounds.high[i] = std::max({query.upper[k], query.start[k], query.goal[k]}) * query.scale[k] + 1e-6;
  }
  space->setBounds(bounds);
  space->setStateSamplerAllocator(
      [&query](const ob::StateSpace* s) { return std::make_shared<Sampler>(s, query); });
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(
      [&query](const ob::State* s) { return query.is_free(from_state(s, query.scale)); });
  si->setMotionValidator(std::make_shared<EdgeCheck>(si, query, limits.resolution));
  si->setup();
  ob::ScopedState<> start(space), goal(space);
  to_state(query.start, query.scale, start.get());
  to_state(query.goal, query.scale, goal.get());
  if (!query.is_free(query.start)) return fail(Outcome::kMotionFailed, "the motion starts in a collision");
  if (!query.is_free(query.goal)) return fail(Outcome::kMotionFailed, "the motion would end in a collision");
  if (si->checkMotion(start.get(), goal.get())) return JointPath{query.start, query.goal};

  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  problem->setStartAndGoalStates(start, goal);
  auto planner = std::make_shared<og::RRTConnect>(si);
  planner->setProblemDefinition(problem);
  planner->setRange(limits.range);
  planner->setup();
  int iterations = 0;
  bool cancelled = false;
  const auto solved = planner->solve(ob::PlannerTerminationCondition([&] {
    cancelled = cancelled || (query.stopped && query.stopped());
    return cancelled || ++iterations > limits.iterations;
  }));
  if (cancelled) return fail(Outcome::kCancelled, "cancelled while a path was being planned");
  if (solved != ob::PlannerStatus::EXACT_SOLUTION) {
    return fail(Outcome::kMotionFailed,
                "no free path found in " + std::to_string(limits.iterations) + " iterations");
  }
  auto& path = *problem->getSolutionPath()->as<og::PathGeometric>();
  og::PathSimplifier simplifier(si);
  simplifier.reduceVertices(path, static_cast<unsigned>(limits.shortcuts), 0, 0.8);
  simplifier.shortcutPath(path, static_cast<unsigned>(limits.shortcuts), 0, 0.8, 0.01);
  simplifier.reduceVertices(path, static_cast<unsigned>(limits.shortcuts), 0, 0.8);
  JointPath out;
  for (const auto* state : path.getStates()) out.push_back(from_state(state, query.scale));
  out.front() = query.start;
  out.back() = query.goal;
  return out;
}

}  // namespace goalnet::manipulation
