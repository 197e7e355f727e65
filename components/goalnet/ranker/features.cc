#include "components/goalnet/ranker/features.h"

#include <algorithm>

namespace goalnet::inference {
namespace {

using namespace symbol;

std::uint32_t mix(std::uint32_t hash, std::uint32_t value) {
  hash ^= value * 0xcc9e2d51u;
  hash = (hash << 13 | hash >> 19) * 5u + 0xe6546b64u;
  return hash ^ hash >> 15;
}

template <class... Values>
std::uint32_t feature(std::uint32_t kind, Values... values) {
  std::uint32_t hash = kind * 0x9e3779b1u;
  ((hash = mix(hash, static_cast<std::uint32_t>(values))), ...);
  hash ^= hash >> 16;
  hash *= 0x85ebca6bu;
  hash ^= hash >> 13;
  return hash & (kFeatureBuckets - 1);
}

std::uint32_t few(int count, int most) { return static_cast<std::uint32_t>(std::min(count, most)); }

// Devices are told apart by name (a knob is not a knob); movable things are not.
std::uint32_t verb_code(const SymAction& action) {
  const auto verb = static_cast<std::uint32_t>(action.verb);
  const bool device = action.verb == Verb::kPress || action.verb == Verb::kTurn ||
                      action.verb == Verb::kOpen || action.verb == Verb::kClose;
  return device ? verb * 1000u + action.x : verb;
}

std::uint32_t vote_code(float weight) {
  return weight <= 0      ? 0u
         : weight < 0.1f  ? 1u
         : weight < 0.25f ? 2u
         : weight < 0.45f ? 3u
         : weight < 0.7f  ? 4u
                          : 5u;
}

bool uses_device(Verb verb) {
  return verb == Verb::kPress || verb == Verb::kTurn || verb == Verb::kOpen || verb == Verb::kClose;
}

// The object that a device part belongs to: what the instruction is likely to name.
Symbol device_of(Symbol part) {
  if (part == kSinkKnob) return kSinkKnob;
  if (part >= kStoveKnob_1 && part <= kStoveKnob_4) return kStove;
  if (part == kMicrowaveButton) return kMicrowave;
  if (part == kFridgeButton || part == kFridgeLeftDoor || part == kFridgeRightDoor) return kFridge;
  if (part == kTv_1PowerButton || part == kTv_1ChannelUpButton || part == kTv_1ChannelDownButton ||
      part == kTv_1VolumeUpButton || part == kTv_1VolumeDownButton)
    return kTv_1;
  if (part >= kTv_1Remote_1PowerButton && part <= kTv_1Remote_1MuteButton) return kTv_1Remote_1;
  return part;
}

}  // namespace

FeatureContext::FeatureContext(const Instruction& instruction, const Lexicon& lexicon,
                               std::span<const NeighbourVote> votes, const PartialRun& run)
    : instruction_(instruction),
      lexicon_(lexicon),
      votes_(votes),
      run_(run),
      handled_(instruction.objects.size(), 0),
      named_(0),
      named_handled_(0),
      held_named_(0),
      held_(0),
      step_(few(static_cast<int>(run.actions.size()), 6)) {
  for (const SymAction& action : run.actions) {
    const int x = instruction.find(uses_device(action.verb) ? device_of(action.x) : action.x);
    const int y = instruction.find(action.y);
    if (x >= 0) handled_[static_cast<std::size_t>(x)] |= 1;
    if (y >= 0) handled_[static_cast<std::size_t>(y)] |= 2;
  }
  if (!run.actions.empty()) last_ = run.actions.back();
  if (run.actions.size() > 1) before_last_ = run.actions[run.actions.size() - 2];
  std::vector<std::uint8_t> mention_done(instruction.mentions.size(), 0);
  for (std::size_t i = 0; i < instruction.objects.size(); ++i) {
    const SeenObject& object = instruction.objects[i];
    const bool held = run.now.holds(object.symbol);
    held_ += held;
    if (object.mention < 0) continue;
    held_named_ += held;
    if (handled_[i]) mention_done[static_cast<std::size_t>(object.mention)] = 1;
  }
  named_ = few(static_cast<int>(instruction.mentions.size()), 5);
  named_handled_ = few(static_cast<int>(std::count(mention_done.begin(), mention_done.end(), 1)), 5);
  held_ = few(static_cast<int>(held_), 3);
  held_named_ = few(static_cast<int>(held_named_), 3);
}

FeatureContext::ObjectCode FeatureContext::code(Symbol symbol) const {
  ObjectCode code;
  code.index = instruction_.find(symbol);
  if (code.index < 0) {
    code.class_code = 100000u + symbol;
    code.name = symbol;
    return code;
  }
  const SeenObject& object = instruction_.objects[static_cast<std::size_t>(code.index)];
  const SymState& now = run_.now;
  code.held = now.holds(symbol);
  code.name = object.name_hash;
  const std::uint32_t handled = handled_[static_cast<std::size_t>(code.index)];
  code.handled = handled != 0;
  code.named = object.grounded || object.level != NameLevel::kNone;
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
  // Where it is now: in the hand, or the class of what it stands on or in.
  for (const SymFact fact : now.facts()) {
    const Relation relation = relation_of(fact);
    if (relation != Relation::kOn && relation != Relation::kIn) continue;
    if (subject_of(fact) != symbol || object_of(fact) == symbol) continue;
    const int place = instruction_.find(object_of(fact));
    code.place = place >= 0 ? 2u + instruction_.objects[static_cast<std::size_t>(place)].class_id : 1u;
  }
  code.state = (code.held ? 1u : 0u) + (now.near(symbol) ? 2u : 0u) + handled * 4u;
  return code;
}

float FeatureContext::vote(const SymAction& action, ClassId x, ClassId y) const {
  float weight = 0;
  for (const NeighbourVote& vote : votes_)
    if (vote.verb == action.verb && vote.x == x && vote.y == y) weight += vote.weight;
  return weight;
}

void FeatureContext::extract_stop(std::vector<std::uint32_t>& out) const {
  const auto add = [&](auto... values) { out.push_back(feature(values...)); };
  const std::uint32_t last = verb_code(last_), before = verb_code(before_last_);
  const ObjectCode x = code(uses_device(last_.verb) ? device_of(last_.x) : last_.x), y = code(last_.y);
  const std::uint32_t vote_stop = vote_code(vote(SymAction{}, kNoClass, static_cast<ClassId>(step_)));
  add(1000);
  add(1001, step_);
  add(1002, last);
  add(1003, last, before);
  add(1004, last, x.mention);
  add(1005, last, y.mention);
  add(1006, last, x.mention, y.mention);
  add(1007, named_, named_handled_);
  add(1008, last, named_, named_handled_);
  add(1009, held_, held_named_);
  add(1010, last, held_, held_named_);
  add(1011, last, x.class_code);
  add(1012, last, x.class_code, y.class_code);
  add(1013, last, instruction_.first_verb);
  add(1014, last, instruction_.first_verb, named_handled_);
  add(1015, few(static_cast<int>(instruction_.words.size()) / 3, 8), step_);
  add(1016, vote_stop);
  add(1017, vote_stop, last);
  add(1018, instruction_.first_verb, step_);
  for (const std::uint32_t word : instruction_.unigrams) {
    add(1020, word);
    add(1021, word, last);
    add(1022, word, step_);
    add(1023, word, last, x.class_code);
  }
  for (const std::uint32_t pair : instruction_.bigrams) {
    add(1024, pair);
    add(1025, pair, last);
  }
}

void FeatureContext::extract(const SymAction& action, std::vector<std::uint32_t>& out) const {
  if (action.verb == Verb::kStop) return extract_stop(out);
  const auto add = [&](auto... values) { out.push_back(feature(values...)); };
  const std::uint32_t v = verb_code(action), last = verb_code(last_), before = verb_code(before_last_);
  const Symbol device = uses_device(action.verb) ? device_of(action.x) : action.x;
  const ObjectCode x = code(device), y = code(action.y);
  const ClassId cx =
      x.index >= 0 ? instruction_.objects[static_cast<std::size_t>(x.index)].class_id : kNoClass;
  const ClassId cy =
      y.index >= 0 ? instruction_.objects[static_cast<std::size_t>(y.index)].class_id : kNoClass;
  const std::uint32_t w0 = instruction_.first_verb;
  const std::uint32_t same =
      (last_.x == action.x ? 1u : 0u) + (last_.y == action.y && action.y != kNone ? 2u : 0u) +
      (last_.x == action.y && action.y != kNone ? 4u : 0u) + (last_.y == action.x ? 8u : 0u);
  const std::uint32_t votes = vote_code(vote(action, cx, cy));
  const std::uint32_t verb_only = static_cast<std::uint32_t>(action.verb);

  add(1, v);
  add(2, v, x.mention);
  add(4, v, x.mention, y.mention);
  add(5, v, x.class_code);
  add(8, v, x.class_code, x.mention);
  add(10, v, x.state);
  add(11, v, x.state, x.mention);
  add(12, v, x.place);
  add(13, v, x.place, x.mention);
  add(15, v, x.rank, x.class_code);
  add(16, v, x.rank, x.mention);
  add(20, v, last);
  add(21, v, last, before);
  add(22, v, last, same);
  add(23, v, last, same, x.mention, y.mention);
  add(24, v, x.class_code, last, code(last_.x).class_code);
  add(25, v, step_);
  add(26, v, step_, x.mention, y.mention);
  add(27, v, named_, named_handled_);
  add(28, v, held_, held_named_, x.state);
  add(29, v, x.class_code, same, last);
  add(30, v, w0, x.mention, y.mention);
  add(31, v, w0, x.state);
  add(32, v, w0, last, x.state);
  add(33, v, w0, x.class_code, y.class_code);
  add(34, v, x.before, x.mention);
  add(35, v, votes);
  add(36, v, votes, x.mention);
  add(37, votes);
  add(38, votes, step_, x.state);
  add(39, v, votes, last);
  add(40, verb_only, x.mention, x.state, step_);
  add(41, v, x.state, x.class_code);
  add(42, verb_only, x.name);  // habits about single things: the first burner, the left pillow
  if (action.y != kNone) {
    add(50, v, y.mention);
    add(51, v, y.class_code);
    add(52, v, x.class_code, y.class_code);
    add(53, v, y.class_code, y.mention);
    add(54, v, y.state);
    add(55, v, y.before, y.mention);
    add(56, v, x.before, y.before);
    add(57, v, y.name);
    add(58, v, x.place, y.class_code);
    add(59, v, y.rank, y.mention);
    add(60, v, x.state, y.state);
    const SeenObject* seen_x =
        x.index >= 0 ? &instruction_.objects[static_cast<std::size_t>(x.index)] : nullptr;
    const SeenObject* seen_y =
        y.index >= 0 ? &instruction_.objects[static_cast<std::size_t>(y.index)] : nullptr;
    if (seen_x && seen_y && seen_x->mention >= 0 && seen_y->mention >= 0)
      add(61, v, seen_x->mention < seen_y->mention ? 1 : 2, x.mention, y.mention);
  }
  for (const std::uint32_t word : instruction_.unigrams) {
    add(70, v, word);
    add(71, word, x.class_code);
    add(72, v, word, x.class_code);
    add(73, v, word, x.mention);
    add(74, v, word, x.state);
    if (action.y != kNone) {
      add(75, word, y.class_code);
      add(76, v, word, y.class_code);
      add(77, v, word, y.mention);
    }
  }
  for (const std::uint32_t pair : instruction_.bigrams) {
    add(80, v, pair);
    add(81, v, pair, x.class_code);
    if (action.y != kNone) add(82, pair, y.class_code);
  }
}

}  // namespace goalnet::inference
