#include "components/goalnet/ranker/neighbours.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace goalnet::inference {
namespace {

// Words, pairs, things named, what is held at the start.
std::vector<Term> terms_of(const Instruction& instruction, const SymState& state) {
  std::map<std::uint32_t, float> sums;
  for (const std::uint32_t word : instruction.unigrams) sums[word] += 1.0f;
  for (const std::uint32_t pair : instruction.bigrams) sums[pair ^ 0x5bd1e995u] += 0.7f;
  sums[instruction.first_verb ^ 0x1234567u] += 0.5f;
  for (const SeenObject& object : instruction.objects) {
    if (state.holds(object.symbol)) sums[0x70000000u + object.class_id] += 0.4f;
    if (object.level >= NameLevel::kName || object.grounded)
      sums[0x60000000u + object.class_id] += 1.0f / static_cast<float>(std::max<int>(1, object.of_class));
  }
  return {sums.begin(), sums.end()};
}

// What stands where: rooms are told apart by it.
std::vector<std::uint32_t> layout_of(const Instruction& instruction, const SymState& state) {
  const auto name = [&](Symbol symbol) -> std::uint32_t {
    const int found = instruction.find(symbol);
    return found < 0 ? symbol : instruction.objects[static_cast<std::size_t>(found)].name_hash;
  };
  std::vector<std::uint32_t> layout;
  for (const SymFact fact : state.facts()) {
    const Relation relation = relation_of(fact);
    if (relation != Relation::kOn && relation != Relation::kIn) continue;
    layout.push_back((name(subject_of(fact)) * 0x9e3779b1u ^ name(object_of(fact))) * 0x85ebca6bu +
                     static_cast<std::uint32_t>(relation));
  }
  std::sort(layout.begin(), layout.end());
  layout.erase(std::unique(layout.begin(), layout.end()), layout.end());
  return layout;
}

float overlap(std::size_t common, std::size_t a, std::size_t b) {
  const std::size_t all = a + b - common;
  return all == 0 ? 1.0f : static_cast<float>(common) / static_cast<float>(all);
}

// How much a neighbour counts when single objects are asked for.
float room_weight(const Neighbour& neighbour) {
  const float room = neighbour.layout * neighbour.layout;
  return room * room * (0.02f + neighbour.similarity * neighbour.similarity);
}

}  // namespace

Memory remember(const Example& example, bool grounding) {
  const Instruction& instruction = grounding ? example.given : example.none;
  Memory memory;
  memory.scenario = example.scenario;
  memory.terms = terms_of(instruction, example.states.front());
  memory.layout = layout_of(instruction, example.states.front());
  for (const Mention& mention : instruction.mentions) memory.mentions.push_back(hash_text(mention.phrase));
  const auto seen = [&](Symbol symbol) -> const SeenObject* {
    const int found = instruction.find(symbol);
    return found < 0 ? nullptr : &instruction.objects[static_cast<std::size_t>(found)];
  };
  for (const auto& [at, action] : example.macros) {
    Memory::Step step{.action = action};
    if (const SeenObject* x = seen(action.x))
      step.x_class = x->class_id, step.x_mention = static_cast<std::int16_t>(x->mention);
    if (const SeenObject* y = seen(action.y))
      step.y_class = y->class_id, step.y_mention = static_cast<std::int16_t>(y->mention);
    memory.steps.push_back(step);
  }
  return memory;
}

Neighbours::Neighbours(std::vector<Memory> memories) : memories_(std::move(memories)) {
  std::unordered_map<std::uint32_t, int> documents;
  for (const Memory& memory : memories_)
    for (const auto& [term, amount] : memory.terms) ++documents[term];
  const float n = static_cast<float>(memories_.size()) + 1;
  for (const auto& [term, count] : documents)
    weight_[term] = std::log(n / (static_cast<float>(count) + 0.5f));
  unseen_weight_ = std::log(n / 0.5f);
  for (std::uint32_t i = 0; i < memories_.size(); ++i) {
    auto vector = memories_[i].terms;
    weigh(vector);
    for (const auto& [term, amount] : vector) by_term_[term].emplace_back(i, amount);
    for (const std::uint32_t fact : memories_[i].layout) by_layout_[fact].push_back(i);
  }
}

void Neighbours::weigh(std::vector<Term>& terms) const {
  float norm = 0;
  for (auto& [term, amount] : terms) {
    const auto it = weight_.find(term);
    amount *= it == weight_.end() ? unseen_weight_ : it->second;
    norm += amount * amount;
  }
  norm = norm > 0 ? 1 / std::sqrt(norm) : 0;
  for (auto& [term, amount] : terms) amount *= norm;
}

Neighbours::Nearest Neighbours::nearest(const Instruction& instruction, const SymState& state,
                                        std::size_t count, const std::string& without_scenario) const {
  const auto layout = layout_of(instruction, state);
  auto query = terms_of(instruction, state);
  weigh(query);
  std::vector<float> dot(memories_.size(), 0.0f);
  for (const auto& [term, amount] : query)
    if (const auto found = by_term_.find(term); found != by_term_.end())
      for (const auto& [memory, its] : found->second) dot[memory] += amount * its;
  std::vector<std::size_t> common(memories_.size(), 0);
  for (const std::uint32_t fact : layout)
    if (const auto found = by_layout_.find(fact); found != by_layout_.end())
      for (const std::uint32_t memory : found->second) ++common[memory];
  std::vector<Neighbour> all;
  all.reserve(memories_.size());
  for (std::size_t i = 0; i < memories_.size(); ++i) {
    if (!without_scenario.empty() && memories_[i].scenario == without_scenario) continue;
    all.push_back({&memories_[i], dot[i], overlap(common[i], layout.size(), memories_[i].layout.size())});
  }
  // Ties go to the earlier memory.
  const auto best = [&](auto value) {
    const std::size_t wanted = std::min(count, all.size());
    std::partial_sort(all.begin(), all.begin() + static_cast<long>(wanted), all.end(),
                      [&](const Neighbour& x, const Neighbour& y) {
                        const float a = value(x), b = value(y);
                        return a != b ? a > b : x.memory < y.memory;
                      });
    return std::vector<Neighbour>(all.begin(), all.begin() + static_cast<long>(wanted));
  };
  Nearest nearest;
  nearest.by_words = best([](const Neighbour& n) { return n.similarity; });
  nearest.by_room = best(room_weight);
  return nearest;
}

std::vector<Habit> habits(std::span<const Neighbour> neighbours) {
  std::map<SymAction, float> sums;
  float total = 1e-6f;
  for (const Neighbour& neighbour : neighbours) {
    const float weight = room_weight(neighbour);
    total += weight;
    std::set<SymAction> once;
    for (const Memory::Step& step : neighbour.memory->steps) once.insert(step.action);
    for (const SymAction& action : once) sums[action] += weight;
  }
  std::vector<Habit> result;
  for (const auto& [action, weight] : sums) result.push_back({action, weight / total});
  return result;
}

std::vector<NeighbourVote> votes(std::span<const Neighbour> neighbours) {
  using Key = std::tuple<Verb, ClassId, ClassId>;
  std::map<Key, float> sums;
  float total = 1e-6f;
  for (const Neighbour& neighbour : neighbours) {
    const float weight = neighbour.similarity * neighbour.similarity;
    total += weight;
    std::map<Key, bool> once;
    for (const Memory::Step& step : neighbour.memory->steps)
      once[{step.action.verb, step.x_class, step.y_class}] = true;
    const auto steps = static_cast<ClassId>(std::min<std::size_t>(neighbour.memory->steps.size(), 6));
    once[{Verb::kStop, kNoClass, steps}] = true;
    for (const auto& [key, is] : once) sums[key] += weight;
  }
  std::vector<NeighbourVote> result;
  for (const auto& [key, weight] : sums)
    result.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), weight / total});
  return result;
}

std::vector<SymAction> replay(const Memory& memory, const Instruction& instruction) {
  // Mention by mention: the same phrase stays; otherwise the i-th name left over here stands for the i-th
  // there.
  std::vector<std::uint32_t> here_phrases;
  for (const Mention& mention : instruction.mentions) here_phrases.push_back(hash_text(mention.phrase));
  const auto has = [](const std::vector<std::uint32_t>& list, std::uint32_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  std::vector<int> here, there;
  for (std::size_t i = 0; i < here_phrases.size(); ++i)
    if (!has(memory.mentions, here_phrases[i])) here.push_back(static_cast<int>(i));
  for (std::size_t i = 0; i < memory.mentions.size(); ++i)
    if (!has(here_phrases, memory.mentions[i])) there.push_back(static_cast<int>(i));

  std::map<Symbol, Symbol> stands_for;
  for (std::size_t k = 0; k < std::min(here.size(), there.size()); ++k) {
    std::vector<Symbol> objects;
    for (const SeenObject& object : instruction.objects)
      if (object.mention == here[k]) objects.push_back(object.symbol);
    if (objects.empty()) continue;
    std::size_t used = 0;
    const auto carry = [&](Symbol symbol, std::int16_t mention) {
      if (mention != there[k] || stands_for.contains(symbol)) return;
      stands_for[symbol] = objects[std::min(used++, objects.size() - 1)];
    };
    for (const Memory::Step& step : memory.steps)
      carry(step.action.x, step.x_mention), carry(step.action.y, step.y_mention);
  }
  const auto carried = [&](Symbol symbol) {
    const auto it = stands_for.find(symbol);
    return it == stands_for.end() ? symbol : it->second;
  };
  std::vector<SymAction> actions;
  for (const Memory::Step& step : memory.steps)
    actions.push_back({step.action.verb, carried(step.action.x), carried(step.action.y)});
  return actions;
}

namespace {

// Steps by class or by object.
Plans plans(std::span<const Neighbour> neighbours, const Instruction& instruction, bool by_class) {
  const auto class_of = [&](Symbol symbol) {
    const int found = instruction.find(symbol);
    return found < 0 ? kNoClass : instruction.objects[static_cast<std::size_t>(found)].class_id;
  };
  std::vector<Plan> result;
  float total = 1e-6f;
  for (const Neighbour& neighbour : neighbours) {
    Plan plan;
    plan.weight = by_class ? neighbour.similarity * neighbour.similarity : room_weight(neighbour);
    total += plan.weight;
    for (const auto& [verb, x, y] : replay(*neighbour.memory, instruction))
      plan.steps.push_back(by_class ? step_key(verb, class_of(x), class_of(y)) : step_key(verb, x, y));
    result.push_back(std::move(plan));
  }
  for (Plan& plan : result) plan.weight /= total;
  return Plans(result);
}

}  // namespace

Hints make_hints(const Neighbours::Nearest& near, const Instruction& instruction, Reading reading) {
  return {.votes = votes(near.by_words),
          .habits = habits(near.by_room),
          .reading = std::move(reading),
          .plans_by_words = plans(near.by_words, instruction, true),
          .plans_by_room = plans(near.by_room, instruction, false)};
}

}  // namespace goalnet::inference
