#include "components/planner/derived_layers.h"

#include <algorithm>
#include <set>
#include <utility>

namespace goalnet::planner {
namespace {

struct Use {
  PredicateId from, to;
  bool negative;
};

void collect(PredicateId from, const Formula& formula, bool negative, std::vector<Use>* uses) {
  if (formula.kind == Formula::Kind::kAtom) uses->push_back({from, formula.atom.predicate, negative});
  const bool inner = negative != (formula.kind == Formula::Kind::kNot);
  for (const Formula& child : formula.children) collect(from, child, inner, uses);
}

std::size_t nodes(const Formula& formula) {
  std::size_t count = 1;
  for (const Formula& child : formula.children) count += nodes(child);
  return count;
}

// Definitions that would be longer than this with everything written out are computed instead. [nodes of the
// formula]
constexpr std::size_t kLongestWrittenOut = 1000;

class Layers {
 public:
  Layers(Domain& domain, const std::stop_token& stop)
      : domain_(domain),
        stop_(stop),
        uses_(static_cast<std::size_t>(domain.predicates.size())),
        reaches_(uses_.size()),
        length_(uses_.size(), 0) {
    for (const DerivedPredicate& definition : domain.derived) {
      collect(definition.predicate, definition.body, false, &uses_[at(definition.predicate)]);
      length_[at(definition.predicate)] += nodes(definition.body);
    }
  }

  std::optional<PredicateId> assign() {
    domain_.layer.assign(uses_.size(), Domain::kGiven);
    find_reaches();
    for (const auto& uses : uses_) {
      for (const Use& use : uses) {
        if (use.negative && (use.from == use.to || leads(use.to, use.from))) return use.from;
      }
    }
    for (const DerivedPredicate& definition : domain_.derived) {
      const bool circular = leads(definition.predicate, definition.predicate);
      domain_.layer[at(definition.predicate)] = circular ? 0 : Domain::kWrittenOut;
    }
    for (const DerivedPredicate& definition : domain_.derived) {
      if (stop_.stop_requested()) return std::nullopt;
      measure(definition.predicate);
    }
    raise();
    return std::nullopt;
  }

 private:
  static std::size_t at(PredicateId predicate) { return static_cast<std::size_t>(predicate); }
  bool leads(PredicateId from, PredicateId to) const {
    return !reaches_[at(from)].empty() && reaches_[at(from)][at(to)] != 0;
  }

  // What each derived predicate leads to, directly or through others.
  void find_reaches() {
    for (const DerivedPredicate& definition : domain_.derived) {
      auto& mine = reaches_[at(definition.predicate)];
      if (!mine.empty()) continue;
      if (stop_.stop_requested()) return;
      mine.assign(uses_.size(), 0);
      std::vector<PredicateId> open = {definition.predicate};
      while (!open.empty()) {
        const PredicateId current = open.back();
        open.pop_back();
        for (const Use& use : uses_[at(current)]) {
          if (mine[at(use.to)] != 0) continue;
          mine[at(use.to)] = 1;
          open.push_back(use.to);
        }
      }
    }
  }

  // How long a definition is once the definitions it uses are written out; those that get too long are
  // computed. Without recursion, because chains can be long.
  void measure(PredicateId first) {
    std::vector<std::pair<PredicateId, std::size_t>> open = {{first, 0}};
    while (!open.empty()) {
      const PredicateId current = open.back().first;
      auto& uses = uses_[at(current)];
      if (domain_.layer[at(current)] != Domain::kWrittenOut || measured_.count(current) != 0) {
        open.pop_back();
        continue;
      }
      if (open.back().second < uses.size()) {
        open.emplace_back(uses[open.back().second++].to, 0);
        continue;
      }
      std::size_t& length = length_[at(current)];
      for (const Use& use : uses) {
        if (domain_.layer[at(use.to)] == Domain::kWrittenOut) length += length_[at(use.to)];
        if (length > kLongestWrittenOut) break;
      }
      if (length > kLongestWrittenOut) domain_.layer[at(current)] = 0;
      measured_.insert(current);
      open.pop_back();
    }
  }

  // Every computed predicate above those that it needs and that do not need it.
  void raise() {
    std::vector<PredicateId> computed;
    for (PredicateId p = 0; p < domain_.predicates.size(); ++p) {
      if (domain_.recursive(p)) computed.push_back(p);
    }
    for (bool grows = true; grows;) {
      grows = false;
      for (const PredicateId p : computed) {
        if (stop_.stop_requested()) return;
        for (const PredicateId q : computed) {
          if (!leads(p, q)) continue;
          const std::int32_t least = domain_.layer[at(q)] + (leads(q, p) ? 0 : 1);
          if (domain_.layer[at(p)] >= least) continue;
          domain_.layer[at(p)] = least;
          grows = true;
        }
      }
    }
  }

  Domain& domain_;
  const std::stop_token& stop_;
  std::vector<std::vector<Use>> uses_;              // by predicate: what its definitions read
  std::vector<std::vector<std::uint8_t>> reaches_;  // by predicate; empty: not derived
  std::vector<std::size_t> length_;                 // by predicate
  std::set<PredicateId> measured_;
};

}  // namespace

std::optional<PredicateId> assign_layers(Domain& domain, const std::stop_token& stop) {
  return Layers(domain, stop).assign();
}

}  // namespace goalnet::planner
