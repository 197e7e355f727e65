// Between facts as the robot knows them and PDDL: problems from world states, and actions applied to them.
#pragma once

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/planner/domain.h"
#include "components/planner/problem.h"

namespace goalnet::planner {

// A problem from what is known and what is wanted.
// - An object that the domain names as a constant has its type there. Another one gets the type of a constant
//   of its class (Mug_7 that of Mug_1), else the type "thing" if the domain has it, else "object".
// - Constants that are a "thing" exist only where state.objects lists them; parts (doors, knobs, buttons) and
//   values always do.
// - Facts with a relation or value that the domain does not have are left out: a world may know more than a
//   domain.
// Errors: kUnknownObject (the goal names an object or value unknown; the nearest known name is told),
// kInvalidRequest (unknown relation, wrong number of arguments, a fact both wanted and unwanted: the pair is
// named).
Expected<Problem> make_problem(const Domain& domain, const WorldState& state, const Goal& goal);

// The same into an existing problem, reusing its memory.
Expected<void> make_problem(const WorldState& state, const Goal& goal, Problem& problem);

// Whether the action can be carried out. Errors: kInvalidRequest (unknown action, wrong arguments),
// kUnknownObject, kNoPlan with a message that names the violated precondition.
Expected<void> applicable(const Domain& domain, const WorldState& state, const Action& action);

// The facts after the action. Errors as above.
Expected<FactSet> apply(const Domain& domain, const WorldState& state, const Action& action);

}  // namespace goalnet::planner
