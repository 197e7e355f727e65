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

// A world of very many objects: what the instruction names, what is held, and as many others as fit.
std::vector<SeenObject> relevant(const Instruction& instruction, const SymState& state) {
  std::vector<SeenObject> chosen;
  const auto wanted = [&](const SeenObject& object) {
    return object.mention >= 0 || state.holds(object.symbol) || object.symbol < kFirstFree;
  };
  for (const SeenObject& object : instruction.objects)
    if (wanted(object) && chosen.size() < kEnough) chosen.push_back(object);
  for (const SeenObject& object : instruction.objects)
    if (!wanted(object) && chosen.size() < kEnough) chosen.push_back(object);
  return chosen;
}

// A thing that can be taken, with what the loops over pairs ask of it.
struct Movable {
  Symbol symbol;
  bool utensil, scoops, cd, xbox, squeezable;
};

struct Place {
  Symbol symbol;
  bool on, in;
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

std::vector<SymAction> candidates(const Instruction& instruction, const Lexicon& lexicon,
                                  const Places& places, const SymState& state) {
  std::vector<SymAction> list = {SymAction{}};
  list.reserve(512);
  std::vector<SeenObject> chosen;
  const std::vector<SeenObject>& objects =
      instruction.objects.size() > kEnough ? chosen = relevant(instruction, state) : instruction.objects;
  const auto graspable = [&](Symbol o) { return state.has(Relation::kIsGraspable, o) || state.holds(o); };
  // Cheap necessary conditions only; what changes nothing is dropped by would_change().
  const auto offer = [&](const SymAction& action) {
    if (list.size() < kMaxCandidates) list.push_back(action);
  };
  std::vector<Movable> movable;
  std::vector<Symbol> vessels;
  std::vector<Place> where;
  for (const SeenObject& object : objects) {
    const Symbol o = object.symbol;
    const Place place{o, includes(places.on, object.class_id), includes(places.in, object.class_id)};
    if (place.on || place.in) where.push_back(place);
    const bool held = state.holds(o);
    if (!held && !state.near(o)) offer({Verb::kMoveTo, o});
    if (!held && !state.has(Relation::kIsGraspable, o)) continue;
    offer({held ? Verb::kRelease : Verb::kGrasp, o});
    const ObjectClass& c = lexicon.object_class(object.class_id);
    movable.push_back({o, c.utensil, state.is(o, kScoopsLeft), state.is(o, kCD), c.name == "xbox",
                       state.has(Relation::kIsSqueezeable, o) && state.is(o, kChocolate)});
    if (c.vessel || c.dish) vessels.push_back(o);
  }
  for (const Movable& x : movable) {
    const auto on = facts_about(state, Relation::kOn, x.symbol),
               in = facts_about(state, Relation::kIn, x.symbol);
    for (const Place& y : where) {
      if (x.symbol == y.symbol) continue;
      if (y.on && !includes(on, y.symbol)) offer({Verb::kKeepOn, x.symbol, y.symbol});
      if (y.in && !includes(in, y.symbol)) offer({Verb::kKeepIn, x.symbol, y.symbol});
    }
  }
  SymState beside_doors = state;
  for (const Symbol device : {kMicrowave, kFridge})
    beside_doors.add(sym_fact(Relation::kNear, kRobot, device));
  for (const DeviceAction& device : kDeviceActions) {
    if (instruction.find(device.device) < 0) continue;
    const bool tv = device.action.verb == Verb::kPress && device.action.x > kTv_1Remote_1PowerButton;
    if (tv && !state.is(kTv_1, kIsOn)) continue;  // channels and volume do nothing while the set is off
    if (device.action.verb == Verb::kOpen &&
        (device.action.x == kMicrowave         ? state.is(kMicrowave, kDoorIsOpen)
         : device.action.x == kFridgeLeftDoor  ? state.is(kFridge, kLeftDoorIsOpen)
         : device.action.x == kFridgeRightDoor ? state.is(kFridge, kRightDoorIsOpen)
                                               : state.is(kBagOfChips_1, kIsOpen)))
      continue;
    if (device.action.verb == Verb::kClose && !applicable(device.action, beside_doors)) continue;
    offer(device.action);
  }
  for (const Symbol x : vessels) {
    bool full = false;
    for (Symbol content = kWater; content <= kEgg; ++content) full = full || state.is(x, content);
    if (!full) continue;
    offer({Verb::kPour, x});
    for (const Symbol y : vessels)
      if (x != y) offer({Verb::kPourInto, x, y});
  }
  for (const Symbol y : vessels) {
    for (const Symbol ingredient : {kSalt_1, kRamen_1, kBoiledEgg_1})
      if (instruction.find(ingredient) >= 0 && graspable(ingredient)) offer({Verb::kAdd, ingredient, y});
    if (state.is(kSpoon_1, kScoopsLeft)) offer({Verb::kAdd, kIceCreamScoop, y});
    for (const Movable& x : movable)
      if (x.symbol != y && x.squeezable) offer({Verb::kSqueeze, x.symbol, y});
    for (const Symbol utensil : {kFork_1, kSpoon_1})
      if (instruction.find(utensil) >= 0) offer({Verb::kPlace, utensil, y});
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
