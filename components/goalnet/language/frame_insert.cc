// Putting discs and dishes in: into the xbox, what is open, what is named.
#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::insert(const Clause& clause) {
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  const NounPhrase* destination = clause.first(Role::kDestination);
  if (!problem.empty()) return problem;
  if (destination == nullptr) {
    if (resolver_.is_of_class(objects.front(), "cd") && resolver_.exists(resolver_.xbox())) {
      for (const Symbol object : objects)
        if (problem = keep(object, resolver_.xbox(), Where::kIn); !problem.empty()) return problem;
      return {};
    }
    // "feed the xbox a disc"
    if (objects.size() == 2 && objects.front() == resolver_.xbox() && at_home_)
      return keep(objects[1], objects[0], Where::kIn);
    // "open the microwave, insert the mug"
    if (const Objects open = at_home_ ? pronoun(it(), Sort::kPlace, objects) : Objects{};
        !open.empty() && (open.front() == kMicrowave || open.front() == kFridge)) {
      for (const Symbol object : objects)
        if (problem = keep(object, open.front(), Where::kIn); !problem.empty()) return problem;
      return {};
    }
    return "it is not clear where to " + clause.verb + " it";
  }
  NounPhrase inside = *destination;
  inside.where = Where::kIn;
  return put_at(clause, objects, inside);
}

}  // namespace goalnet::inference
