// Letting go of things.
#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::release(const Clause& clause) {
  if (clause.first(Role::kDestination) != nullptr) return put(clause);
  Objects objects;
  bool said = false;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDirect) continue;
    said = true;
    Objects options;
    if (phrase.pronoun || phrase.everything) {
      for (const SymFact fact : now_.facts())
        if (relation_of(fact) == Relation::kGrasping) options.push_back(object_of(fact));
    } else {
      options = resolver_.options(phrase, Sort::kMovable, now_);
      std::erase_if(options, [&](Symbol object) { return !now_.holds(object); });
      options = resolver_.chosen(phrase, options);
    }
    if (options.empty()) return "the robot does not hold that";
    objects.insert(objects.end(), options.begin(), options.end());
  }
  if (!said)
    for (const SymFact fact : now_.facts())
      if (relation_of(fact) == Relation::kGrasping) objects.push_back(object_of(fact));
  if (objects.empty()) return "it is not clear what to let go of";
  for (const Symbol object : objects)
    if (const Problem problem = act({Verb::kRelease, object}); !problem.empty()) return problem;
  return {};
}

}  // namespace goalnet::inference
