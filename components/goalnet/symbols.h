// Names as small numbers. Case does not matter for equality (demonstrations spell "stoveknob_1" and
// "StoveKnob_1").
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace goalnet::inference {

using Symbol = std::uint16_t;

// The names that the rules of the benchmark domain mention, as constants: symbol::kSink and so on.
namespace symbol {
#define GOALNET_SYMBOLS(X)                                                                                   \
  X(None)                                                                                                    \
  X(Robot) X(Sink) X(SinkKnob) X(Stove) X(StoveKnob_1) X(StoveKnob_2) X(StoveKnob_3) X(StoveKnob_4)          \
      X(StoveFire1) X(StoveFire2) X(StoveFire3) X(StoveFire4) X(StoveFire_1) X(StoveFire_2) X(StoveFire_3)   \
          X(StoveFire_4) X(Microwave) X(MicrowaveButton) X(Fridge) X(FridgeButton) X(FridgeLeft)             \
              X(FridgeRight) X(FridgeLeftDoor) X(FridgeRightDoor) X(Tv_1) X(Tv_1Remote_1) X(Tv_1PowerButton) \
                  X(Tv_1Remote_1PowerButton) X(Tv_1ChannelUpButton) X(Tv_1ChannelDownButton)                 \
                      X(Tv_1Remote_1ChannelUpButton) X(Tv_1Remote_1ChannelDownButton) X(Tv_1VolumeUpButton)  \
                          X(Tv_1VolumeDownButton) X(Tv_1Remote_1VolumeUpButton)                              \
                              X(Tv_1Remote_1VolumeDownButton) X(Tv_1Remote_1MuteButton) X(BagOfChips_1)      \
                                  X(GarbageBag_1) X(GarbageBin_1) X(Salt_1) X(Ramen_1) X(BoiledEgg_1)        \
                                      X(IceCreamScoop) X(Spoon_1) X(Fork_1) X(TapIsOn) X(MicrowaveIsOn)      \
                                          X(DoorIsOpen) X(LeftDoorIsOpen) X(RightDoorIsOpen)                 \
                                              X(WaterDispenserIsOpen) X(IsOn) X(IsOpen) X(Volume)            \
                                                  X(Channel1) X(Channel2) X(Channel3) X(Channel4)            \
                                                      X(Channel5) X(Channel6) X(Water) X(Coffee) X(Coke)     \
                                                          X(EnergyDrink) X(IceCream) X(Chocolate)            \
                                                              X(CanadaDry) X(Vanilla) X(Salt) X(Ramen)       \
                                                                  X(Egg) X(temperatureHigh) X(ScoopsLeft)    \
                                                                      X(CD) X(Fork) X(Spoon) X(HasChips)
enum : Symbol {
#define GOALNET_SYMBOL(name) k##name,
  GOALNET_SYMBOLS(GOALNET_SYMBOL)
#undef GOALNET_SYMBOL
      kFirstFree
};
}  // namespace symbol

inline constexpr std::size_t kMaxSymbols = 1u << 14;  // fourteen bits in a packed fact (sym_state.h)

// A table of names that only grows. Not safe for concurrent interning; lookups of a constant table are.
class Symbols {
 public:
  Symbols();

  // The number of a name, added when new. symbol::kNone when the table is full.
  Symbol intern(std::string_view name);
  // The number of a name; symbol::kNone when it is not in the table.
  Symbol find(std::string_view name) const;
  // The spelling first seen.
  const std::string& name(Symbol symbol) const { return names_[symbol]; }
  std::size_t size() const { return names_.size(); }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, Symbol> numbers_;  // by lower-case spelling; never iterated
};

}  // namespace goalnet::inference
