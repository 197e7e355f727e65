#include "tools/goalnet/run_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <string_view>

#include "components/coordinator/request.h"

namespace goalnet::tools {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  goalnet run \"fill the mug with water\"\n"
    "  goalnet run --seed 3 --json \"open the microwave\"\n"
    "  goalnet run --goal \"(On Mug_1 Sink)\" --goal \"not (state SinkKnob TapIsOn)\"\n"
    "\n"
    "After --ros-args, -p NAME:=VALUE sets the parameter on every component that has it, -p NODE:NAME:=VALUE "
    "on one:\n"
    "  goalnet run \"open the microwave\" --ros-args -p planner:node_limit:=5000 -p world_model:rate:=20.0\n"
    "\"goalnet component NAME --show-parameters\" lists them.\n"
    "\n"
    "The components speak DDS on ROS_DOMAIN_ID, so \"ros2 topic echo /world_state\" shows the run. Runs that "
    "go on "
    "at\n"
    "the same time need a domain or a namespace each, or --private.\n"
    "Ctrl-C stops the robot smoothly and ends with code 22.";

// As the simulator's parameter has it. CLI11 alone takes -1 for 2^64 - 1.
constexpr std::uint64_t kMostSeed = 1'000'000'000'000'000;

// "(On Mug_1 Sink)" or "not (On Mug_1 Sink)".
Expected<void> add_goal(std::string_view text, Goal& goal) {
  const std::size_t start = text.find_first_not_of(" \t");
  text.remove_prefix(start == std::string_view::npos ? text.size() : start);
  const bool negative = text.starts_with("not ") || text.starts_with("not(");
  const auto predicate = parse_predicate(negative ? text.substr(3) : text);
  if (!predicate) return tl::unexpected<Error>(predicate.error());
  (negative ? goal.negative : goal.positive).push_back(*predicate);
  return {};
}

}  // namespace

ParsedRun parse_run_options(int argc, char** argv) {
  ParsedRun parsed;
  RunOptions& options = parsed.options;
  // --ros-args follows ROS 2's own grammar and is parsed where nodes are made.
  char** const ros =
      std::find_if(argv, argv + argc, [](const char* a) { return std::string_view(a) == "--ros-args"; });
  options.ros_arguments.assign(ros, argv + argc);
  const int own = static_cast<int>(ros - argv);

  CLI::App app{
      "Lets a simulated robot carry out an instruction: all components in one process, over DDS, in "
      "simulated "
      "time that runs as fast as this machine allows. The same seed gives the same run."};
  app.name("goalnet run");
  app.footer(kFooter);
  std::vector<std::string> words, goals;
  app.add_option("instruction", words, "What to do, in plain English");
  app.add_option("--scene", options.scene, "kitchen, living_room, or a scene file (YAML)")
      ->capture_default_str();
  app.add_option("--robot", options.robot, "Robot file (YAML beside its URDF) [config/robots/default.yaml]");
  app.add_option("--model", options.model, "Goal model file [config/models/goalnet.safetensors]");
  app.add_option("--seed", options.seed, "Varies where things stand")
      ->check(CLI::Range(std::uint64_t{0}, kMostSeed))
      ->capture_default_str();
  auto* untidy = app.add_flag(
      "--untidy", options.untidy,
      "Start in a mess that the seed decides: things pushed, tipped over, on other furniture, on the floor");
  app.add_option(
         "--start", options.start,
         "Start from the places and states in this file: the JSON of another run, or {\"facts\": "
         "[\"(On Mug_1 Sink)\", …]}. With \"objects\" it is the whole state: nothing holds but what it says")
      ->excludes(untidy);
  app.add_option("--goal", goals, "Predicate to reach instead of an instruction, or \"not (…)\"; repeatable")
      ->allow_extra_args(false);
  app.add_option("--max-steps", options.max_steps, "Inference steps before giving up [30]")
      ->check(CLI::Range(1, 1000));
  app.add_option("--max-sim-time", options.max_sim_time, "Simulated seconds before giving up [1800]")
      ->check(CLI::Range(0.1, 1e6));
  app.add_option("--render", options.render, "Folder for a picture (PNG) after each action; about 1 s each");
  app.add_option(
      "--record", options.record,
      "Directory to record all topics into, stamped in simulated time (goalnet replay, ros2 bag, Foxglove)");
  app.add_option("--record-storage", options.record_storage, "mcap or sqlite3")
      ->check(CLI::IsMember({"mcap", "sqlite3"}))
      ->capture_default_str();
  app.add_flag("--private", options.private_run,
               "Take part in no ROS_DOMAIN_ID: nobody sees or disturbs the run. For many at the same time");
  app.add_flag("-v,--verbose", options.verbose,
               "The components' logs on standard error as well as on /rosout");
  app.add_flag("--json", options.json, "One JSON object on standard output and nothing else");
  const auto refuse = [&parsed](std::string message) {
    parsed.refused = Error{Outcome::kInvalidRequest, std::move(message)};
    return parsed;
  };
  try {
    app.parse(own, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app.exit(error);
      parsed.help_shown = true;
      return parsed;
    }
    options.json =
        std::any_of(argv, argv + own, [](const char* a) { return std::string_view(a) == "--json"; });
    return refuse(std::string(error.what()) + "; \"goalnet run --help\" tells more");
  }
  for (const std::string& goal : goals) {
    if (const auto added = add_goal(goal, options.goal); !added)
      return refuse("--goal: " + added.error().message);
  }
  // Forgotten quotes are forgiven: the words are one instruction.
  for (const std::string& word : words)
    options.instruction += (options.instruction.empty() ? "" : " ") + word;
  if (!goals.empty()) {
    if (!words.empty()) return refuse("give either an instruction or --goal, not both");
    if (const auto checked = coordinator::check_goal(options.goal); !checked)
      return refuse(checked.error().message);
    return parsed;
  }
  if (const auto checked = coordinator::check_instruction(options.instruction); !checked) {
    return refuse(checked.error().message);
  }
  return parsed;
}

}  // namespace goalnet::tools
