#include "components/goalnet/ranker/candidates.h"

#include <algorithm>
#include <array>
#include <span>

namespace goalnet::inference {
namespace {

using namespace symbol;

bool includes(const std::vector<ClassId>& classes, ClassId id) {
  return std::binary_search(classes.begin(), classes.end(), id);
}

constexpr std::size_t kEnough = 80;  // objects

// What a state says of one thing, as bits.
enum : std::uint8_t {
  kHeld = 1,
  kNear = 2,
  kGraspable = 4,
  kScoops = 8,
  kDisc = 16,
  kSoft = 32,
  kSweet = 64,
  kFull = 128
};

// Of each symbol below `count`: one look at each fact.
std::vector<std::uint8_t> things_now(const SymState& state, std::size_t count) {
  std::vector<std::uint8_t> now(count, 0);
  for (const SymFact fact : state.facts()) {
    const Symbol subject = subject_of(fact), object = object_of(fact);
    const auto mark = [&](Symbol symbol, std::uint8_t bit) {
      if (symbol < count) now[symbol] |= bit;
    };
    switch (relation_of(fact)) {
      case Relation::kGrasping:
        if (subject == kRobot) mark(object, kHeld);
        break;
      case Relation::kNear:
        if (subject == kRobot) mark(object, kNear);
        break;
      case Relation::kIsGraspable:
        if (object == kNone) mark(subject, kGraspable);
        break;
      case Relation::kIsSqueezeable:
        if (object == kNone) mark(subject, kSoft);
        break;
      case Relation::kState:
        if (object == kScoopsLeft) mark(subject, kScoops);
        if (object == kCD) mark(subject, kDisc);
        if (object == kChocolate) mark(subject, kSweet);
        if (object >= kWater && object <= kEgg) mark(subject, kFull);
        break;
      case Relation::kOn:
      case Relation::kIn:
      case Relation::kHeld:
        break;
    }
  }
  return now;
}

// A thing that can be taken, with what the loops over pairs ask of it.
struct Movable {
  Symbol symbol;
  bool utensil, scoops, cd, xbox, squeezable;
};

// The facts of one relation about one subject.
std::span<const SymFact> facts_about(const SymState& state, Relation relation, Symbol subject) {
  const auto& facts = state.facts();
  const SymFact first = sym_fact(relation, subject);
  const auto begin = std::lower_bound(facts.begin(), facts.end(), first);
  const auto end = std::find_if(begin, facts.end(), [&](SymFact fact) { return fact >> 14 != first >> 14; });
  return {begin, end};
}

bool includes(std::span<const SymFact> facts, Symbol object) {
  return std::any_of(facts.begin(), facts.end(), [&](SymFact fact) { return object_of(fact) == object; });
}

struct DeviceAction {
  Symbol device;  // must be in the world
  SymAction action;
};

constexpr std::array<DeviceAction, 25> kDeviceActions = {{
    {kSink, {Verb::kTurn, kSinkKnob}},
    {kStove, {Verb::kTurn, kStoveKnob_1}},
    {kStove, {Verb::kTurn, kStoveKnob_2}},
    {kStove, {Verb::kTurn, kStoveKnob_3}},
    {kStove, {Verb::kTurn, kStoveKnob_4}},
    {kMicrowave, {Verb::kPress, kMicrowaveButton}},
    {kMicrowave, {Verb::kOpen, kMicrowave}},
    {kMicrowave, {Verb::kClose, kMicrowave}},
    {kFridge, {Verb::kPress, kFridgeButton}},
    {kFridge, {Verb::kOpen, kFridgeLeftDoor}},
    {kFridge, {Verb::kOpen, kFridgeRightDoor}},
    {kFridge, {Verb::kClose, kFridgeLeftDoor}},
    {kFridge, {Verb::kClose, kFridgeRightDoor}},
    {kBagOfChips_1, {Verb::kOpen, kBagOfChips_1}},
    {kTv_1, {Verb::kPress, kTv_1PowerButton}},
    {kTv_1, {Verb::kPress, kTv_1ChannelUpButton}},
    {kTv_1, {Verb::kPress, kTv_1ChannelDownButton}},
    {kTv_1, {Verb::kPress, kTv_1VolumeUpButton}},
    {kTv_1, {Verb::kPress, kTv_1VolumeDownButton}},
    {kTv_1Remote_1, {Verb::kPress, kTv_1Remote_1PowerButton}},
    {kTv_1Remote_1, {Verb::kPress, kTv_1Remote_1ChannelUpButton}},
    {kTv_1Remote_1, {Verb::kPress, kTv_1Remote_1ChannelDownButton}},
    {kTv_1Remote_1, {Verb::kPress, kTv_1Remote_1VolumeUpButton}},
    {kTv_1Remote_1, {Verb::kPress, kTv_1Remote_1VolumeDownButton}},
    {kTv_1Remote_1, {Verb::kPress, kTv_1Remote_1MuteButton}},
}};

}  // namespace

Candidates::Candidates(const Instruction& instruction, const Lexicon& lexicon, const Places& places)
    : instruction_(instruction) {
  things_.reserve(instruction.objects.size());
  for (const SeenObject& object : instruction.objects) {
    const ObjectClass& c = lexicon.object_class(object.class_id);
    things_.push_back({.symbol = object.symbol,
                       .named = object.mention >= 0,
                       .on = includes(places.on, object.class_id),
                       .in = includes(places.in, object.class_id),
                       .utensil = c.utensil,
                       .xbox = c.name == "xbox",
                       .vessel = c.vessel || c.dish});
  }
}

// A world of very many objects: what the instruction names, what is held, and as many others as fit.
std::vector<Candidates::Thing> Candidates::relevant(const SymState& state) const {
  std::vector<Thing> chosen;
  const auto wanted = [&](const Thing& thing) {
    return thing.named || state.holds(thing.symbol) || thing.symbol < kFirstFree;
  };
  for (const Thing& thing : things_)
    if (wanted(thing) && chosen.size() < kEnough) chosen.push_back(thing);
  for (const Thing& thing : things_)
    if (!wanted(thing) && chosen.size() < kEnough) chosen.push_back(thing);
  return chosen;
}

std::vector<SymAction> Candidates::in(const SymState& state) const {
  std::vector<SymAction> list = {SymAction{}};
  list.reserve(512);
  std::vector<Thing> chosen;
  const std::vector<Thing>& things = things_.size() > kEnough ? chosen = relevant(state) : things_;
  const auto graspable = [&](Symbol o) { return state.has(Relation::kIsGraspable, o) || state.holds(o); };
  // Cheap necessary conditions only; what changes nothing is dropped when it is played.
  const auto offer = [&](const SymAction& action) {
    if (list.size() < kMaxCandidates) list.push_back(action);
  };
  const std::vector<std::uint8_t> now = things_now(state, instruction_.index.size());
  std::vector<Movable> movable;
  std::vector<Symbol> vessels;
  std::vector<Thing> where;
  movable.reserve(things.size());
  vessels.reserve(things.size());
  where.reserve(things.size());
  for (const Thing& thing : things) {
    const Symbol o = thing.symbol;
    const std::uint8_t is = now[o];
    if (thing.on || thing.in) where.push_back(thing);
    if ((is & (kHeld | kNear)) == 0) offer({Verb::kMoveTo, o});
    if ((is & (kHeld | kGraspable)) == 0) continue;
    offer({(is & kHeld) != 0 ? Verb::kRelease : Verb::kGrasp, o});
    movable.push_back({o, thing.utensil, (is & kScoops) != 0, (is & kDisc) != 0, thing.xbox,
                       (is & kSoft) != 0 && (is & kSweet) != 0});
    if (thing.vessel) vessels.push_back(o);
  }
  for (const Movable& x : movable) {
    const auto on = facts_about(state, Relation::kOn, x.symbol),
               in = facts_about(state, Relation::kIn, x.symbol);
    for (const Thing& y : where) {
      if (x.symbol == y.symbol) continue;
      if (y.on && !includes(on, y.symbol)) offer({Verb::kKeepOn, x.symbol, y.symbol});
      if (y.in && !includes(in, y.symbol)) offer({Verb::kKeepIn, x.symbol, y.symbol});
    }
  }
  for (const DeviceAction& device : kDeviceActions) {
    if (instruction_.find(device.device) < 0) continue;
    const auto [verb, part, none] = device.action;
    const bool tv = verb == Verb::kPress && part > kTv_1Remote_1PowerButton;
    if (tv && !state.is(kTv_1, kIsOn)) continue;  // channels and volume do nothing while the set is off
    if (verb == Verb::kOpen || verb == Verb::kClose) {
      const bool open = part == kMicrowave         ? state.is(kMicrowave, kDoorIsOpen)
                        : part == kFridgeLeftDoor  ? state.is(kFridge, kLeftDoorIsOpen)
                        : part == kFridgeRightDoor ? state.is(kFridge, kRightDoorIsOpen)
                                                   : state.is(kBagOfChips_1, kIsOpen);
      if (open != (verb == Verb::kClose)) continue;
    }
    offer(device.action);
  }
  for (const Symbol x : vessels) {
    if ((now[x] & kFull) == 0) continue;
    offer({Verb::kPour, x});
    for (const Symbol y : vessels)
      if (x != y) offer({Verb::kPourInto, x, y});
  }
  for (const Symbol y : vessels) {
    for (const Symbol ingredient : {kSalt_1, kRamen_1, kBoiledEgg_1})
      if (instruction_.find(ingredient) >= 0 && graspable(ingredient)) offer({Verb::kAdd, ingredient, y});
    if (state.is(kSpoon_1, kScoopsLeft)) offer({Verb::kAdd, kIceCreamScoop, y});
    for (const Movable& x : movable)
      if (x.symbol != y && x.squeezable) offer({Verb::kSqueeze, x.symbol, y});
    for (const Symbol utensil : {kFork_1, kSpoon_1})
      if (instruction_.find(utensil) >= 0) offer({Verb::kPlace, utensil, y});
  }
  for (const Movable& x : movable)
    for (const Movable& y : movable) {
      if (x.symbol == y.symbol) continue;
      if (x.utensil && y.scoops && !y.utensil && !x.scoops) offer({Verb::kScoop, x.symbol, y.symbol});
      if (x.cd && y.xbox) offer({Verb::kInsert, x.symbol, y.symbol});
    }
  return list;
}

}  // namespace goalnet::inference
