#include "tools/goalnet/eval_physics_command.h"

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "components/scene/scene.h"
#include "tools/goalnet/command_line.h"
#include "tools/goalnet/physics_run.h"
#include "tools/goalnet/progress_line.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

using namespace goalnet::inference;

struct Totals {
  Scores sum;
  std::size_t arranged = 0;
  double sim_seconds = 0;
  std::map<Outcome, std::size_t> outcomes;
};

void add(Totals& totals, const PhysicsRun& run) {
  totals.sum += run.run.scores;
  totals.arranged += run.not_arranged.empty();
  totals.sim_seconds += run.sim_seconds;
  ++totals.outcomes[run.outcome];
}

void print(const Totals& totals, std::size_t count, double seconds, bool json) {
  const Scores mean = totals.sum / static_cast<double>(count);
  if (json) {
    nlohmann::ordered_json outcomes = nlohmann::ordered_json::object();
    for (const auto& [outcome, runs] : totals.outcomes) outcomes[std::string(to_string(outcome))] = runs;
    nlohmann::ordered_json object = {{"count", count},
                                     {"grounding", "none"},
                                     {"physics", true},
                                     {"arranged", totals.arranged},
                                     {"outcomes", outcomes},
                                     {"sji", mean.sji},
                                     {"ied", mean.ied},
                                     {"f1", mean.f1},
                                     {"grr", mean.grr},
                                     {"grr_formula", mean.grr_formula},
                                     {"exact", mean.exact},
                                     {"ied_canonical", mean.ied_canonical},
                                     {"sim_seconds", totals.sim_seconds},
                                     {"seconds", seconds}};
    print_json(object);
    return;
  }
  std::printf(
      "%zu demonstrations in physics, %zu of them from just the recorded start; %.0f s simulated in %.0f s\n",
      count, totals.arranged, totals.sim_seconds, seconds);
  std::size_t blocks[4] = {};  // done, refused, limit, fault
  for (const auto& [outcome, runs] : totals.outcomes) blocks[static_cast<int>(outcome) / 10] += runs;
  std::printf("%zu done, %zu refused, %zu at a limit, %zu faults\n", blocks[0], blocks[1], blocks[2],
              blocks[3]);
  std::printf("SJI %.3f  IED %.3f  F1 %.3f  GRR %.3f   (grr_formula %.3f, exact %.3f, ied_canonical %.3f)\n",
              mean.sji, mean.ied, mean.f1, mean.grr, mean.grr_formula, mean.exact, mean.ied_canonical);
}

}  // namespace

int eval_physics_command(int argc, char** argv) {
  CLI::App app(
      "Lets the simulated robot carry out every recorded instruction, from the state in which the recording "
      "begins, and compares what changed.",
      "goalnet eval");
  app.footer("Example:\n  goalnet eval demonstrations --physics --limit 20 --runs runs.jsonl");
  std::string folder, grounding = "none", runs;
  PhysicsOptions options;
  std::size_t limit = 0;
  bool json = false, perturbed = false, verbose = false;
  app.add_option("DIR", folder, "folder of demonstrations (*.json)")->required();
  app.add_option("--model", options.model, "model file");
  app.add_option("--grounding", grounding, "none: the robot hears the sentence only")
      ->check(CLI::IsMember({"given", "none"}));
  app.add_option("--seed", options.seed, "how things stand that the recordings do not speak of");
  app.add_option("--limit", limit, "only so many of them; 0: all");
  app.add_option("--runs", runs, "write every run to this file, one JSON object a line");
  app.add_flag("--physics")->description("this");
  app.add_flag("--include-perturbed", perturbed, "the randomly perturbed a_* files too");
  app.add_flag("--verbose", verbose, "a line for each on standard error");
  app.add_flag("--json", json, "print one JSON object");
  if (const auto code = parse_or_tell(app, argc, argv)) return *code;
  const auto report = [&](const Error& error) { return tell(app.get_name(), error, json); };
  if (grounding == "given")
    return report({Outcome::kInvalidRequest,
                   "the robot hears the sentence only; leave --grounding given out, or --physics"});
  auto demonstrations = read_demonstrations(folder);
  if (!demonstrations) return report(demonstrations.error());
  if (!perturbed) std::erase_if(*demonstrations, [](const Demonstration& d) { return d.perturbed; });
  if (demonstrations->empty())
    return report({Outcome::kInvalidRequest, folder + ": holds only perturbed demonstrations"});
  if (limit > 0 && limit < demonstrations->size()) demonstrations->resize(limit);
  std::vector<scene::Scene> scenes;
  for (const char* name : {"kitchen", "living_room"}) {
    auto scene = scene::load_scene(name);
    if (!scene) return report(scene.error());
    scenes.push_back(std::move(*scene));
  }
  if (!runs.empty())  // before the work, not after it
    if (const auto writable = write_runs({}, runs); !writable) return report(writable.error());

  const StopSignal stop;
  options.stop_asked = [&stop] { return stop.requested(); };
  ProgressLine progress(std::chrono::seconds(30));
  Totals totals;
  std::vector<ModelRun> done;
  for (const Demonstration& demonstration : *demonstrations) {
    const auto run = run_in_physics(demonstration, scene_of(demonstration, scenes), options);
    if (!run) return report(run.error());
    add(totals, *run);
    done.push_back(run->run);
    if (verbose) {
      std::string missing;
      for (const Predicate& fact : run->not_arranged) missing += " " + to_string(fact);
      std::fprintf(stderr, "%s \"%s\": %s, SJI %.2f%s%s%s%s\n", demonstration.id.c_str(),
                   demonstration.sentence.c_str(), std::string(to_string(run->outcome)).c_str(),
                   run->run.scores.sji, run->message.empty() ? "" : ", ", run->message.c_str(),
                   missing.empty() ? "" : "; not as recorded:", missing.c_str());
    } else if (!json) {
      progress.show(static_cast<double>(done.size()) / static_cast<double>(demonstrations->size()));
    }
  }
  if (!json && !verbose) progress.finish();
  if (!runs.empty())
    if (const auto written = write_runs(done, runs); !written) return report(written.error());
  print(totals, done.size(), progress.seconds(), json);
  return 0;
}

}  // namespace goalnet::tools
