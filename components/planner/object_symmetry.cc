#include "components/planner/object_symmetry.h"

#include <algorithm>

#include "components/planner/hash_index.h"

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostPartners =
    4;  // an object is compared with the last of so many classes that look alike
constexpr std::int64_t kMostWork = 20'000'000;  // conditions and effects looked at: about 0.1 s
constexpr std::size_t kMostObjects = 20'000, kMostActions = 200'000;  // more would take long to let go of
constexpr int kMostRounds = 3;                                        // sorting one class may disturb another

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t h = (a ^ (b + 0x9E3779B97F4A7C15ULL + (a << 6) + (a >> 2))) * 0xD6E8FEB86659FD93ULL;
  return h ^ (h >> 32);
}

bool bit(const Word* state, std::int32_t atom) {
  return ((state[static_cast<std::size_t>(atom) >> 6] >> (static_cast<std::size_t>(atom) & 63u)) & 1u) != 0;
}

// Finds and verifies swaps of two objects.
class Swaps {
 public:
  Swaps(const GroundTask& task, Budget& budget) : task_(task), budget_(budget) {}

  // False if time or work ran out.
  bool prepare() {
    const auto atoms = static_cast<std::size_t>(task_.atoms.size());
    is_goal_.assign(2 * atoms, 0);
    for (const ConditionId goal : task_.goal) is_goal_[static_cast<std::size_t>(goal)] = 1;
    for (std::size_t atom = 0; atom < atoms; ++atom) {
      if (budget_.poll()) return false;
      const AtomRef ref = task_.atoms[static_cast<std::int32_t>(atom)];
      for (std::size_t i = 0; i < ref.arguments.size(); ++i) {
        const auto object = static_cast<std::size_t>(ref.arguments[i]);
        if (object >= kMostObjects) return false;
        if (object >= looks_.size()) grow(object + 1);
        if (atoms_of_[object].empty() || atoms_of_[object].back() != static_cast<std::int32_t>(atom))
          atoms_of_[object].push_back(static_cast<std::int32_t>(atom));
        looks_[object] += mix(mix(static_cast<std::uint64_t>(ref.predicate), i),
                              is_goal_[2 * atom] + 2u * is_goal_[2 * atom + 1]);
      }
    }
    image_.resize(atoms);
    for (std::size_t atom = 0; atom < atoms; ++atom) image_[atom] = static_cast<std::int32_t>(atom);
    actions_of_.resize(looks_.size());
    for (std::size_t a = 0; a < task_.actions.size(); ++a) {
      const auto id = static_cast<std::int32_t>(a);
      const GroundAction& action = task_.actions[a];
      contents_.push_back(content(action));
      by_content_.find_or_add(
          contents_.back(), id,
          [&](std::int32_t other) { return same(other, contents_.back(), parts(action, false)); },
          [&](std::int32_t other) { return contents_[static_cast<std::size_t>(other)]; });
      const bool more = each_atom(action, [&](std::int32_t atom) {
        for (const ObjectId object : task_.atoms.arguments(atom)) {
          auto& list = actions_of_[static_cast<std::size_t>(object)];
          if (!list.empty() && list.back() == id) continue;
          list.push_back(id);
          looks_[static_cast<std::size_t>(object)] += mix(101, static_cast<std::uint64_t>(action.schema));
        }
      });
      if (!more) return false;
    }
    return true;
  }

  // Objects in the task, those that look alike next to each other.
  std::vector<ObjectId> candidates() const {
    std::vector<ObjectId> objects;
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      if (!atoms_of_[i].empty()) objects.push_back(static_cast<ObjectId>(i));
    }
    std::stable_sort(objects.begin(), objects.end(),
                     [&](ObjectId a, ObjectId b) { return look(a) < look(b); });
    return objects;
  }
  std::uint64_t look(ObjectId object) const { return looks_[static_cast<std::size_t>(object)]; }

  // Whether the two can change places; `moved` are then the pairs of atoms that do.
  bool verify(ObjectId a, ObjectId b, std::vector<std::pair<std::int32_t, std::int32_t>>* moved) {
    moved->clear();
    bool good = true;
    for (const ObjectId object : {a, b}) {
      for (const std::int32_t atom : atoms_of_[static_cast<std::size_t>(object)]) {
        if (image_[static_cast<std::size_t>(atom)] != atom) continue;  // the other way round already
        const std::int32_t other = swapped(atom, a, b);
        if (other == AtomTable::kNone || spent(1)) {
          good = false;
          break;
        }
        if (other == atom) continue;
        image_[static_cast<std::size_t>(atom)] = other;
        image_[static_cast<std::size_t>(other)] = atom;
        moved->emplace_back(atom, other);
      }
      if (!good) break;
    }
    for (std::size_t i = 0; good && i < moved->size(); ++i) {
      const auto from = 2 * static_cast<std::size_t>((*moved)[i].first);
      const auto to = 2 * static_cast<std::size_t>((*moved)[i].second);
      good = is_goal_[from] == is_goal_[to] && is_goal_[from + 1] == is_goal_[to + 1];
    }
    for (const ObjectId object : {a, b}) {
      for (const std::int32_t action : actions_of_[static_cast<std::size_t>(object)]) {
        if (!good) break;
        good = has_image(task_.actions[static_cast<std::size_t>(action)]);
      }
    }
    for (const auto& [from, to] : *moved) {
      image_[static_cast<std::size_t>(from)] = from;
      image_[static_cast<std::size_t>(to)] = to;
    }
    if (good) align(a, b, moved);
    return good && !moved->empty();
  }
  bool out_of_work() const { return work_ > kMostWork || budget_.stopped(); }

 private:
  // The same order for all objects of a class: by what the atoms say about the object.
  void align(ObjectId a, ObjectId b, std::vector<std::pair<std::int32_t, std::int32_t>>* moved) {
    std::vector<std::pair<std::vector<std::int32_t>, std::pair<std::int32_t, std::int32_t>>> sorted;
    for (const auto& pair : *moved) {
      const AtomRef ref = task_.atoms[pair.first];
      std::vector<std::int32_t> about = {ref.predicate};
      for (const ObjectId argument : ref.arguments)
        about.push_back(argument == a ? -1 : argument == b ? -2 : argument);
      sorted.emplace_back(std::move(about), pair);
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) (*moved)[i] = sorted[i].second;
  }
  void grow(std::size_t size) {
    looks_.resize(size, 0);
    atoms_of_.resize(size);
  }
  bool spent(std::size_t amount) {
    work_ += static_cast<std::int64_t>(amount);
    return work_ > kMostWork || budget_.poll();
  }
  // visit(atom) for all that the action needs or touches. False if time or work ran out.
  template <class Visit>
  bool each_atom(const GroundAction& action, const Visit& visit) {
    std::size_t amount = 0;
    for (const ConditionId c : task_.preconditions(action)) visit(c >> 1), ++amount;
    for (const GroundEffect& effect : task_.effects_of(action)) {
      visit(effect.literal >> 1), ++amount;
      for (const ConditionId c : task_.conditions_of(effect)) visit(c >> 1), ++amount;
    }
    return !spent(amount);
  }
  Literal image(Literal literal) const {
    return 2 * image_[static_cast<std::size_t>(literal >> 1)] + (literal & 1);
  }
  std::int32_t swapped(std::int32_t atom, ObjectId a, ObjectId b) {
    const AtomRef ref = task_.atoms[atom];
    arguments_.assign(ref.arguments.begin(), ref.arguments.end());
    for (ObjectId& argument : arguments_) {
      if (argument == a) {
        argument = b;
      } else if (argument == b) {
        argument = a;
      }
    }
    return task_.atoms.find(ref.predicate, arguments_.data(), arguments_.size());
  }
  // What the image of the action does, whatever it is called and in whatever order it is written.
  std::uint64_t content(const GroundAction& action) const {
    std::uint64_t h = mix(7, static_cast<std::uint64_t>(action.cost));
    for (const ConditionId c : task_.preconditions(action)) h += mix(1, static_cast<std::uint64_t>(image(c)));
    for (const GroundEffect& effect : task_.effects_of(action)) {
      std::uint64_t when = 3;
      for (const ConditionId c : task_.conditions_of(effect))
        when += mix(2, static_cast<std::uint64_t>(image(c)));
      h += mix(static_cast<std::uint64_t>(image(effect.literal)), when);
    }
    return h;
  }
  // The same in full: the cost, the preconditions, then each effect with its conditions.
  using Parts = std::vector<std::vector<std::int32_t>>;
  Parts parts(const GroundAction& action, bool of_image) const {
    const auto name = [&](Literal literal) { return of_image ? image(literal) : literal; };
    Parts result(2);
    result[0] = {static_cast<std::int32_t>(action.cost >> 31),
                 static_cast<std::int32_t>(action.cost & 0x7fffffff)};
    for (const ConditionId c : task_.preconditions(action)) result[1].push_back(name(c));
    std::sort(result[1].begin(), result[1].end());
    for (const GroundEffect& effect : task_.effects_of(action)) {
      std::vector<std::int32_t> entry;
      for (const ConditionId c : task_.conditions_of(effect)) entry.push_back(name(c));
      std::sort(entry.begin(), entry.end());
      entry.push_back(name(effect.literal));
      result.push_back(std::move(entry));
    }
    std::sort(result.begin() + 2, result.end());
    return result;
  }
  bool same(std::int32_t other, std::uint64_t hash, const Parts& wanted) const {
    return contents_[static_cast<std::size_t>(other)] == hash &&
           parts(task_.actions[static_cast<std::size_t>(other)], false) == wanted;
  }
  bool has_image(const GroundAction& action) {
    bool touched = false;
    if (!each_atom(action, [&](std::int32_t atom) {
          touched = touched || image_[static_cast<std::size_t>(atom)] != atom;
        }))
      return false;
    if (!touched) return true;
    const std::uint64_t hash = content(action);
    const auto wanted = parts(action, true);
    return by_content_.find(hash, [&](std::int32_t other) { return same(other, hash, wanted); }) !=
           HashIndex::kNone;
  }

  const GroundTask& task_;
  Budget& budget_;
  std::int64_t work_ = 0;
  std::vector<std::uint8_t> is_goal_;                             // by literal
  std::vector<std::uint64_t> looks_;                              // by object
  std::vector<std::vector<std::int32_t>> atoms_of_, actions_of_;  // by object
  std::vector<std::int32_t> image_;                               // by atom, under the swap at hand
  Growing<std::uint64_t> contents_;                               // by action
  HashIndex by_content_;                                          // actions, one for each content
  std::vector<ObjectId> arguments_;
};

}  // namespace

void ObjectSymmetry::find(const GroundTask& task, Budget& budget) {
  classes_.clear();
  words_ = std::max<std::size_t>(task.words(), 1);
  if (!task.junctions.empty() || !task.axioms.empty() || task.actions.size() > kMostActions) return;
  Swaps swaps(task, budget);
  if (!swaps.prepare()) return;
  struct Open {  // a class that may still grow
    ObjectId last;
    Class swaps;
  };
  std::vector<Open> open;
  const auto close = [&] {
    for (Open& entry : open) {
      if (!entry.swaps.empty()) classes_.push_back(std::move(entry.swaps));
    }
    open.clear();
  };
  std::uint64_t look = 0;
  Swap swap;
  for (const ObjectId object : swaps.candidates()) {
    if (swaps.out_of_work()) break;
    if (swaps.look(object) != look) close();
    look = swaps.look(object);
    bool placed = false;
    for (Open& entry : open) {
      if (!swaps.verify(entry.last, object, &swap.atoms)) continue;
      entry.swaps.push_back(swap);
      entry.last = object;
      placed = true;
      break;
    }
    if (!placed && open.size() < kMostPartners) open.push_back({object, {}});
  }
  if (budget.stopped()) {
    classes_.clear();
    return;
  }
  close();
}

std::int64_t ObjectSymmetry::count() const {
  std::int64_t objects = 0;
  for (const Class& entry : classes_) objects += static_cast<std::int64_t>(entry.size()) + 1;
  return objects;
}

void ObjectSymmetry::canonical(const Word* state, Word* key) const {
  if (key != state) std::copy_n(state, words_, key);
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (const Class& swaps : classes_) {
      // Insertion sort by neighbours: what holds of an object is compared atom by atom.
      for (std::size_t i = 0; i < swaps.size(); ++i) {
        for (std::size_t at = i + 1; at-- > 0;) {
          const auto& atoms = swaps[at].atoms;
          const auto differing = std::find_if(atoms.begin(), atoms.end(), [&](const auto& pair) {
            return bit(key, pair.first) != bit(key, pair.second);
          });
          if (differing == atoms.end() || bit(key, differing->first)) break;
          for (const auto& [first, second] : atoms) {
            if (bit(key, first) == bit(key, second)) continue;
            key[static_cast<std::size_t>(first) >> 6] ^= Word{1} << (static_cast<std::size_t>(first) & 63u);
            key[static_cast<std::size_t>(second) >> 6] ^= Word{1} << (static_cast<std::size_t>(second) & 63u);
          }
          changed = true;
        }
      }
    }
    if (!changed) return;
  }
}

}  // namespace goalnet::planner
