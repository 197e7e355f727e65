#include "components/planner/novelty_search.h"

#include <algorithm>
#include <bit>

namespace goalnet::planner {
namespace {
constexpr std::size_t kMostAtomsForPairs = 3000;  // 1.1 MB for each number of missing landmarks
constexpr std::int64_t kStatesPerPlan = 40;       // what a relaxed plan costs, in states made
}  // namespace

bool NoveltySearch::is_new(const GroundTask& task, const Word* state, std::size_t i) {
  const std::size_t words = task.words();
  if (seen_true_.size() <= i) {
    seen_true_.resize(i + 1);
    seen_false_.resize(i + 1);
  }
  seen_true_[i].resize(words, 0);
  seen_false_[i].resize(words, 0);
  Word fresh = 0;
  for (std::size_t w = 0; w < words; ++w) {
    fresh |= (state[w] & ~seen_true_[i][w]) | (~state[w] & ~seen_false_[i][w]);
    seen_true_[i][w] |= state[w];
    seen_false_[i][w] |= ~state[w];
  }
  return fresh != 0;
}

bool NoveltySearch::is_new_pair(const GroundTask& task, const Word* state, const Word* before,
                                std::size_t i) {
  if (task.initial.size() > kMostAtomsForPairs) return false;
  const std::size_t words = task.words();
  if (seen_pairs_.size() <= i) seen_pairs_.resize(i + 1);
  std::vector<Word>& seen = seen_pairs_[i];
  if (seen.empty()) {
    if (pair_bytes_ > most_pair_bytes_) return false;
    seen.resize(task.initial.size() * words, 0);
    pair_bytes_ += seen.size() * sizeof(Word);
  }
  bool any = false;
  for (std::size_t w = 0; w < words; ++w) {
    for (Word atoms = before == nullptr ? state[w] : state[w] & ~before[w]; atoms != 0; atoms &= atoms - 1) {
      const std::size_t a = 64 * w + static_cast<std::size_t>(std::countr_zero(atoms));
      Word* const row = seen.data() + a * words;
      for (std::size_t v = 0; v < words; ++v) {
        Word fresh = state[v] & ~row[v];
        any = any || fresh != 0;
        row[v] |= fresh;
        for (; fresh != 0; fresh &= fresh - 1) {
          const std::size_t b = 64 * v + static_cast<std::size_t>(std::countr_zero(fresh));
          seen[b * words + (a >> 6)] |= Word{1} << (a & 63u);
        }
      }
    }
  }
  return any;
}

void NoveltySearch::forget_seen() {
  seen_true_.clear();
  seen_false_.clear();
  seen_pairs_.clear();
  pair_bytes_ = 0;
}

bool NoveltySearch::guide(const GroundTask& task, std::int32_t id, RelaxedPlanner& plans, Budget& budget,
                          Statistics& statistics) {
  Node& node = nodes_[static_cast<std::size_t>(id)];
  const Word* state = states_.state(id);
  if (node.parent >= 0) {
    const Node& parent = nodes_[static_cast<std::size_t>(node.parent)];
    if (node.missing >= parent.missing) {
      node.guide = parent.guide;
      node.came = parent.came;
      const auto& facts = guides_[static_cast<std::size_t>(node.guide)].facts;
      for (std::size_t i = 0; i < facts.size(); ++i) {
        if (literal_holds(state, facts[i])) node.came[i >> 6] |= Word{1} << (i & 63u);
      }
      return true;
    }
  }
  ++statistics.evaluated;
  if (plans.evaluate(state, budget) >= RelaxedPlanner::kDeadEnd) return false;
  node.guide = static_cast<std::int32_t>(guides_.size());
  auto& facts = guides_.emplace_back().facts;
  for (const std::int32_t number : plans.actions()) {
    for (const GroundEffect& effect : task.effects_of(task.actions[static_cast<std::size_t>(number)])) {
      if (facts.size() < 64 * kGuideWords && (effect.literal & 1) == 0 &&
          !literal_holds(state, effect.literal) &&
          std::find(facts.begin(), facts.end(), effect.literal) == facts.end()) {
        facts.push_back(effect.literal);
      }
    }
  }
  return true;
}

std::size_t NoveltySearch::class_of(const Node& node) const {
  const auto missing = static_cast<std::size_t>(node.missing);
  if (node.guide < 0) return missing;
  std::size_t came = 0;
  for (const Word word : node.came) came += static_cast<std::size_t>(std::popcount(word));
  return missing * (64 * kGuideWords + 1) + came;
}

std::int32_t NoveltySearch::push(const GroundTask& task, Landmarks& landmarks, std::int32_t id,
                                 bool committed, RelaxedPlanner* plans, Budget& budget,
                                 Statistics& statistics) {
  const std::int32_t missing = landmarks.missing(states_.state(id), reached(id));
  Node& node = nodes_[static_cast<std::size_t>(id)];
  node.missing = missing;
  if (plans != nullptr && !guide(task, id, *plans, budget, statistics)) return missing;
  const std::size_t alike = class_of(node);
  const bool as_before = node.parent >= 0 && class_of(nodes_[static_cast<std::size_t>(node.parent)]) == alike;
  const Word* before = as_before ? states_.state(node.parent) : nullptr;
  const bool new_literal = is_new(task, states_.state(id), alike);
  const bool new_pair = is_new_pair(task, states_.state(id), before, alike);
  heap_.push({new_literal ? 0 : new_pair ? 1 : 2, committed ? 0 : missing, id});
  return missing;
}

std::int64_t NoveltySearch::bytes() const {
  return states_.bytes() +
         static_cast<std::int64_t>(reached_.bytes() + heap_.bytes() + nodes_.bytes() + pair_bytes_);
}

NoveltySearch::Result NoveltySearch::search(const GroundTask& task, Landmarks& landmarks, const Word* initial,
                                            std::int64_t upper_bound, std::int64_t most_states,
                                            std::int64_t most_bytes, bool committed, RelaxedPlanner* plans,
                                            Budget& budget, Statistics& statistics, const Pruning& pruning) {
  const std::size_t words = std::max<std::size_t>(task.words(), 1);
  successors_.restart(task);
  pruning.restart(states_, words);
  nodes_.clear();
  heap_.clear();
  forget_seen();
  guides_.clear();
  most_pair_bytes_ = most_bytes > 0 ? static_cast<std::size_t>(most_bytes) / 2 : SIZE_MAX;
  const std::int64_t evaluated_before = statistics.evaluated;
  landmark_words_ = landmarks.words();
  reached_.restart(landmark_words_);
  next_.resize(words);
  next_reached_.assign(landmark_words_, 0);
  plan_.clear();
  bool is_new_state = false;
  pruning.add(states_, initial, key_, &is_new_state);
  nodes_.push_back({});
  landmarks.note(initial, next_reached_.data());
  reached_.push_back(next_reached_.data());
  std::int32_t fewest = push(task, landmarks, 0, committed, plans, budget, statistics);
  Result result = Result::kExhausted;
  while (!heap_.empty() && result == Result::kExhausted) {
    const std::int32_t id = heap_.pop().node;
    ++statistics.expanded;
    successors_.applicable(states_.state(id), &applicable_);
    for (const std::int32_t number : applicable_) {
      if (budget.poll()) {
        result = Result::kStopped;
        break;
      }
      const GroundAction& action = task.actions[static_cast<std::size_t>(number)];
      const std::int64_t g = nodes_[static_cast<std::size_t>(id)].g + action.cost;
      if (g >= upper_bound) continue;
      apply_action(task, states_.state(id), action, next_.data());
      ++statistics.generated;
      if (pruning.dead.dead_after(task, action, next_.data())) continue;
      const std::int32_t child = pruning.add(states_, next_.data(), key_, &is_new_state);
      if (!is_new_state) continue;
      nodes_.push_back({g, id, number});
      if (all_hold(task, next_.data(), task.goal)) {
        for (std::int32_t at = child; nodes_[static_cast<std::size_t>(at)].parent >= 0;
             at = nodes_[static_cast<std::size_t>(at)].parent) {
          plan_.push_back(nodes_[static_cast<std::size_t>(at)].action);
        }
        std::reverse(plan_.begin(), plan_.end());
        result = Result::kFound;
        break;
      }
      std::copy_n(reached(id), landmark_words_, next_reached_.begin());
      landmarks.note(next_.data(), next_reached_.data());
      reached_.push_back(next_reached_.data());
      const std::int32_t missing = push(task, landmarks, child, committed, plans, budget, statistics);
      if (missing >= fewest) continue;
      fewest = missing;
      if (!committed) continue;
      heap_.clear();
      heap_.push({0, 0, child});
      forget_seen();
      break;
    }
    const std::int64_t spent = states_.size() + kStatesPerPlan * (statistics.evaluated - evaluated_before);
    if (result == Result::kExhausted && spent > most_states) result = Result::kLimit;
    if (result == Result::kExhausted && most_bytes > 0 && bytes() > most_bytes) result = Result::kMemory;
  }
  if (committed && result == Result::kExhausted) result = Result::kLimit;
  statistics.peak_bytes = std::max(statistics.peak_bytes, bytes());
  return result;
}

}  // namespace goalnet::planner
