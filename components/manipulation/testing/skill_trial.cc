// goalnet_skill_trial [--seed N] [--scene S] [--quiet] "moveto Mug_1" "grasp Mug_1" ...
// [--contacts] also prints what the robot begins to touch.
// Runs symbolic actions one after the other in physics, without DDS, and prints what happens. Exit code 0 if
// all of them are done, else the outcome of the first that is not.
#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

#include "components/manipulation/testing/physics_harness.h"

int main(int argc, char** argv) {
  using namespace goalnet;
  std::uint64_t seed = 0;
  std::string scene = "kitchen";
  bool quiet = false, contacts = false;
  std::vector<Action> actions;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--seed" && i + 1 < argc) {
      seed = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--scene" && i + 1 < argc) {
      scene = argv[++i];
    } else if (word == "--quiet") {
      quiet = true;
    } else if (word == "--contacts") {
      contacts = true;
    } else {
      std::istringstream in(word);
      Action action;
      in >> action.name;
      for (std::string argument; in >> argument;) action.arguments.push_back(argument);
      actions.push_back(action);
    }
  }
  auto harness = manipulation::PhysicsHarness::create(scene, "default", seed);
  if (!harness) {
    std::fprintf(stderr, "%s\n", harness.error().message.c_str());
    return static_cast<int>(harness.error().outcome);
  }
  if (!quiet) {
    (*harness)->on_stage = [](double time, const std::string& stage) {
      std::printf("    %7.2f s  %s\n", time, stage.c_str());
    };
  }
  std::set<std::string> touching;
  if (contacts) {
    (*harness)->cancel_when = [&](double time) {
      std::set<std::string> now;
      for (const auto& contact : (*harness)->world().contacts()) {
        if (contact.a.starts_with("robot/") || contact.b.starts_with("robot/"))
          now.insert(contact.a + " - " + contact.b);
      }
      for (const auto& pair : now) {
        if (!touching.contains(pair)) std::printf("      %7.2f s into it: %s\n", time, pair.c_str());
      }
      touching = now;
      return false;
    };
  }
  (*harness)->wait(0.1);
  FactSet before = (*harness)->facts();
  for (const auto& action : actions) {
    std::printf("%s\n", to_string(action).c_str());
    const auto result = (*harness)->run(action);
    std::printf("  -> %s in %.2f s, planning %.0f ms, %d failed attempts%s%s\n",
                std::string(to_string(result.result.outcome)).c_str(), result.sim_time,
                result.planning_time * 1e3, result.attempts, result.result.message.empty() ? "" : ": ",
                result.result.message.c_str());
    (*harness)->wait(0.3);
    const FactSet after = (*harness)->facts();
    for (const auto& fact : difference(after, before)) std::printf("     + %s\n", to_string(fact).c_str());
    for (const auto& fact : difference(before, after)) std::printf("     - %s\n", to_string(fact).c_str());
    before = after;
    if (result.result.outcome != Outcome::kDone) return static_cast<int>(result.result.outcome);
  }
  return 0;
}
