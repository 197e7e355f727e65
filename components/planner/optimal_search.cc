#include "components/planner/optimal_search.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
// Looking for symmetries costs about as much as this many expansions, and most problems end before.
constexpr std::int64_t kExpansionsBeforeSymmetry = 30;
}  // namespace

void OptimalSearch::push(std::int32_t id) {
  const Node& node = nodes_[static_cast<std::size_t>(id)];
  heap_.push({node.g + node.h, node.h, serial_++, {id, node.g}});
}

bool OptimalSearch::pop(Entry* entry) {
  while (!heap_.empty()) {
    const HeapEntry top = heap_.pop();
    const Node& node = nodes_[static_cast<std::size_t>(top.entry.node)];
    if (node.closed || node.g != top.entry.g || node.g + node.h != top.f) continue;  // outdated
    *entry = top.entry;
    return true;
  }
  return false;
}

void OptimalSearch::generate(std::int32_t parent, std::int32_t action) {
  const GroundAction& ground = task_->actions[static_cast<std::size_t>(action)];
  apply_action(*task_, states_.state(parent), ground, next_.data());
  const Word* key = next_.data();
  if (symmetry_used_) {
    symmetry_.canonical(next_.data(), key_.data());
    key = key_.data();
  }
  bool is_new = false;
  std::int32_t id = states_.add(next_.data(), key, &is_new);
  if (is_new) nodes_.push_back({});
  ++generated_;
  const std::int64_t g = nodes_[static_cast<std::size_t>(parent)].g + ground.cost;
  if (!is_new) {
    Node& old = nodes_[static_cast<std::size_t>(id)];
    if (g >= old.g || old.h >= LmCut::kDeadEnd) return;
    if (symmetry_used_) {
      // The known state may be a symmetric variant of this one; its children lead on from there, so it stays
      // as it is, and this one takes its place.
      Node copy = old;
      old.closed = true;
      id = states_.add_variant(next_.data(), id);
      nodes_.push_back(copy);
    }
  }
  Node& node = nodes_[static_cast<std::size_t>(id)];
  const std::int64_t inherited =
      std::max<std::int64_t>(0, nodes_[static_cast<std::size_t>(parent)].h - ground.cost);
  node.g = g;
  node.parent = parent;
  node.action = action;
  node.closed = false;
  node.h = is_new ? inherited : std::max(node.h, inherited);
  if (node.g + node.h < upper_bound_) {
    push(id);
  } else {
    bound_used_ = true;
  }
}

void OptimalSearch::extract(std::int32_t id) {
  plan_.clear();
  while (nodes_[static_cast<std::size_t>(id)].parent >= 0) {
    plan_.push_back(nodes_[static_cast<std::size_t>(id)].action);
    id = nodes_[static_cast<std::size_t>(id)].parent;
  }
  std::reverse(plan_.begin(), plan_.end());
}

std::int64_t OptimalSearch::bytes() const {
  return states_.bytes() + static_cast<std::int64_t>(nodes_.bytes() + heap_.bytes());
}

void OptimalSearch::start(const GroundTask& task, LmCut& lm_cut, const Word* initial,
                          std::int64_t initial_estimate, Budget& budget) {
  task_ = &task;
  lm_cut_ = &lm_cut;
  const std::size_t words = std::max<std::size_t>(task.words(), 1);
  symmetry_used_ = bound_used_ = false;
  states_.restart(words, true);
  nodes_.clear();
  heap_.clear();
  serial_ = generated_ = expanded_ = 0;
  next_.resize(words);
  key_.resize(words);
  stubborn_.restart(task, budget);
  lower_bound_ = initial_estimate;
  bool is_new = false;
  states_.add(initial, initial, &is_new);
  nodes_.push_back({0, initial_estimate, -1, -1, true, false});
  push(0);
}

OptimalSearch::Result OptimalSearch::resume(const SearchLimits& limits, Budget& budget,
                                            Statistics& statistics) {
  const GroundTask& task = *task_;
  upper_bound_ = limits.upper_bound;
  Result result = Result::kExhausted;
  const std::int64_t expanded_before = expanded_, generated_before = generated_;
  Entry entry{};
  while (pop(&entry)) {
    if (budget.poll()) {
      push(entry.node);
      result = Result::kStopped;
      break;
    }
    const auto id = static_cast<std::size_t>(entry.node);
    if (nodes_[id].g + nodes_[id].h >= upper_bound_) {  // and so is everything behind it
      bound_used_ = true;
      break;
    }
    if (all_hold(task, states_.state(entry.node), task.goal)) {
      lower_bound_ = std::max(lower_bound_, nodes_[id].g);
      extract(entry.node);
      result = Result::kFound;
      break;
    }
    if (!nodes_[id].evaluated) {
      ++statistics.evaluated;
      const std::int64_t h = std::max(nodes_[id].h, lm_cut_->evaluate(states_.state(entry.node), budget));
      const bool worse = h > nodes_[id].h;
      nodes_[id].h = h;
      nodes_[id].evaluated = true;
      if (h >= LmCut::kDeadEnd) continue;  // stays known, is never expanded
      if (nodes_[id].g + h >= upper_bound_) {
        bound_used_ = true;
        continue;
      }
      if (worse) {
        push(entry.node);
        continue;
      }
    }
    lower_bound_ = std::max(lower_bound_, nodes_[id].g + nodes_[id].h);
    nodes_[id].closed = true;
    ++expanded_;
    if (expanded_ == kExpansionsBeforeSymmetry) {
      symmetry_used_ = symmetry_.find(task, budget) > 0;
      statistics.symmetries = symmetry_.count();
    }
    const auto& actions = stubborn_.applicable(states_.state(entry.node), budget);
    if (budget.stopped()) {  // the set is incomplete: this state's turn comes again
      nodes_[id].closed = false;
      push(entry.node);
      result = Result::kStopped;
      break;
    }
    for (const std::int32_t action : actions) generate(entry.node, action);
    if (limits.nodes > 0 && expanded_ >= limits.nodes) {
      result = Result::kNodeLimit;
      break;
    }
    if (limits.bytes > 0 && (expanded_ & 255) == 0 && bytes() > limits.bytes) {
      result = Result::kMemoryLimit;
      break;
    }
  }
  if (result == Result::kExhausted) lower_bound_ = std::max(lower_bound_, upper_bound_);
  statistics.expanded += expanded_ - expanded_before;
  statistics.generated += generated_ - generated_before;
  statistics.peak_bytes = std::max(statistics.peak_bytes, bytes());
  return result;
}

}  // namespace goalnet::planner
