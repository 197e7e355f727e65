// Asking one planner again and again hardly allocates: what remains are the names in the answer.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "components/planner/planner.h"
#include "components/planner/world.h"

namespace {
thread_local long allocations = 0;
}  // namespace

// Where only one of the two is inlined, the compiler takes them for no pair.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace goalnet::planner {
namespace {

// How many allocations the n-th time of asking takes.
long allocations_of(Planner& planner, const Problem& problem, int warm_up) {
  for (int i = 0; i < warm_up; ++i) EXPECT_TRUE(planner.solve(problem));
  const long before = allocations;
  const auto plan = planner.solve(problem);
  const long used = allocations - before;
  EXPECT_TRUE(plan);
  return used;
}

// The action list, each action's arguments, and names too long to be kept in place.
long of_the_answer(Planner& planner, const Problem& problem) {
  const auto plan = planner.solve(problem);
  EXPECT_TRUE(plan);
  const long before = allocations;
  std::vector<Action> copy;
  for (const Action& action : plan->actions) {  // as the planner builds it
    Action again{action.name, {}};
    for (const std::string& argument : action.arguments) again.arguments.push_back(argument);
    copy.push_back(std::move(again));
  }
  return allocations - before;
}

TEST(Allocations, RepeatedQuestionsHardlyAllocate) {
  const auto domain = load_domain(std::string(GOALNET_SOURCE_DIR) + "/config/domains/benchmark.pddl");
  ASSERT_TRUE(domain);
  WorldState world{
      {"Robot", "Mug_1", "Mug_2", "Kettle", "Sink", "SinkKnob", "Counter_1", "Microwave", "MicrowaveButton"},
      FactSet({{"IsGraspable", "Mug_1", ""},
               {"IsGraspable", "Mug_2", ""},
               {"IsGraspable", "Kettle", ""},
               {"On", "Mug_1", "Counter_1"},
               {"Near", "Robot", "Mug_1"}})};
  Planner planner(*domain);
  struct Case {
    const char* name;
    Goal goal;
    long besides_the_answer;
  };
  for (const Case& one :
       {Case{"nothing to do", {{{"On", "Mug_1", "Counter_1"}}, {}}, 0},
        Case{"one action", {{{"Grasping", "Robot", "Mug_1"}}, {}}, 2},
        Case{"relaxed plan", {{{"On", "Mug_1", "Sink"}, {"On", "Mug_2", "Sink"}}, {}}, 24},
        Case{"search",
             {{{"state", "Mug_1", "Water"}, {"state", "Mug_2", "Water"}, {"On", "Kettle", "Sink"}}, {}},
             300}}) {
    const auto problem = make_problem(*domain, world, one.goal);
    ASSERT_TRUE(problem) << problem.error().message;
    const long used = allocations_of(planner, *problem, 3), answer = of_the_answer(planner, *problem);
    EXPECT_LE(used - answer, one.besides_the_answer)
        << one.name << ": " << used << ", of which the answer " << answer;
    EXPECT_EQ(allocations_of(planner, *problem, 20), used) << one.name << ": it grows";
    std::cout << one.name << ": " << used << " allocations, of which the answer " << answer << "\n";
  }
}

}  // namespace
}  // namespace goalnet::planner
