#include "components/goalnet/ranker/neighbours.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace goalnet::inference {
namespace {

const Instruction& seen(const Example& example, bool grounding) { return grounding ? example.given : example.none; }

// Words, pairs, what is held at the start: the terms by which instructions are compared.
template <class Act>
void each_term(const Instruction& instruction, const SymState& state, Act act) {
  for (const std::uint32_t word : instruction.unigrams) act(word, 1.0f);
  for (const std::uint32_t pair : instruction.bigrams) act(pair ^ 0x5bd1e995u, 0.7f);
  act(instruction.first_verb ^ 0x1234567u, 0.5f);
  for (const SeenObject& object : instruction.objects) {
    if (state.holds(object.symbol)) act(0x70000000u + object.class_id, 0.4f);
    if (object.level >= NameLevel::kName || object.grounded)
      act(0x60000000u + object.class_id, 1.0f / static_cast<float>(std::max<int>(1, object.of_class)));
  }
}

}  // namespace

Neighbours::Neighbours(std::vector<const Example*> examples, bool grounding) : grounding_(grounding) {
  std::unordered_map<std::uint32_t, int> documents;
  for (const Example* example : examples) {
    std::map<std::uint32_t, bool> once;
    each_term(seen(*example, grounding), example->states.front(), [&](std::uint32_t term, float) { once[term] = true; });
    for (const auto& [term, is] : once) ++documents[term];
  }
  const float n = static_cast<float>(examples.size()) + 1;
  for (const auto& [term, count] : documents) weight_[term] = std::log(n / (static_cast<float>(count) + 0.5f));
  unseen_weight_ = std::log(n / 0.5f);
  for (const Example* example : examples)
    rows_.push_back({example, vector_of(seen(*example, grounding), example->states.front())});
}

std::vector<std::pair<std::uint32_t, float>> Neighbours::vector_of(const Instruction& instruction,
                                                                   const SymState& state) const {
  std::map<std::uint32_t, float> sums;
  each_term(instruction, state, [&](std::uint32_t term, float amount) {
    const auto it = weight_.find(term);
    sums[term] += amount * (it == weight_.end() ? unseen_weight_ : it->second);
  });
  float norm = 0;
  for (const auto& [term, value] : sums) norm += value * value;
  norm = norm > 0 ? 1 / std::sqrt(norm) : 0;
  std::vector<std::pair<std::uint32_t, float>> vector(sums.begin(), sums.end());
  for (auto& [term, value] : vector) value *= norm;
  return vector;
}

std::vector<Neighbour> Neighbours::nearest(const Instruction& instruction, const SymState& state, std::size_t count,
                                           const std::string& without_scenario) const {
  const auto query = vector_of(instruction, state);
  std::vector<Neighbour> all;
  all.reserve(rows_.size());
  for (const Row& row : rows_) {
    if (!without_scenario.empty() && row.example->scenario == without_scenario) continue;
    float dot = 0;
    for (auto a = query.begin(), b = row.vector.begin(); a != query.end() && b != row.vector.end();) {
      if (a->first < b->first) {
        ++a;
      } else if (b->first < a->first) {
        ++b;
      } else {
        dot += a++->second * b++->second;
      }
    }
    all.push_back({row.example, dot});
  }
  const auto better = [](const Neighbour& a, const Neighbour& b) {
    return a.similarity != b.similarity ? a.similarity > b.similarity : a.example->id < b.example->id;
  };
  count = std::min(count, all.size());
  std::partial_sort(all.begin(), all.begin() + static_cast<long>(count), all.end(), better);
  all.resize(count);
  return all;
}

std::vector<NeighbourVote> votes(const std::vector<Neighbour>& neighbours, bool grounding) {
  std::map<std::tuple<Verb, ClassId, ClassId>, float> sums;
  float total = 1e-6f;
  for (const Neighbour& neighbour : neighbours) {
    const float weight = neighbour.similarity * neighbour.similarity;
    total += weight;
    const Instruction& other = seen(*neighbour.example, grounding);
    const auto class_of = [&](Symbol symbol) {
      const int found = other.find(symbol);
      return found < 0 ? kNoClass : other.objects[static_cast<std::size_t>(found)].class_id;
    };
    std::map<std::tuple<Verb, ClassId, ClassId>, bool> once;
    for (const auto& [step, action] : neighbour.example->macros)
      once[{action.verb, class_of(action.x), class_of(action.y)}] = true;
    const auto steps = static_cast<ClassId>(std::min<std::size_t>(neighbour.example->macros.size(), 6));
    once[{Verb::kStop, kNoClass, steps}] = true;
    for (const auto& [key, is] : once) sums[key] += weight;
  }
  std::vector<NeighbourVote> result;
  for (const auto& [key, weight] : sums)
    result.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), weight / total});
  return result;
}

std::vector<SymAction> replay(const Example& neighbour, const Instruction& instruction, bool grounding) {
  const Instruction& other = seen(neighbour, grounding);
  // Mention by mention: the same phrase stays; otherwise the i-th name left over here stands for the i-th there.
  std::vector<int> free_here, free_there;
  const auto has = [](const Instruction& in, const std::string& phrase) {
    return std::any_of(in.mentions.begin(), in.mentions.end(), [&](const Mention& m) { return m.phrase == phrase; });
  };
  for (std::size_t i = 0; i < instruction.mentions.size(); ++i)
    if (!has(other, instruction.mentions[i].phrase)) free_here.push_back(static_cast<int>(i));
  for (std::size_t i = 0; i < other.mentions.size(); ++i)
    if (!has(instruction, other.mentions[i].phrase)) free_there.push_back(static_cast<int>(i));
  std::map<Symbol, Symbol> stands_for;
  for (std::size_t k = 0; k < std::min(free_here.size(), free_there.size()); ++k) {
    std::vector<Symbol> here, there;
    for (const SeenObject& object : instruction.objects)
      if (object.mention == free_here[k]) here.push_back(object.symbol);
    for (const SeenObject& object : other.objects)
      if (object.mention == free_there[k]) there.push_back(object.symbol);
    for (std::size_t i = 0; i < there.size() && !here.empty(); ++i)
      stands_for[there[i]] = here[std::min(i, here.size() - 1)];
  }
  const auto carried = [&](Symbol symbol) {
    const auto it = stands_for.find(symbol);
    return it == stands_for.end() ? symbol : it->second;
  };
  std::vector<SymAction> actions;
  for (const auto& [step, action] : neighbour.macros)
    actions.push_back({action.verb, carried(action.x), carried(action.y)});
  return actions;
}

}  // namespace goalnet::inference
