#include "components/planner/satisficing_search.h"

#include <algorithm>

#include "components/planner/landmark_search.h"
#include "components/planner/landmarks.h"
#include "components/planner/novelty_search.h"
#include "components/planner/pair_reachability.h"
#include "components/planner/pruning.h"
#include "components/planner/weighted_search.h"

namespace goalnet::planner {
namespace {

constexpr std::int64_t kFirstWork = 3'000'000;  // of the first turn, in operators looked at by relaxed plans
constexpr std::int64_t kFewestStates = 50, kMostStates = 1500;
constexpr int kMethods = 5;
constexpr std::int64_t kNewPerState =
    40;  // the novelty search makes this many states while others evaluate one

std::int64_t cost_of(const GroundTask& task, const std::vector<std::int32_t>& plan) {
  std::int64_t cost = 0;
  for (const std::int32_t action : plan) cost += task.actions[static_cast<std::size_t>(action)].cost;
  return cost;
}

}  // namespace

SatisficingSearch::Result SatisficingSearch::search(const RelaxedTask& relaxed, RelaxedPlanner& heuristic,
                                                    const Word* initial, const SatisficingOptions& options,
                                                    Budget& budget, Statistics& statistics) {
  using Style = GreedySearch::Style;
  struct CostsAgain {  // when this ends
    RelaxedPlanner& heuristic;
    ~CostsAgain() { heuristic.count_actions(false); }
  } const costs_again{heuristic};
  const GroundTask& task = relaxed.task();
  plan_.clear();
  std::int64_t bound = options.upper_bound;
  bool found = false;
  // Tables are given back when this ends.
  GreedySearch greedy;
  LandmarkSearch landmark_search;
  NoveltySearch novelty;
  Landmarks landmarks;
  Pruning pruning;
  bool landmarks_known = false;
  const auto keep = [&](std::vector<std::int32_t> plan, const char* method) {
    shorten_plan(task, initial, budget, &plan);
    found = true;
    cost_ = bound = cost_of(task, plan);
    plan_ = std::move(plan);
    method_ = method;
  };
  const auto operators = std::max<std::int64_t>(static_cast<std::int64_t>(relaxed.operators().size()), 1);
  std::int64_t states = std::clamp(kFirstWork / operators, kFewestStates, kMostStates);
  for (int turn = 0; turn < options.turns && !budget.check(); ++turn) {
    int full = 0;                              // searches that ran out of memory
    heuristic.count_actions((turn & 1) != 0);  // every other turn is for short plans instead of cheap ones
    for (int method = 0; method < kMethods && !budget.check(); ++method) {
      if (method > 0 && !landmarks_known) {
        PairReachability pairs;
        pairs.compute(task, budget);
        landmarks.find(relaxed, pairs, initial, budget);
        pruning.dead.compute(task, pairs, budget);
        pruning.symmetry.find(task, budget);
        statistics.symmetries = std::max(statistics.symmetries, pruning.symmetry.count());
        if (pruning.dead.dead(initial)) return found ? Result::kFound : Result::kExhausted;
        landmarks_known = true;
        if (budget.check()) break;
      }
      Result result = Result::kLimit;
      switch (method) {
        case 0:
          result = greedy.search(task, heuristic, initial, bound, states, options.bytes, budget, statistics,
                                 pruning, Style::kLazy);
          if (result == Result::kFound) keep(greedy.plan(), "greedy search");
          break;
        case 1:
          for (const bool committed : {true, false}) {
            result = novelty.search(task, landmarks, initial, bound, kNewPerState * states, options.bytes,
                                    committed, nullptr, budget, statistics, pruning);
            if (result == Result::kFound) break;
          }
          if (result == Result::kFound) keep(novelty.plan(), "novelty search");
          break;
        case 2:
          result = landmark_search.search(task, heuristic, landmarks, initial, bound, states, options.bytes,
                                          budget, statistics, pruning);
          if (result == Result::kFound) keep(landmark_search.plan(), "landmark search");
          break;
        case 3:
          result = novelty.search(task, landmarks, initial, bound, kNewPerState * states, options.bytes,
                                  false, &heuristic, budget, statistics, pruning);
          if (result == Result::kFound) keep(novelty.plan(), "guided novelty search");
          break;
        default:
          result = greedy.search(task, heuristic, initial, bound, states, options.bytes, budget, statistics,
                                 pruning, Style::kEager);
          if (result == Result::kFound) keep(greedy.plan(), "eager greedy search");
          break;
      }
      if (result == Result::kFound && !options.best_of_turn) return Result::kFound;
      if (result == Result::kExhausted) return found ? Result::kFound : Result::kExhausted;
      full += result == Result::kMemory ? 1 : 0;
    }
    if (found) return Result::kFound;
    if (full == kMethods) return Result::kMemory;
    states = std::min<std::int64_t>(states, INT64_MAX / 1000) * 4;
  }
  if (found) return Result::kFound;
  return budget.stopped() ? Result::kStopped : Result::kLimit;
}

SatisficingSearch::Result SatisficingSearch::improve(const RelaxedTask& relaxed, RelaxedPlanner& heuristic,
                                                     const Word* initial, const SatisficingOptions& options,
                                                     Budget& budget, Statistics& statistics,
                                                     const std::function<void()>& tell) {
  const GroundTask& task = relaxed.task();
  Pruning pruning;
  PairReachability pairs;
  pairs.compute(task, budget);
  pruning.dead.compute(task, pairs, budget);
  pruning.symmetry.find(task, budget);
  WeightedSearch search;
  std::int64_t bound = options.upper_bound;
  bool found = false;
  std::int64_t weight = 5;
  while (!budget.check()) {
    const Result result =
        search.search(task, heuristic, initial, bound, weight, options.bytes, budget, statistics, pruning);
    if (result == Result::kFound) {
      plan_ = search.plan();
      shorten_plan(task, initial, budget, &plan_);
      cost_ = bound = cost_of(task, plan_);
      method_ = "weighted A*";
      found = true;
      tell();
    } else if (result != Result::kMemory || weight == 1) {
      return result == Result::kExhausted || !found ? result : Result::kFound;
    }
    if (weight > 1) weight = weight == 5 ? 3 : weight - 1;
  }
  return found ? Result::kFound : Result::kStopped;
}

void shorten_plan(const GroundTask& task, const Word* initial, Budget& budget,
                  std::vector<std::int32_t>* plan) {
  constexpr std::size_t kLongest = 2000;  // the effort is the square of this
  if (plan->size() > kLongest) return;
  std::vector<Word> state(initial, initial + std::max<std::size_t>(task.words(), 1)), now, next(state.size());
  const auto step = [&](std::vector<Word>& from, std::int32_t number) {
    apply_action(task, from.data(), task.actions[static_cast<std::size_t>(number)], next.data());
    from.swap(next);
  };
  for (std::size_t i = 0; i < plan->size();) {
    std::vector<std::int32_t> rest;
    now = state;
    for (std::size_t k = i + 1; k < plan->size(); ++k) {
      if (budget.poll()) return;
      const std::int32_t number = (*plan)[k];
      if (!action_applies(task, now.data(), task.actions[static_cast<std::size_t>(number)])) continue;
      step(now, number);
      rest.push_back(number);
    }
    if (all_hold(task, now.data(), task.goal)) {
      plan->resize(i);
      plan->insert(plan->end(), rest.begin(), rest.end());
    } else {
      step(state, (*plan)[i]);
      ++i;
    }
  }
}

}  // namespace goalnet::planner
