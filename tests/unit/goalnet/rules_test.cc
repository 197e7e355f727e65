// SymSim's rules equal config/domains/benchmark.pddl: random walks through both rooms, action by action.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "components/goalnet/random.h"
#include "components/goalnet/ranker/candidates.h"
#include "components/goalnet/sym_sim.h"
#include "components/planner/benchmark_actions.h"
#include "components/planner/parser.h"
#include "components/planner/world.h"

namespace goalnet::inference {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Rules, EqualTheBenchmarkDomain) {
  const std::string path = GOALNET_SOURCE_DIR "/config/domains/benchmark.pddl";
  const auto domain = planner::parse_domain(text_of(path), path);
  ASSERT_TRUE(domain) << domain.error().message;
  const auto worlds =
      nlohmann::json::parse(text_of(GOALNET_SOURCE_DIR "/tests/data/instructions/worlds.json"));
  Symbols symbols;
  const std::string household = GOALNET_SOURCE_DIR "/config/language/household.json";
  Lexicon lexicon = *Lexicon::load(household, symbols);
  const Language language = *Language::parse(text_of(household), household, lexicon, symbols);
  Random random(5);
  int compared = 0, applied = 0;
  for (const char* room : {"kitchen", "living_room"}) {
    WorldState world;
    world.objects = worlds[room]["objects"].get<std::vector<std::string>>();
    std::vector<Predicate> facts;
    for (const auto& text : worlds[room]["facts"]) facts.push_back(*parse_predicate(text.get<std::string>()));
    const Instruction nothing = see_instruction({}, nullptr, world.objects, lexicon, language, symbols);
    Places places;  // anything on and in anything
    for (ClassId id = 0; id < lexicon.classes(); ++id) places.on.push_back(id), places.in.push_back(id);
    const Candidates all(nothing, lexicon, places);
    for (int walk = 0; walk < 6; ++walk) {
      world.facts = FactSet(facts);
      SymState state = to_sym_state(world.facts, symbols);
      for (int step = 0; step < 40; ++step) {
        const auto choices = all.in(state);
        const SymAction wanted = choices[random.below(choices.size())];
        // Now and then the last action without its means: it must be refused by both or by neither.
        const auto run = with_means(wanted, state);
        const SymAction action = run.empty() || random.below(3) == 0 ? wanted : run.front();
        if (action.verb == Verb::kStop) continue;
        const std::string text = to_string(action, symbols);
        const auto pddl = planner::from_demonstration(text);
        ASSERT_TRUE(pddl) << text;
        const bool here = applicable(action, state),
                   there = planner::applicable(*domain, world, *pddl).has_value();
        EXPECT_EQ(here, there) << text;
        ++compared;
        if (!here || !there) continue;
        const auto after = planner::apply(*domain, world, *pddl);
        ASSERT_TRUE(after) << text << ": " << after.error().message;
        apply(action, state);
        ++applied;
        ASSERT_EQ(state, to_sym_state(*after, symbols)) << text;  // names without case: "spoon", "Spoon"
        world.facts = *after;
      }
    }
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(applied, 100);
}

}  // namespace
}  // namespace goalnet::inference
