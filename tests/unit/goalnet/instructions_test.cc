// Plain instructions and nonsense (tests/data/instructions): does the shipped model do what any sane person
// would want, and refuse what means nothing? Only counts are asserted and printed, so that the held-out part
// stays held out.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "components/goalnet/goal_model.h"
#include "components/goalnet/goal_planner.h"

namespace goalnet::inference {
namespace {

const std::string kFolder = GOALNET_SOURCE_DIR "/tests/data/instructions/";

using Row = std::vector<std::string>;

std::vector<Row> rows(const std::string& file) {
  std::ifstream stream(kFolder + file);
  std::vector<Row> result;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    Row row;
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    result.push_back(row);
  }
  return result;
}

// "(On Mug_1 Sink) !(Near Robot X)" -> facts with their signs.
std::vector<std::pair<std::string, bool>> signed_facts(const std::string& text) {
  std::vector<std::pair<std::string, bool>> result;
  for (std::size_t at = text.find('('); at != std::string::npos; at = text.find('(', at + 1))
    result.emplace_back(text.substr(at, text.find(')', at) - at + 1), at == 0 || text[at - 1] != '!');
  return result;
}

bool matches(const std::string& pattern, const std::string& name) {
  return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : pattern == name;
}

bool reached(const std::string& goal, const FactSet& facts) {
  for (std::size_t begin = 0, end; begin <= goal.size(); begin = end + 3) {
    end = std::min(goal.find(" / ", begin), goal.size());
    const std::string alternative = goal.substr(begin, end - begin);
    const int needed = alternative.find("#2") != std::string::npos ? 2 : 1;
    bool all = true;
    for (const auto& [text, wanted] : signed_facts(alternative)) {
      std::istringstream words(text.substr(1, text.size() - 2));
      std::string relation, subject, object;
      words >> relation >> subject >> object;
      int found = 0;
      for (const Predicate& fact : facts)
        found += fact.relation == relation && matches(subject, fact.subject) && matches(object, fact.object);
      all = all && (wanted ? found >= needed : found == 0);
    }
    if (all) return true;
  }
  return false;
}

class Instructions : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto loaded = load_model(GOALNET_SOURCE_DIR "/config/models/goalnet.safetensors");
    ASSERT_TRUE(loaded) << loaded.error().message;
    model = std::move(*loaded);
    std::ifstream file(kFolder + "worlds.json");
    worlds = nlohmann::json::parse(file);
  }
  static void TearDownTestSuite() { model.reset(); }

  static WorldState start(const std::string& room, const std::string& changes) {
    WorldState world;
    world.objects = worlds[room]["objects"].get<std::vector<std::string>>();
    std::vector<Predicate> facts;
    for (const auto& text : worlds[room]["facts"]) facts.push_back(*parse_predicate(text.get<std::string>()));
    world.facts = FactSet(facts);
    for (const auto& [text, add] : signed_facts(changes)) {
      const Predicate fact = *parse_predicate(text);
      if (!add) {
        world.facts.erase(fact);
        continue;
      }
      const FactSet before = world.facts;
      for (const Predicate& old : before)  // what is held stands nowhere
        if (fact.relation == "Grasping" && old.subject == fact.object &&
            (old.relation == "On" || old.relation == "In"))
          world.facts.erase(old);
      world.facts.insert(fact);
    }
    return world;
  }

  // The final facts, or nothing where the model refused.
  static std::optional<FactSet> follow(const WorldState& world, const std::string& sentence) {
    Symbols symbols;
    const GoalPlanner planner;
    std::vector<WorldState> states = {world};
    std::vector<Goal> goals;
    SymState now = to_sym_state(world.facts, symbols);
    for (int step = 0; step < 30; ++step) {
      const auto goal =
          model->infer({.sentence = sentence, .grounding = nullptr, .states = states, .goals = goals});
      if (!goal) return std::nullopt;
      if (goal->empty()) break;
      const auto plan = planner.plan(to_sym_goal(*goal, symbols), now);
      if (plan)
        for (const SymAction& action : *plan) apply(action, now);
      goals.push_back(*goal);
      states.push_back({world.objects, to_fact_set(now, symbols)});
    }
    return states.back().facts;
  }

  inline static std::unique_ptr<GoalModel> model;
  inline static nlohmann::json worlds;
};

TEST_F(Instructions, SensibleOnesReachTheirGoals) {
  std::map<std::string, std::array<int, 3>> counts;  // set -> all, reached, refused
  for (const Row& row : rows("sensible.tsv")) {
    ASSERT_EQ(row.size(), 6u) << row[0];
    auto& [all, good, refused] = counts[row[1]];
    ++all;
    const auto end = follow(start(row[2], row[4]), row[3]);
    refused += !end;
    const bool ok = end && reached(row[5], *end);
    good += ok;
    if (row[1] == "tuning") {
      EXPECT_TRUE(ok) << row[0] << ": " << row[3];
    }
  }
  for (const auto& [set, count] : counts) {
    std::printf("%s: %d of %d reach their goal, %d refused\n", set.c_str(), count[1], count[0], count[2]);
    EXPECT_GE(count[1], 0.9 * count[0]) << set;
    EXPECT_LT(count[2], 0.03 * count[0] + 1e-9) << set;
  }
  EXPECT_EQ(counts["held_out"][0], 80);
}

TEST_F(Instructions, NonsenseIsRefusedWithAReason) {
  std::map<std::string, std::array<int, 2>> counts;
  for (const Row& row : rows("nonsense.tsv")) {
    ASSERT_EQ(row.size(), 4u);
    const std::vector<WorldState> states = {start(row[2], "")};
    const auto goal = model->infer({.sentence = row[3], .grounding = nullptr, .states = states, .goals = {}});
    ++counts[row[1]][0];
    if (goal) continue;
    ++counts[row[1]][1];
    EXPECT_EQ(goal.error().outcome, Outcome::kNotUnderstood);
    EXPECT_GT(goal.error().message.size(), 20u);
  }
  for (const auto& [set, count] : counts) {
    std::printf("%s: %d of %d nonsense sentences refused\n", set.c_str(), count[1], count[0]);
    EXPECT_GE(count[1], 0.95 * count[0]) << set;
  }
}

}  // namespace
}  // namespace goalnet::inference
