#include "tools/goalnet/launch/launch_command.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "components/core/config_path.h"
#include "tools/goalnet/component_registry.h"
#include "tools/goalnet/launch/launch_file.h"
#include "tools/goalnet/launch/launcher.h"
#include "tools/goalnet/launch/life_signs.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

constexpr const char* kHelp =
    "usage: goalnet launch FILE [NAME:=VALUE …] [--json]\n"
    "\n"
    "Starts the processes that FILE (YAML, or a name in config/launch) lists, puts their names before their "
    "output,\n"
    "starts them again when they fail, or are silent for longer than restart: {silent_after: S} says (with "
    "growing\n"
    "pauses, a limited number of times) and ends them in order at\n"
    "Ctrl-C or SIGTERM. NAME:=VALUE sets an argument of the file. --json: one JSON object a line on standard "
    "output\n"
    "for each thing that happens; the processes' output goes to standard error.\n"
    "\n"
    "exit codes: 0 ended as asked; 13 the file makes no sense; 14 a component is up already; 32 a required "
    "process is lost.\n"
    "\n"
    "Examples:\n"
    "  goalnet launch robot scene:=living_room\n"
    "  goalnet launch robot namespace:=/robot1\n";

struct Options {
  std::string file;
  std::map<std::string, std::string> arguments;
  bool json = false;
};

int refuse(const Error& error) {
  std::cerr << "goalnet launch: " << error.message << "\n";
  return static_cast<int>(error.outcome);
}

Expected<Options> parse(const std::vector<std::string>& words) {
  Options options;
  for (const std::string& word : words) {
    const std::size_t at = word.find(":=");
    if (word == "--json") {
      options.json = true;
    } else if (at != std::string::npos && at > 0) {
      options.arguments[word.substr(0, at)] = word.substr(at + 2);
    } else if (word.starts_with("-")) {
      return fail(Outcome::kInvalidRequest, "unknown option \"" + word.substr(0, 60) + "\"; there is --json");
    } else if (options.file.empty()) {
      options.file = word;
    } else {
      return fail(Outcome::kInvalidRequest, "one file at a time; \"" + word.substr(0, 60) + "\" is too many");
    }
  }
  if (options.file.empty())
    return fail(Outcome::kInvalidRequest, "which file? \"goalnet launch --help\" tells more");
  return options;
}

// "components, robot": the files that are shipped.
std::string shipped() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(config_path("launch"), ignored)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void print(const LaunchEvent& event, bool json) {
  if (json) {
    const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
    nlohmann::json line = {{"time", std::chrono::duration<double>(since_1970).count()},
                           {"process", event.process},
                           {"event", to_string(event.kind)}};
    if (event.pid > 0) line["pid"] = event.pid;
    if (event.kind == LaunchEvent::Kind::kEnded) line["exit_code"] = event.exit_code;
    if (event.kind == LaunchEvent::Kind::kRestarting) line["delay"] = event.delay;
    if (!event.message.empty()) line["message"] = event.message;
    std::cout << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
    return;
  }
  std::string text = to_string(event.kind);
  if (event.kind == LaunchEvent::Kind::kStarted) text += ", process " + std::to_string(event.pid);
  if (event.kind == LaunchEvent::Kind::kEnded) text += " with code " + std::to_string(event.exit_code);
  if (event.kind == LaunchEvent::Kind::kRestarting) {
    char delay[32];
    std::snprintf(delay, sizeof delay, " in %.2g s", event.delay);
    text += delay;
  }
  if (!event.message.empty()) text += ": " + event.message;
  std::cerr << "[" << event.process << "] -- " << text << std::endl;
}

}  // namespace

int launch_command(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && (words[0] == "--help" || words[0] == "-h")) {
    std::fputs(kHelp, stdout);
    return 0;
  }
  const auto options = parse(words);
  if (!options) return refuse(options.error());
  LaunchSurroundings surroundings;
  surroundings.goalnet = program_folder() + "/goalnet-robot";
  for (const ComponentKind& kind : component_kinds()) surroundings.components.emplace_back(kind.name);
  if (const char* path = std::getenv("PATH")) surroundings.search_path = path;
  const std::string file = config_file("launch", options->file, ".yaml");
  if (access(file.c_str(), R_OK) != 0)
    return refuse({Outcome::kInvalidRequest,
                   "cannot read the launch file " + file + "; config/launch has: " + shipped()});
  const auto plan = read_launch_file(file, options->arguments, surroundings);
  if (!plan) return refuse(plan.error());

  const StopSignal stop;
  LaunchCallbacks callbacks;
  callbacks.on_event = [&](const LaunchEvent& event) { print(event, options->json); };
  callbacks.on_line = [&](const std::string& process, const std::string& line, bool error) {
    (error || options->json ? std::cerr : std::cout) << "[" << process << "] " << line << std::endl;
  };
  callbacks.stop_asked = [&] { return stop.requested(); };
  std::unique_ptr<LifeSigns> signs;
  const auto component = [](const LaunchedProcess& process) { return !process.node.empty(); };
  if (std::any_of(plan->processes.begin(), plan->processes.end(), component)) {
    auto made = LifeSigns::watch(*plan);
    if (!made) return refuse(made.error());
    signs = std::move(*made);
    // Two under one name would follow each other's orders.
    if (const std::string up = signs->up_already(); !up.empty())
      return refuse({Outcome::kBusy, "the node " + up +
                                         " is up already, started by somebody else: end that, or take "
                                         "another ROS_DOMAIN_ID or namespace"});
    callbacks.last_sign = [&](const std::string& node) { return signs->last(node); };
  }
  const auto done = launch(*plan, callbacks);
  if (done) return 0;
  return refuse(done.error());
}

}  // namespace goalnet::tools
