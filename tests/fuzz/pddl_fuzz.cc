// Feeds arbitrary text to the PDDL parsers; what parses is planned for, with limits, and plans are replayed.
// The first line that is only "====" separates the domain from the problem.
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "components/planner/planner.h"
#include "components/planner/validator.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::planner;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = text.find("\n====\n");
  const auto domain = parse_domain(text.substr(0, cut), "domain");
  if (!domain || cut == std::string_view::npos) return 0;
  const auto problem = parse_problem(text.substr(cut + 6), "problem", *domain);
  if (!problem) return 0;
  SolveOptions options;
  options.node_limit = 200;
  options.memory_limit = 16 << 20;
  options.time_limit = std::chrono::milliseconds(200);
  const auto plan = solve(*domain, *problem, options);
  if (plan && !validate(*problem, plan->actions)) std::abort();
  return 0;
}
