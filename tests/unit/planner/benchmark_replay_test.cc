// config/domains/benchmark.pddl against the recorded demonstrations: the same actions must change the same
// facts.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "components/planner/benchmark_actions.h"
#include "components/planner/domain.h"
#include "components/planner/interpreter.h"
#include "components/planner/world.h"
#include "tests/unit/planner/demonstrations.h"

namespace goalnet::planner {
namespace {

// The facts after the action's effects, whatever its precondition says: perturbed recordings lack some facts
// that the recorded action needed.
FactSet after_effects(const Domain& domain, const WorldState& state, const Action& action) {
  const auto problem = make_problem(domain, state, Goal{});
  const Interpreter interpreter(*problem);
  std::vector<ObjectId> binding;
  const auto schema = interpreter.bind(action, binding);
  FactSet facts = state.facts;
  if (!schema) return facts;
  AtomSet atoms;
  atoms.assign(problem->initial);
  for (const AtomChange& change : interpreter.changes((*schema)->effect, (*schema)->slots, binding, atoms)) {
    const Predicate fact{domain.predicates.name(change.predicate), problem->object_name(change.arguments[0]),
                         change.arguments.size() > 1 ? problem->object_name(change.arguments[1]) : ""};
    change.added ? facts.insert(fact) : facts.erase(fact);
  }
  return facts;
}

TEST(BenchmarkDomain, EqualsTheRecordedStateChanges) {
  if (!std::filesystem::exists(demonstration_folder())) {
    GTEST_SKIP() << "the demonstrations are not here: " << demonstration_folder();
  }
  const auto domain = load_domain(std::string(GOALNET_SOURCE_DIR) + "/config/domains/benchmark.pddl");
  ASSERT_TRUE(domain) << domain.error().message;
  std::size_t steps = 0, equal = 0, possible = 0, shown = 0;
  for (const Demonstration& demo : load_demonstrations()) {
    for (std::size_t i = 0; i < demo.states.size() && i < demo.actions.size(); ++i) {
      const auto action = from_demonstration(demo.actions[i]);
      ASSERT_TRUE(action) << action.error().message;
      ++steps;
      const bool nothing = action->name.empty();
      const FactSet facts = nothing ? demo.states[i].facts : after_effects(*domain, demo.states[i], *action);
      possible += nothing || applicable(*domain, demo.states[i], *action) ? 1 : 0;
      const FactSet& expected = i + 1 < demo.states.size() ? demo.states[i + 1].facts : demo.states[i].facts;
      if (facts == expected) {
        ++equal;
        continue;
      }
      if (std::getenv("GOALNET_SHOW_DIFFERENCES") == nullptr || ++shown > 60) continue;
      std::cout << demo.name << " " << i << " " << demo.actions[i] << ": ";
      for (const auto& fact : difference(facts, expected)) std::cout << " ours " << to_string(fact);
      for (const auto& fact : difference(expected, facts)) std::cout << " theirs " << to_string(fact);
      std::cout << "\n";
    }
  }
  const double share = static_cast<double>(equal) / static_cast<double>(steps);
  RecordProperty("steps", static_cast<int>(steps));
  std::cout << equal << " of " << steps << " state changes equal (" << 100 * share << " %)\n";
  std::cout << possible << " of " << steps << " recorded actions possible\n";
  EXPECT_GE(static_cast<double>(possible) / static_cast<double>(steps), 0.99);
  EXPECT_GT(steps, 4000u);
  EXPECT_GE(share, 0.993);
}

TEST(BenchmarkActions, ConvertBothWays) {
  for (const char* text : {"moveto Mug_1",
                           "grasp Kettle",
                           "release Kettle",
                           "keep Mug_1 On Sink",
                           "keep Mug_1 In Microwave",
                           "turn SinkKnob",
                           "turn stoveknob_3",
                           "press fridgebutton",
                           "press tv_1remote_1powerbutton",
                           "open fridgeleftdoor",
                           "close Microwave",
                           "pour Mug_1",
                           "pour Mug_1 Kettle",
                           "add icecreamscoop Mug_1",
                           "add Ramen_1 Kettle",
                           "scoop Spoon_1 IceCream_1",
                           "squeeze Syrup_2 Mug_1",
                           "insert Cd_1 Xbox_1",
                           "place Spoon_1 Mug_1",
                           "noop"}) {
    const auto action = from_demonstration(text);
    ASSERT_TRUE(action) << action.error().message;
    EXPECT_EQ(to_demonstration(*action), text);
  }
  EXPECT_EQ(from_demonstration("turn stoveknob_1")->arguments, std::vector<std::string>{"StoveKnob_1"});
  EXPECT_EQ(*from_demonstration("keep Mug_1 Coke_1 Microwave"), (Action{"release", {"Mug_1"}}));
  EXPECT_EQ(to_demonstration({"turn-off", {"SinkKnob"}}), "turn SinkKnob");
  for (const char* text : {"", "fly Mug_1", "moveto", "grasp Mug_1 Sink", "keep Mug_1 Sink"}) {
    const auto action = from_demonstration(text);
    ASSERT_FALSE(action) << text;
    EXPECT_EQ(action.error().outcome, Outcome::kInvalidRequest);
  }
}

}  // namespace
}  // namespace goalnet::planner
