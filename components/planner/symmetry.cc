#include "components/planner/symmetry.h"

#include <algorithm>
#include <numeric>

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostActions = 1500;
constexpr std::size_t kMostTrials = 120;
constexpr int kMostRounds = 12;

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t h = (a ^ (b + 0x9E3779B97F4A7C15ULL + (a << 6) + (a >> 2))) * 0xD6E8FEB86659FD93ULL;
  h ^= h >> 32;
  return h * 0xD6E8FEB86659FD93ULL;
}

std::size_t distinct(std::vector<std::uint64_t> colours) {
  std::sort(colours.begin(), colours.end());
  return static_cast<std::size_t>(std::unique(colours.begin(), colours.end()) - colours.begin());
}

}  // namespace

// Colours say which atoms could be images of each other: an atom's new colour combines its old one with the
// roles it has in actions, and these with the colours of all that the actions touch.
Symmetry::Colours Symmetry::refined(const GroundTask& task, Colours colours, Budget& budget) const {
  std::size_t classes = distinct(colours);
  Colours next(colours.size());
  for (int round = 0; round < kMostRounds; ++round) {
    next = colours;
    const auto colour = [&](Literal literal) {
      return mix(colours[static_cast<std::size_t>(literal >> 1)], static_cast<std::uint64_t>(literal & 1));
    };
    for (const GroundAction& action : task.actions) {
      if (budget.poll()) return colours;
      std::uint64_t needs = 0, all = mix(7, static_cast<std::uint64_t>(action.cost));
      for (const ConditionId c : task.preconditions(action)) needs += mix(1, colour(c));
      all += mix(2, needs);
      const auto of_effect = [&](const GroundEffect& effect) {
        std::uint64_t when = 0;
        for (const ConditionId c : task.conditions_of(effect)) when += mix(3, colour(c));
        return mix(mix(4, colour(effect.literal)), when);
      };
      for (const GroundEffect& effect : task.effects_of(action)) all += of_effect(effect);
      const auto touch = [&](Literal literal, std::uint64_t role) {
        next[static_cast<std::size_t>(literal >> 1)] +=
            mix(mix(all, role), static_cast<std::uint64_t>(literal & 1));
      };
      for (const ConditionId c : task.preconditions(action)) touch(c, 11);
      for (const GroundEffect& effect : task.effects_of(action)) {
        const std::uint64_t role = of_effect(effect);
        touch(effect.literal, mix(12, role));
        for (const ConditionId c : task.conditions_of(effect)) touch(c, mix(13, role));
      }
    }
    colours.swap(next);
    const std::size_t now = distinct(colours);
    if (now == classes) break;
    classes = now;
  }
  return colours;
}

bool Symmetry::match(const Colours& left, const Colours& right, Permutation* permutation) {
  const std::size_t count = left.size();
  const auto by_colour = [count](const Colours& colours) {
    Permutation order(count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      const auto x = static_cast<std::size_t>(a), y = static_cast<std::size_t>(b);
      return colours[x] != colours[y] ? colours[x] < colours[y] : a < b;
    });
    return order;
  };
  const Permutation from = by_colour(left), to = by_colour(right);
  permutation->assign(count, -1);
  for (std::size_t begin = 0; begin < count;) {
    const std::uint64_t colour = left[static_cast<std::size_t>(from[begin])];
    std::size_t end = begin;
    while (end < count && left[static_cast<std::size_t>(from[end])] == colour) ++end;
    Permutation ours(from.begin() + static_cast<std::ptrdiff_t>(begin),
                     from.begin() + static_cast<std::ptrdiff_t>(end));
    Permutation theirs;
    for (std::size_t i = begin; i < end; ++i) {
      if (right[static_cast<std::size_t>(to[i])] != colour) return false;
      theirs.push_back(to[i]);
    }
    // What is in both classes stays; the rest is paired in order.
    Permutation only_ours, only_theirs;
    std::set_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                        std::back_inserter(only_ours));
    std::set_difference(theirs.begin(), theirs.end(), ours.begin(), ours.end(),
                        std::back_inserter(only_theirs));
    for (const std::int32_t atom : ours) (*permutation)[static_cast<std::size_t>(atom)] = atom;
    for (std::size_t i = 0; i < only_ours.size(); ++i) {
      (*permutation)[static_cast<std::size_t>(only_ours[i])] = only_theirs[i];
    }
    begin = end;
  }
  return true;
}

std::vector<std::vector<std::int32_t>> Symmetry::description(const GroundTask& task,
                                                             const Permutation& permutation, Budget& budget) {
  const auto image = [&](Literal literal) {
    return 2 * permutation[static_cast<std::size_t>(literal >> 1)] + (literal & 1);
  };
  std::vector<std::vector<std::int32_t>> result;
  for (const GroundAction& action : task.actions) {
    if (budget.poll()) return {};
    std::vector<std::int32_t> needs;
    for (const ConditionId c : task.preconditions(action)) needs.push_back(image(c));
    std::sort(needs.begin(), needs.end());
    std::vector<std::vector<std::int32_t>> effects;
    for (const GroundEffect& effect : task.effects_of(action)) {
      std::vector<std::int32_t> entry;
      for (const ConditionId c : task.conditions_of(effect)) entry.push_back(image(c));
      std::sort(entry.begin(), entry.end());
      entry.insert(entry.begin(), image(effect.literal));
      effects.push_back(std::move(entry));
    }
    std::sort(effects.begin(), effects.end());
    std::vector<std::int32_t> all = {static_cast<std::int32_t>(action.cost >> 31),
                                     static_cast<std::int32_t>(action.cost & 0x7fffffff)};
    all.insert(all.end(), needs.begin(), needs.end());
    for (const auto& effect : effects) {
      all.push_back(-1);
      all.insert(all.end(), effect.begin(), effect.end());
    }
    result.push_back(std::move(all));
  }
  std::vector<std::int32_t> goal = {-2};
  for (const ConditionId c : task.goal) goal.push_back(image(c));
  std::sort(goal.begin(), goal.end());
  result.push_back(std::move(goal));
  std::sort(result.begin(), result.end());
  return result;
}

std::int64_t Symmetry::find(const GroundTask& task, Budget& budget) {
  generators_.clear();
  words_ = std::max<std::size_t>(task.words(), 1);
  trial_.resize(words_);
  if (!task.junctions.empty() || !task.axioms.empty() || task.actions.size() > kMostActions) return 0;
  const std::size_t atoms = task.initial.size();
  Colours start(atoms, 1);
  for (const ConditionId c : task.goal) {
    auto& colour = start[static_cast<std::size_t>(c >> 1)];
    colour = mix(colour, static_cast<std::uint64_t>(c & 1) + 5);
  }
  const Colours stable = refined(task, start, budget);
  Permutation order(atoms), identity(atoms);
  std::iota(identity.begin(), identity.end(), 0);
  order = identity;
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const auto x = static_cast<std::size_t>(a), y = static_cast<std::size_t>(b);
    return stable[x] != stable[y] ? stable[x] < stable[y] : a < b;
  });
  const auto original = description(task, identity, budget);
  std::size_t trials = 0;
  for (std::size_t i = 0; i + 1 < atoms && trials < kMostTrials && !budget.check(); ++i) {
    const std::int32_t one = order[i], two = order[i + 1];
    if (stable[static_cast<std::size_t>(one)] != stable[static_cast<std::size_t>(two)]) continue;
    const bool known = std::any_of(generators_.begin(), generators_.end(), [&](const Generator& generator) {
      return std::find(generator.moves.begin(), generator.moves.end(), std::pair{one, two}) !=
             generator.moves.end();
    });
    if (known) continue;
    ++trials;
    Colours left = stable, right = stable;
    left[static_cast<std::size_t>(one)] = right[static_cast<std::size_t>(two)] = 99;
    Permutation permutation;
    if (!match(refined(task, left, budget), refined(task, right, budget), &permutation)) continue;
    const bool exact = description(task, permutation, budget) == original;
    if (budget.stopped()) break;
    if (!exact) continue;
    Generator generator;
    for (std::size_t atom = 0; atom < atoms; ++atom) {
      if (permutation[atom] != static_cast<std::int32_t>(atom)) {
        generator.moves.emplace_back(static_cast<std::int32_t>(atom), permutation[atom]);
      }
    }
    if (!generator.moves.empty()) generators_.push_back(std::move(generator));
  }
  return count();
}

void Symmetry::canonical(const Word* state, Word* key) {
  std::copy_n(state, words_, key);
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const Generator& generator : generators_) {
      std::copy_n(key, words_, trial_.begin());
      for (const auto& [from, to] : generator.moves) {
        const bool holds =
            (key[static_cast<std::size_t>(from) >> 6] >> (static_cast<std::size_t>(from) & 63u)) & 1u;
        make_true(trial_.data(), 2 * to + (holds ? 0 : 1));
      }
      if (std::lexicographical_compare(trial_.begin(), trial_.end(), key, key + words_)) {
        std::copy(trial_.begin(), trial_.end(), key);
        smaller = true;
      }
    }
  }
}

}  // namespace goalnet::planner
