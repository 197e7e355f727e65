#include "components/goalnet/ranker/feature_codes.h"

#include <algorithm>

namespace goalnet::inference {

using namespace symbol;

std::uint32_t few(int count, int most) { return static_cast<std::uint32_t>(std::min(count, most)); }

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

}  // namespace goalnet::inference
