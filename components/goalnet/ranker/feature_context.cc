#include <algorithm>
#include <tuple>

#include "components/goalnet/ranker/feature_codes.h"
#include "components/goalnet/ranker/features.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

template <class Key>
std::vector<StepKey> keys_of(const PartialRun& run, Key key) {
  std::vector<StepKey> keys;
  for (const SymAction& action : run.actions) keys.push_back(key(action));
  return keys;
}

}  // namespace

FeatureContext::FeatureContext(const Instruction& instruction, const Hints& hints, const PartialRun& run)
    : instruction_(instruction),
      hints_(hints),
      run_(run),
      handled_(instruction.objects.size(), 0),
      near_or_held_(instruction.objects.size(), 0),
      last_use_(instruction.objects.size(), 0),
      last_place_(instruction.objects.size(), 0),
      named_(0),
      named_handled_(0),
      held_named_(0),
      held_(0),
      step_(few(static_cast<int>(run.actions.size()), kSteps - 1)),
      next_by_words_(hints.plans_by_words, keys_of(run, [&](const SymAction& a) { return class_key(a); })),
      next_by_room_(hints.plans_by_room,
                    keys_of(run, [](const SymAction& a) { return step_key(a.verb, a.x, a.y); })) {
  for (const SymAction& action : run.actions) {
    const int x = instruction.find(uses_device(action.verb) ? device_of(action.x) : action.x);
    const int y = instruction.find(action.y);
    const auto verb = static_cast<std::uint8_t>(action.verb);
    if (x >= 0) handled_[static_cast<std::size_t>(x)] |= 1, last_use_[static_cast<std::size_t>(x)] = verb;
    if (y >= 0) handled_[static_cast<std::size_t>(y)] |= 2, last_place_[static_cast<std::size_t>(y)] = verb;
  }
  if (!run.actions.empty()) last_ = run.actions.back();
  if (run.actions.size() > 1) before_last_ = run.actions[run.actions.size() - 2];
  for (const SymFact fact : run.now.facts()) {
    const Relation relation = relation_of(fact);
    if ((relation != Relation::kNear && relation != Relation::kGrasping) || subject_of(fact) != kRobot)
      continue;
    if (const int object = instruction.find(object_of(fact)); object >= 0)
      near_or_held_[static_cast<std::size_t>(object)] |= relation == Relation::kGrasping ? 1 : 2;
  }
  std::vector<std::uint8_t> mention_done(instruction.mentions.size(), 0);
  for (std::size_t i = 0; i < instruction.objects.size(); ++i) {
    const SeenObject& object = instruction.objects[i];
    const bool held = (near_or_held_[i] & 1) != 0;
    held_ += held;
    if (object.mention < 0) continue;
    held_named_ += held;
    if (handled_[i]) mention_done[static_cast<std::size_t>(object.mention)] = 1;
  }
  next_mention_ =
      static_cast<int>(std::find(mention_done.begin(), mention_done.end(), 0) - mention_done.begin());
  world_ = world_code(run.now);
  const auto& read = hints.reading.macros;
  const auto is_done = [&](const SymAction& action) {
    return std::find(run.actions.begin(), run.actions.end(), action) != run.actions.end();
  };
  const auto done = static_cast<std::size_t>(std::count_if(read.begin(), read.end(), is_done));
  read_ = (read.empty() ? 0u : done == 0 ? 1u : done < read.size() ? 2u : 3u) * 2 + hints.reading.complete;
  named_ = few(static_cast<int>(instruction.mentions.size()), 5);
  named_handled_ = few(static_cast<int>(std::count(mention_done.begin(), mention_done.end(), 1)), 5);
  held_ = few(static_cast<int>(held_), 3);
  held_named_ = few(static_cast<int>(held_named_), 3);
  codes_.reserve(instruction.objects.size());
  for (std::size_t i = 0; i < instruction.objects.size(); ++i) codes_.push_back(make_code(i));
  place_objects();
  read_steps();
  for (const SymAction& action : run.actions) done_.emplace_back(action.verb, class_code(action.x));
}

void FeatureContext::read_steps() {
  bool first = true;
  for (const SymAction& read : hints_.reading.macros) {
    const bool done = std::find(run_.actions.begin(), run_.actions.end(), read) != run_.actions.end();
    reading_.push_back({read, class_code(read.x), class_code(read.y), done ? 5u : first ? 7u : 6u});
    if (!done) first = false;
  }
}

// Where the objects are and what is in them: one look at each fact.
void FeatureContext::place_objects() {
  for (const SymFact fact : run_.now.facts()) {
    const Relation relation = relation_of(fact);
    const Symbol subject = subject_of(fact), object = object_of(fact);
    const bool located = relation == Relation::kOn || relation == Relation::kIn;
    if ((!located && relation != Relation::kState) || (located && subject == object)) continue;
    const int index = instruction_.find(subject);
    if (index < 0) continue;
    ObjectCode& code = codes_[static_cast<std::size_t>(index)];
    if (located) {
      const int place = instruction_.find(object);
      code.place = place >= 0 ? 2u + instruction_.objects[static_cast<std::size_t>(place)].class_id : 1u;
      code.place_named = place >= 0 && instruction_.objects[static_cast<std::size_t>(place)].mention >= 0;
    } else {
      if (object == kWater) code.contents |= 1u;
      if (object == ktemperatureHigh) code.contents |= 2u;
      if (object >= kCoffee && object <= kEgg) code.contents |= 4u;
    }
  }
  for (ObjectCode& code : codes_) {
    const auto append = [&](std::uint32_t value, int bits) { code.changing = code.changing << bits | value; };
    append(code.place, 17);
    append(code.place_named, 1);
    append(code.state, 4);
    append(code.contents, 3);
    append(code.turn, 2);
    append(code.last_use, 5);
    append(code.last_place, 5);
  }
}

FeatureContext::ObjectCode FeatureContext::make_code(std::size_t index) const {
  ObjectCode code;
  const SeenObject& object = instruction_.objects[index];
  code.name = object.name_hash;
  code.mention = static_cast<std::uint32_t>(object.level) * 2 + (object.grounded ? 1 : 0);
  code.mention = code.mention * 4 + (object.rivals == 0   ? 0
                                     : object.rivals == 1 ? 1
                                     : object.rivals < 5  ? 2
                                                          : 3);
  code.mention = code.mention * 2 + (instruction_.grounding_given ? 1 : 0);
  if (object.mention >= 0) {
    const bool plural = instruction_.mentions[static_cast<std::size_t>(object.mention)].plural;
    code.mention = code.mention * 2 + (plural ? 1 : 0);
  }
  code.before = object.word_before;
  code.class_code = object.class_id;
  code.rank = object.rank * 8u + std::min<std::uint8_t>(object.of_class, 7);
  code.mention_index = object.mention;
  code.clause = object.clause;
  code.turn = object.mention < 0                ? 0u
              : object.mention == next_mention_ ? 1u
              : object.mention < next_mention_  ? 2u
                                                : 3u;
  code.last_use = last_use_[index];
  code.last_place = last_place_[index];
  code.state = near_or_held_[index] + handled_[index] * 4u;
  return code;
}

float FeatureContext::habit(const SymAction& action) const {
  const auto found =
      std::lower_bound(hints_.habits.begin(), hints_.habits.end(), action,
                       [](const Habit& habit, const SymAction& a) { return habit.action < a; });
  return found != hints_.habits.end() && found->action == action ? found->weight : 0;
}

StepKey FeatureContext::class_key(const SymAction& action) const {
  const auto class_of = [&](Symbol symbol) {
    const int found = instruction_.find(symbol);
    return found < 0 ? kNoClass : instruction_.objects[static_cast<std::size_t>(found)].class_id;
  };
  return step_key(action.verb, class_of(action.x), class_of(action.y));
}

float FeatureContext::stop_vote() const {
  float weight = 0;
  for (const NeighbourVote& vote : hints_.votes)
    if (vote.verb == Verb::kStop && vote.y == step_) weight += vote.weight;
  return weight;
}

std::uint32_t FeatureContext::class_code(Symbol symbol) const {
  const int index = instruction_.find(symbol);
  return index < 0 ? 100000u + symbol : instruction_.objects[static_cast<std::size_t>(index)].class_id;
}

const FeatureContext::ObjectCode& FeatureContext::code(Symbol symbol, ObjectCode& other) const {
  const int index = instruction_.find(symbol);
  if (index >= 0) return codes_[static_cast<std::size_t>(index)];
  other.class_code = 100000u + symbol;
  other.name = symbol;
  return other;
}

float FeatureContext::vote(const SymAction& action) const {
  const auto class_of = [&](Symbol symbol) {
    const int index = instruction_.find(symbol);
    return index < 0 ? kNoClass : instruction_.objects[static_cast<std::size_t>(index)].class_id;
  };
  const auto key = std::tuple(
      action.verb, class_of(uses_device(action.verb) ? device_of(action.x) : action.x), class_of(action.y));
  const auto of = [](const NeighbourVote& vote) { return std::tuple(vote.verb, vote.x, vote.y); };
  const auto found = std::ranges::lower_bound(hints_.votes, key, {}, of);
  return found != hints_.votes.end() && of(*found) == key ? found->weight : 0;
}

ActionHints FeatureContext::hints(const SymAction& action) const {
  return {.votes = vote_code(vote(action)),
          .habits = vote_code(habit(action)),
          .by_class = hints_.plans_by_words.number(class_key(action)),
          .by_object = hints_.plans_by_room.number(step_key(action.verb, action.x, action.y))};
}

// What the grammar's reading says about an action.
std::uint32_t FeatureContext::reading_code(const SymAction& action, const ObjectCode& x,
                                           const ObjectCode& y) const {
  std::uint32_t best = reading_.empty() ? 0 : 1;
  for (const ReadStep& read : reading_) {
    const bool same_verb = read.action.verb == action.verb;
    std::uint32_t match = 1;
    if (read.action == action)
      match = read.match;
    else if (same_verb && read.x_class == x.class_code && read.y_class == y.class_code)
      match = 4;
    else if (action.verb == Verb::kGrasp && (read.action.x == action.x || read.action.y == action.x))
      match = 3;
    else if (same_verb)
      match = 2;
    best = std::max(best, match);
  }
  return best * 2 + (hints_.reading.complete ? 1 : 0);
}

std::uint32_t FeatureContext::repeats(const SymAction& action, std::uint32_t x_class) const {
  return few(static_cast<int>(std::count(done_.begin(), done_.end(), std::pair(action.verb, x_class))), 4);
}

}  // namespace goalnet::inference
