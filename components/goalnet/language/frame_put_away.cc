// Putting things away, back, where they belong.
#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

// "put the books away", "put it back": where they were or belong; else it is not clear where.
std::string FrameActions::put_away(const Clause& clause) {
  const bool home = clause.has_particle("at_home"),
             back = clause.has_particle("back") || clause.verb == "return";
  Problem problem;
  auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  if (!says_away(clause)) return put_by_its_kind(clause, objects);
  if (back && !home) what_was_moved(clause, objects);
  for (const Symbol object : objects) {
    const Symbol was = back && !home ? resolver_.place_of(object, start_) : Symbol{kNone};
    const Symbol place = was != kNone ? was : home_of(object);
    if (place == kNone)
      return back ? "it is not known where " + resolver_.name(object) + " was"
                  : "it is not clear where to put " + resolver_.name(object) + " away";
    // several places are a home ("the shelves"): where it stands on one of them it may stay
    if (was == kNone && is_home(object, resolver_.place_of(object, now_))) continue;
    const bool inside =
        was != kNone ? start_.has(Relation::kIn, object, was) : place == kFridge || place == kGarbageBin_1;
    if (problem = keep(object, place, inside ? Where::kIn : Where::kOn); !problem.empty()) return problem;
  }
  return {};
}

// "take the ice cream, put a scoop in the bowl, put it back": what is no longer where it was
void FrameActions::what_was_moved(const Clause& clause, Objects& objects) const {
  const NounPhrase* thing = clause.first(Role::kDirect);
  const auto moved = [&](Symbol object) {
    const Symbol was = resolver_.place_of(object, start_);
    return was != kNone && resolver_.place_of(object, now_) != was;
  };
  if (!at_home_ || thing == nullptr || !thing->pronoun || thing->plural || objects.size() != 1 ||
      moved(objects.front()))
    return;
  for (auto spoken = history_.rbegin(); spoken != history_.rend(); ++spoken)
    for (const Symbol object : *spoken)
      if (moved(object)) {
        objects = {object};
        return;
      }
}

bool FrameActions::says_away(const Clause& clause) {
  return clause.has_particle("at_home") || clause.has_particle("back") || clause.verb == "return" ||
         clause.has_particle("away") || clause.verb == "store" || clause.verb == "stow";
}

// "load the disc", "stack the plates"
std::string FrameActions::put_by_its_kind(const Clause& clause, const Objects& objects) {
  if (clause.verb == "load" && resolver_.is_of_class(objects.front(), "cd") &&
      resolver_.exists(resolver_.xbox()))
    return keep(objects.front(), resolver_.xbox(), Where::kIn);
  if (clause.verb == "stack" || clause.verb == "pile") return stack(objects);
  return "it is not clear where to put " + resolver_.name(objects.front());
}

// "stack the plates": each on the one before.
std::string FrameActions::stack(const Objects& objects) {
  if (objects.size() < 2) return "it is not clear what to put " + resolver_.name(objects.front()) + " on";
  for (std::size_t i = 1; i < objects.size(); ++i)
    if (const Problem problem = keep(objects[i], objects[i - 1], Where::kOn); !problem.empty())
      return problem;
  return {};
}

}  // namespace goalnet::inference
