// goalnet plan DOMAIN.pddl PROBLEM.pddl: solves a PDDL problem and prints the plan.
#pragma once

namespace goalnet::tools {

// Exit code: 0 with a plan on standard output (competition format, or one JSON object with --json), otherwise
// the outcome's number (12 no plan, 13 invalid files or arguments, 20 time limit, 21 memory, 22 interrupted,
// 39 our fault) and a message on standard error.
int plan_command(int argc, char** argv);

}  // namespace goalnet::tools
