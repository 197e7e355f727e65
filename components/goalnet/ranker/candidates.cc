#include "components/goalnet/ranker/candidates.h"

#include <algorithm>
#include <array>

namespace goalnet::inference {
namespace {

using namespace symbol;

bool includes(const std::vector<ClassId>& classes, ClassId id) {
  return std::binary_search(classes.begin(), classes.end(), id);
}

// A world of very many objects: what the instruction names, what is held, and as many others as fit.
std::vector<SeenObject> relevant(const Instruction& instruction, const SymState& state) {
  constexpr std::size_t kEnough = 80;
  if (instruction.objects.size() <= kEnough) return instruction.objects;
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
  const std::vector<SeenObject> objects = relevant(instruction, state);
  const auto graspable = [&](Symbol o) { return state.has(Relation::kIsGraspable, o) || state.holds(o); };
  // Cheap necessary conditions only; what changes nothing is dropped by would_change().
  const auto offer = [&](const SymAction& action) {
    if (list.size() < kMaxCandidates) list.push_back(action);
  };
  std::vector<SeenObject> movable, vessels;
  for (const SeenObject& object : objects) {
    if (!graspable(object.symbol)) continue;
    movable.push_back(object);
    const ObjectClass& c = lexicon.object_class(object.class_id);
    if (c.vessel || c.dish) vessels.push_back(object);
  }
  for (const SeenObject& object : objects) {
    const Symbol o = object.symbol;
    const bool held = state.holds(o);
    if (!held && !state.near(o)) offer({Verb::kMoveTo, o});
    if (!graspable(o)) continue;
    offer({held ? Verb::kRelease : Verb::kGrasp, o});
  }
  for (const SeenObject& x : movable)
    for (const SeenObject& y : objects) {
      if (x.symbol == y.symbol) continue;
      if (includes(places.on, y.class_id) && !state.has(Relation::kOn, x.symbol, y.symbol))
        offer({Verb::kKeepOn, x.symbol, y.symbol});
      if (includes(places.in, y.class_id) && !state.has(Relation::kIn, x.symbol, y.symbol))
        offer({Verb::kKeepIn, x.symbol, y.symbol});
    }
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
    if (device.action.verb == Verb::kClose && !applicable(device.action, [&] {
          SymState near = state;
          near.add(sym_fact(Relation::kNear, kRobot, kMicrowave));
          near.add(sym_fact(Relation::kNear, kRobot, kFridge));
          return near;
        }()))
      continue;
    offer(device.action);
  }
  for (const SeenObject& x : vessels) {
    bool full = false;
    for (Symbol content = kWater; content <= kEgg; ++content) full = full || state.is(x.symbol, content);
    if (!full) continue;
    offer({Verb::kPour, x.symbol});
    for (const SeenObject& y : vessels)
      if (x.symbol != y.symbol) offer({Verb::kPourInto, x.symbol, y.symbol});
  }
  for (const SeenObject& y : vessels) {
    for (const Symbol ingredient : {kSalt_1, kRamen_1, kBoiledEgg_1})
      if (instruction.find(ingredient) >= 0 && graspable(ingredient))
        offer({Verb::kAdd, ingredient, y.symbol});
    if (state.is(kSpoon_1, kScoopsLeft)) offer({Verb::kAdd, kIceCreamScoop, y.symbol});
    for (const SeenObject& x : movable)
      if (x.symbol != y.symbol && state.has(Relation::kIsSqueezeable, x.symbol) &&
          state.is(x.symbol, kChocolate))
        offer({Verb::kSqueeze, x.symbol, y.symbol});
    for (const Symbol utensil : {kFork_1, kSpoon_1})
      if (instruction.find(utensil) >= 0) offer({Verb::kPlace, utensil, y.symbol});
  }
  for (const SeenObject& x : movable)
    for (const SeenObject& y : movable) {
      if (x.symbol == y.symbol) continue;
      if (lexicon.object_class(x.class_id).utensil && state.is(y.symbol, kScoopsLeft) &&
          !lexicon.object_class(y.class_id).utensil && !state.is(x.symbol, kScoopsLeft))
        offer({Verb::kScoop, x.symbol, y.symbol});
      if (state.is(x.symbol, kCD) && lexicon.object_class(y.class_id).name == "xbox")
        offer({Verb::kInsert, x.symbol, y.symbol});
    }
  return list;
}

}  // namespace goalnet::inference
