// Grounds lazily, backwards from the goal: literals that are needed bring in the actions that produce them,
// whose preconditions are needed in turn. What the goal cannot need is never looked at, so that a thousand
// objects in the room cost nothing when the goal is about one mug.
//
// Exact: a cheapest plan of the ground task is a cheapest plan of the problem. Actions that destroy a needed
// literal only under a condition make the opposite of the condition needed as well, because a plan may have
// to protect it.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "components/planner/attainable.h"
#include "components/planner/binder.h"
#include "components/planner/budget.h"
#include "components/planner/compiled_domain.h"
#include "components/planner/ground_task.h"
#include "components/planner/problem_index.h"
#include "components/planner/reachable_atoms.h"

namespace goalnet::planner {

class Grounder {
 public:
  explicit Grounder(const CompiledDomain& compiled);

  // More ground actions than this and the answer is kTooLarge. [count]
  static constexpr std::size_t kMostActions = 3'000'000;
  // With more than this it begins again with only what can be reached forwards. [count]
  static constexpr std::size_t kManyActions = 20'000;
  // Actions carried out to find that. [count]
  static constexpr std::int64_t kFewFirings = 1'000'000, kMostFirings = 30'000'000;
  enum class Result { kDone, kStopped, kTooLarge };

  // `goal` in normal form, its quantified variables of the types `goal_slots`.
  Result ground(ProblemIndex& index, const Formula& goal, std::span<const TypeSet> goal_slots, Budget& budget,
                GroundTask& task);
  // A schema of which some instance was left out because the problem gives no value for its cost, or -1.
  std::int32_t without_cost() const { return without_cost_; }

 private:
  struct RawEffect {
    std::int32_t action;
    GroundEffect effect;
  };
  struct Definition {  // of a derived atom
    bool known = false;
    std::uint32_t axiom_begin = 0, axiom_end = 0;  // in GroundTask::axioms
  };
  // Where an instance of a condition ends up: a constant, or a condition of the task.
  struct Value {
    enum class Kind { kFalse, kTrue, kCondition } kind;
    ConditionId condition = 0;
  };

  void restart();
  Result ground_backwards(const Formula& goal, std::span<const TypeSet> goal_slots,
                          const AtomLists* reachable, std::size_t most_actions);
  bool close();
  void produce(Literal literal);
  void produce(const EffectReference& reference, Literal literal);
  void define(Literal literal);
  template <class Visit>
  void bind_open(const CompiledSchema& schema, const CompiledEffect& effect, bool parameters,
                 const Visit& visit);
  std::int32_t action_for(std::int32_t schema, bool create);
  bool instantiate(const Condition& condition, Growing<ConditionId>* result);
  Value instantiate(const Formula& formula);
  enum class Known { kFalse, kTrue, kOpen };
  Known known_value(const Formula& formula) const;
  template <class Visit>
  void for_each_candidate(const Formula& inner, bool conjunction, std::int32_t slot, const Visit& visit);
  const std::vector<ObjectId>& objects_of(const TypeSet& types);
  void sort(Growing<ConditionId>& conditions);
  Value instantiate_junction(bool conjunction, Growing<ConditionId>& children);
  Literal literal_for(const AtomPattern& pattern, bool negative);
  void need(ConditionId condition);
  void need_opposite(ConditionId condition);
  void add_effect(std::int32_t action, const CompiledEffect& effect, Literal literal,
                  Growing<RawEffect>* effects);
  void gather_side_effects();
  void gather(const EffectReference& reference, Literal literal);
  void finish();
  void finish_axioms();

  const CompiledDomain& compiled_;
  ProblemIndex* index_ = nullptr;
  Budget* budget_ = nullptr;
  GroundTask* task_ = nullptr;
  std::span<const TypeSet> slots_;  // types of the variables at hand
  bool stopped_ = false, too_large_ = false;
  std::size_t most_actions_ = kMostActions;
  std::int32_t without_cost_ = -1;

  Binder binder_;  // of the schema at hand
  Attainable attainable_;
  ReachableAtoms reachable_;
  std::map<TypeSet, std::vector<ObjectId>> objects_;  // found when first asked for
  AtomTable action_table_;                            // schema and parameters → entry
  Growing<std::int32_t> action_of_entry_;             // -1: impossible
  std::vector<Growing<std::int32_t>> actions_of_schema_;
  Growing<RawEffect> effects_;       // that actions were grounded for
  Growing<RawEffect> side_effects_;  // what else they do to needed literals
  Growing<Definition> definitions_;  // by atom; empty where the domain has no axioms
  Growing<Literal> queue_;
  std::size_t queue_next_ = 0;
};

// Visits every binding that the static facts allow, until the task is too large or time is up.
template <class Visit>
void Grounder::bind_open(const CompiledSchema& schema, const CompiledEffect& effect, bool parameters,
                         const Visit& visit) {
  if (stopped_ || too_large_) return;
  binder_.each(schema, &effect, parameters, [&] {
    visit();
    return !stopped_ && !too_large_;
  });
  stopped_ = stopped_ || budget_->stopped();
}

}  // namespace goalnet::planner
