// Things that nobody names: what holds some coffee, a burner for the pot, where to put what is in the way.
#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

Symbol FrameActions::mentioned_content(const Clause& clause, Role role) const {
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == role)
      if (const Symbol content = language_.content(phrase.phrase); content != kNone) return content;
  return kNone;
}

Symbol FrameActions::vessel_with(Symbol content) const {
  Symbol best = kNone;
  for (const Symbol vessel : resolver_.all(Sort::kVessel, now_)) {
    if (!now_.is(vessel, content)) continue;
    if (best == kNone || now_.holds(vessel) ||
        (!now_.holds(best) && resolver_.distance(vessel) < resolver_.distance(best)))
      best = vessel;
  }
  return best;
}

Symbol FrameActions::burner_for(Symbol object) const {
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (now_.has(Relation::kOn, object, burner)) return burner;
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (resolver_.exists(burner) && !resolver_.taken(burner, now_)) return burner;
  return resolver_.exists(kStoveFire_1) ? Symbol{kStoveFire_1} : Symbol{kNone};
}

Symbol FrameActions::surface() const {
  for (const SeenObject& object : resolver_.objects())
    if (resolver_.is_of_class(object.symbol, "counter")) return object.symbol;
  for (const SeenObject& object : resolver_.objects())
    if (resolver_.is_of_class(object.symbol, "coffee_table")) return object.symbol;
  return kNone;
}

}  // namespace goalnet::inference
