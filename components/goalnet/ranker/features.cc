#include "components/goalnet/ranker/features.h"

#include <algorithm>
#include <tuple>

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

// Appends features without asking each time whether there is room.
class Appender {
 public:
  Appender(std::vector<std::uint32_t>& out, const Instruction& instruction) : out_(out) {
    constexpr std::size_t kMost = 128, kMostForWord = 8;
    const std::size_t before = out.size();
    out.resize(before + kMost + kMostForWord * (instruction.unigrams.size() + instruction.bigrams.size()));
    next_ = out.data() + before;
  }
  Appender(const Appender&) = delete;
  Appender& operator=(const Appender&) = delete;
  ~Appender() { out_.resize(static_cast<std::size_t>(next_ - out_.data())); }

  template <class... Values>
  void operator()(Values... values) {
    *next_++ = feature(values...);
  }

 private:
  std::vector<std::uint32_t>& out_;
  std::uint32_t* next_ = nullptr;
};

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

// 0: no switch; 1: the action would switch something off (or close it), 2: on.
std::uint32_t switch_code(const SymAction& action, const SymState& state) {
  const auto code = [&](Symbol object, Symbol value) { return state.is(object, value) ? 1u : 2u; };
  if (action.verb == Verb::kTurn) {
    if (action.x == kSinkKnob) return code(kSinkKnob, kTapIsOn);
    if (action.x >= kStoveKnob_1 && action.x <= kStoveKnob_4)
      return code(kStove, static_cast<Symbol>(kStoveFire1 + (action.x - kStoveKnob_1)));
  }
  if (action.verb != Verb::kPress) return 0;
  if (action.x == kMicrowaveButton) return code(kMicrowave, kMicrowaveIsOn);
  if (action.x == kFridgeButton) return code(kFridge, kWaterDispenserIsOpen);
  if (action.x == kTv_1PowerButton || action.x == kTv_1Remote_1PowerButton) return code(kTv_1, kIsOn);
  return 0;
}

std::uint32_t world_code(const SymState& state) {
  std::uint32_t code = 0;
  for (const auto& [object, value] : {std::pair{kSinkKnob, kTapIsOn},
                                      {kMicrowave, kDoorIsOpen},
                                      {kMicrowave, kMicrowaveIsOn},
                                      {kFridge, kLeftDoorIsOpen},
                                      {kFridge, kRightDoorIsOpen},
                                      {kTv_1, kIsOn}})
    code = code * 2 + (state.is(object, value) ? 1 : 0);
  std::uint32_t fires = 0;
  for (Symbol fire = kStoveFire1; fire <= kStoveFire4; ++fire) fires += state.is(kStove, fire);
  return code * 2 + (fires > 0 ? 1 : 0);
}

}  // namespace

FeatureContext::FeatureContext(const Instruction& instruction, const Lexicon& lexicon, const Hints& hints,
                               const PartialRun& run)
    : instruction_(instruction),
      lexicon_(lexicon),
      hints_(hints),
      run_(run),
      handled_(instruction.objects.size(), 0),
      last_use_(instruction.objects.size(), 0),
      last_place_(instruction.objects.size(), 0),
      named_(0),
      named_handled_(0),
      held_named_(0),
      held_(0),
      step_(few(static_cast<int>(run.actions.size()), 6)) {
  for (const SymAction& action : run.actions) {
    const int x = instruction.find(uses_device(action.verb) ? device_of(action.x) : action.x);
    const int y = instruction.find(action.y);
    const auto verb = static_cast<std::uint8_t>(action.verb);
    if (x >= 0) handled_[static_cast<std::size_t>(x)] |= 1, last_use_[static_cast<std::size_t>(x)] = verb;
    if (y >= 0) handled_[static_cast<std::size_t>(y)] |= 2, last_place_[static_cast<std::size_t>(y)] = verb;
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
}

FeatureContext::ObjectCode FeatureContext::make_code(std::size_t index) const {
  ObjectCode code;
  code.index = static_cast<int>(index);
  const SeenObject& object = instruction_.objects[index];
  const Symbol symbol = object.symbol;
  const SymState& now = run_.now;
  code.held = now.holds(symbol);
  code.name = object.name_hash;
  const std::uint32_t handled = handled_[index];
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
  code.mention_index = object.mention;
  code.clause = object.clause;
  code.turn = object.mention < 0                ? 0u
              : object.mention == next_mention_ ? 1u
              : object.mention < next_mention_  ? 2u
                                                : 3u;
  code.last_use = last_use_[index];
  code.last_place = last_place_[index];
  code.state = (code.held ? 1u : 0u) + (now.near(symbol) ? 2u : 0u) + handled * 4u;
  return code;
}

float FeatureContext::habit(const SymAction& action) const {
  const auto found =
      std::lower_bound(hints_.habits.begin(), hints_.habits.end(), action,
                       [](const Habit& habit, const SymAction& a) { return habit.action < a; });
  return found != hints_.habits.end() && found->action == action ? found->weight : 0;
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

FeatureContext::ObjectCode FeatureContext::code(Symbol symbol) const {
  const int index = instruction_.find(symbol);
  if (index >= 0) return codes_[static_cast<std::size_t>(index)];
  ObjectCode code;
  code.class_code = 100000u + symbol;
  code.name = symbol;
  return code;
}

float FeatureContext::vote(const SymAction& action, const ObjectCode& x_code,
                           const ObjectCode& y_code) const {
  const ClassId x = x_code.index >= 0 ? static_cast<ClassId>(x_code.class_code) : kNoClass;
  const ClassId y = y_code.index >= 0 ? static_cast<ClassId>(y_code.class_code) : kNoClass;
  const auto key = std::tuple(action.verb, x, y);
  const auto of = [](const NeighbourVote& vote) { return std::tuple(vote.verb, vote.x, vote.y); };
  const auto found = std::ranges::lower_bound(hints_.votes, key, {}, of);
  return found != hints_.votes.end() && of(*found) == key ? found->weight : 0;
}

// What the grammar's reading says about an action.
std::uint32_t FeatureContext::reading_code(const SymAction& action, const ObjectCode& x,
                                           const ObjectCode& y) const {
  const Reading& reading = hints_.reading;
  std::uint32_t best = reading.macros.empty() ? 0 : 1;
  bool first = true;
  for (const SymAction& read : reading.macros) {
    const bool done = std::find(run_.actions.begin(), run_.actions.end(), read) != run_.actions.end();
    std::uint32_t match = 1;
    if (read == action)
      match = done ? 5 : first ? 7 : 6;
    else if (read.verb == action.verb && class_code(read.x) == x.class_code &&
             class_code(read.y) == y.class_code)
      match = 4;
    else if (action.verb == Verb::kGrasp && (read.x == action.x || read.y == action.x))
      match = 3;
    else if (read.verb == action.verb)
      match = 2;
    best = std::max(best, match);
    if (!done) first = false;
  }
  return best * 2 + (reading.complete ? 1 : 0);
}

std::uint32_t FeatureContext::repeats(const SymAction& action, std::uint32_t x_class) const {
  int count = 0;
  for (const SymAction& done : run_.actions)
    count += done.verb == action.verb && class_code(done.x) == x_class;
  return few(count, 4);
}

void FeatureContext::extract_stop(std::vector<std::uint32_t>& out) const {
  Appender add(out, instruction_);
  const std::uint32_t last = verb_code(last_), before = verb_code(before_last_);
  const ObjectCode x = code(uses_device(last_.verb) ? device_of(last_.x) : last_.x), y = code(last_.y);
  const std::uint32_t vote_stop = vote_code(stop_vote());
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
  add(1030, read_);
  add(1031, read_, last);
  add(1032, read_, step_);
  add(1033, instruction_.first_frame, step_);
  add(1034, instruction_.first_frame, last);
  add(1035, instruction_.first_frame, last, named_, named_handled_);
  add(1036, last, switch_code(last_, run_.now));
  add(1037, last, x.turn, y.turn);
  add(1038, last, x.contents);
  add(1039, world_);
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

// What does not change during a run: the words, the classes, the names.
void FeatureContext::extract_fixed(const SymAction& action, std::vector<std::uint32_t>& out) const {
  if (action.verb == Verb::kStop) return;
  Appender add(out, instruction_);
  const std::uint32_t v = verb_code(action), verb_only = static_cast<std::uint32_t>(action.verb);
  const std::uint32_t w0 = instruction_.first_verb, frame = instruction_.first_frame;
  const ObjectCode x = code(uses_device(action.verb) ? device_of(action.x) : action.x), y = code(action.y);
  const std::uint32_t votes = vote_code(vote(action, x, y));
  add(105, v, x.clause, x.mention);
  add(106, v, x.clause, x.class_code);
  add(107, v, frame, x.mention, y.mention);
  add(1, v);
  add(2, v, x.mention);
  add(4, v, x.mention, y.mention);
  add(5, v, x.class_code);
  add(8, v, x.class_code, x.mention);
  add(15, v, x.rank, x.class_code);
  add(16, v, x.rank, x.mention);
  add(30, v, w0, x.mention, y.mention);
  add(33, v, w0, x.class_code, y.class_code);
  add(34, v, x.before, x.mention);
  add(35, v, votes);
  add(36, v, votes, x.mention);
  add(37, votes);
  const std::uint32_t habits = vote_code(habit(action));
  add(150, habits);
  add(151, v, habits);
  add(152, habits, votes);
  add(153, v, habits, x.mention);
  add(42, verb_only, x.name);  // habits about single things: the first burner, the left pillow
  if (action.y != kNone) {
    add(140, v, y.clause, y.mention);
    add(141, v, y.clause, y.class_code);
    add(147, v, x.clause, y.clause, x.mention, y.mention);
    add(50, v, y.mention);
    add(51, v, y.class_code);
    add(52, v, x.class_code, y.class_code);
    add(53, v, y.class_code, y.mention);
    add(55, v, y.before, y.mention);
    add(56, v, x.before, y.before);
    add(57, v, y.name);
    add(59, v, y.rank, y.mention);
    if (x.mention_index >= 0 && y.mention_index >= 0)
      add(61, v, x.mention_index < y.mention_index ? 1 : 2, x.mention, y.mention);
  }
  for (const std::uint32_t word : instruction_.unigrams) {
    add(70, v, word);
    add(71, word, x.class_code);
    add(73, v, word, x.mention);
    if (action.y != kNone) {
      add(75, word, y.class_code);
      add(77, v, word, y.mention);
    }
  }
  for (const std::uint32_t pair : instruction_.bigrams) {
    add(80, v, pair);
  }
}

// What depends on the moment: what was done, where things are.
void FeatureContext::extract_moment(const SymAction& action, std::vector<std::uint32_t>& out) const {
  if (action.verb == Verb::kStop) return extract_stop(out);
  Appender add(out, instruction_);
  const std::uint32_t v = verb_code(action), last = verb_code(last_), before = verb_code(before_last_);
  const std::uint32_t verb_only = static_cast<std::uint32_t>(action.verb);
  const ObjectCode x = code(uses_device(action.verb) ? device_of(action.x) : action.x), y = code(action.y);
  const std::uint32_t w0 = instruction_.first_verb, frame = instruction_.first_frame;
  const std::uint32_t same =
      (last_.x == action.x ? 1u : 0u) + (last_.y == action.y && action.y != kNone ? 2u : 0u) +
      (last_.x == action.y && action.y != kNone ? 4u : 0u) + (last_.y == action.x ? 8u : 0u);
  const std::uint32_t votes = vote_code(vote(action, x, y)), on = switch_code(action, run_.now);
  const std::uint32_t read = reading_code(action, x, y), again = repeats(action, x.class_code);
  add(100, read);
  add(101, v, read);
  add(102, read, step_);
  add(103, read, votes);
  const std::uint32_t habits = vote_code(habit(action));
  add(156, habits, x.state, step_);
  add(157, v, habits, last);
  add(104, read, frame);
  add(108, v, frame, x.state);
  add(109, v, frame, last, x.state);
  add(110, v, x.last_use);
  add(111, v, x.last_use, x.mention);
  add(112, v, x.last_place);
  add(113, v, again);
  add(114, v, again, x.mention);
  add(115, v, x.turn);
  add(116, v, x.turn, x.mention);
  add(117, v, x.turn, x.clause);
  add(118, v, x.contents);
  add(119, v, x.contents, frame);
  add(120, v, world_);
  add(121, v, x.place_named, x.mention);
  add(122, v, x.clause, x.state);
  add(123, v, x.class_code, x.last_use, last);
  add(10, v, x.state);
  add(11, v, x.state, x.mention);
  add(12, v, x.place);
  add(13, v, x.place, x.mention);
  add(20, v, last);
  add(21, v, last, before);
  add(22, v, last, same);
  add(23, v, last, same, x.mention, y.mention);
  add(24, v, x.class_code, last, class_code(last_.x));
  add(25, v, step_);
  add(26, v, step_, x.mention, y.mention);
  add(27, v, named_, named_handled_);
  add(28, v, held_, held_named_, x.state);
  add(29, v, x.class_code, same, last);
  add(31, v, w0, x.state);
  add(32, v, w0, last, x.state);
  add(38, votes, step_, x.state);
  add(39, v, votes, last);
  add(40, verb_only, x.mention, x.state, step_);
  add(41, v, x.state, x.class_code);
  if (on != 0) {
    add(130, v, on);
    add(131, v, on, frame);
    add(132, v, on, last);
    add(133, v, on, read);
    add(134, v, on, again);
    for (const std::uint32_t word : instruction_.unigrams) add(135, v, on, word);
    for (const std::uint32_t pair : instruction_.bigrams) add(136, v, on, pair);
  }
  if (action.y != kNone) {
    add(142, v, y.turn, x.turn);
    add(143, v, y.last_place);
    add(144, v, y.last_place, last_.y == action.y ? 1 : 0);
    add(145, v, y.last_use);
    add(146, v, y.contents, x.contents);
    add(54, v, y.state);
    add(58, v, x.place, y.class_code);
    add(60, v, x.state, y.state);
  }
  for (const std::uint32_t word : instruction_.unigrams) {
    add(74, v, word, x.state);
  }
}

}  // namespace goalnet::inference
