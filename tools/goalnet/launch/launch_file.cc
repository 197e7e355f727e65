#include "tools/goalnet/launch/launch_file.h"

#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tools/goalnet/launch/launch_values.h"

namespace goalnet::tools {
namespace {

constexpr std::size_t kLargestFile = 1u << 20;
constexpr std::size_t kMostProcesses = 200;

class Reader {
 public:
  Reader(std::string folder, const LaunchSurroundings& surroundings)
      : folder_(std::move(folder)), surroundings_(surroundings) {}

  LaunchPlan read(const YAML::Node& root, const std::map<std::string, std::string>& given) {
    check_keys(root, "a launch file",
               {"arguments", "namespace", "use_sim_time", "environment", "restart", "patience", "processes"});
    values_.take_arguments(root["arguments"], given);
    if (root["namespace"]) namespace_ = values_.text(root["namespace"]);
    if (root["use_sim_time"]) use_sim_time_ = values_.text(root["use_sim_time"]);
    if (root["environment"]) environment_ = values_.texts_by_name(root["environment"], "environment");
    if (root["restart"]) restart_ = restart(root["restart"], restart_);
    LaunchPlan plan;
    if (root["patience"]) plan.patience = values_.number(root["patience"], "patience", 0.0, 3600.0);
    const YAML::Node processes = root["processes"];
    if (!processes || !processes.IsMap() || processes.size() == 0)
      slip(root, "a launch file needs 'processes:' with at least one entry, NAME: {component: NAME}");
    if (processes.size() > kMostProcesses) slip(processes, "more than 200 processes");
    for (const auto& entry : processes) {
      const std::string name = values_.text(entry.first);
      const bool twice = std::any_of(plan.processes.begin(), plan.processes.end(),
                                     [&](const LaunchedProcess& one) { return one.name == name; });
      if (twice) slip(entry.first, "there are two processes called '" + name + "'");
      plan.processes.push_back(process(name, entry.first, entry.second));
    }
    return plan;
  }

 private:
  RestartParams restart(const YAML::Node& node, RestartParams params) const {
    const auto when = [&](const YAML::Node& word_node) {
      const std::string word = values_.text(word_node);
      if (word != "never" && word != "on_failure" && word != "always")
        slip(word_node, "'restart' must be never, on_failure or always");
      return word == "never"    ? RestartWhen::kNever
             : word == "always" ? RestartWhen::kAlways
                                : RestartWhen::kOnFailure;
    };
    if (node.IsScalar()) {
      params.when = when(node);
      return params;
    }
    check_keys(node, "'restart'", {"when", "delay", "longest_delay", "limit", "window", "silent_after"});
    if (node["when"]) params.when = when(node["when"]);
    if (node["delay"]) params.delay = values_.number(node["delay"], "delay", 0.0, 3600.0);
    if (node["longest_delay"])
      params.longest_delay = values_.number(node["longest_delay"], "longest_delay", 0.0, 3600.0);
    if (node["limit"]) params.limit = static_cast<int>(values_.number(node["limit"], "limit", 0.0, 1e6));
    if (node["window"]) params.window = values_.number(node["window"], "window", 0.0, 1e6);
    if (node["silent_after"])
      params.silent_after = values_.number(node["silent_after"], "silent_after", 0.0, 1e6);
    return params;
  }

  LaunchedProcess process(const std::string& name, const YAML::Node& key, const YAML::Node& node) const {
    if (name.empty()) slip(key, "a process needs a name");
    check_keys(node, "process '" + name + "'",
               {"component", "command", "parameters", "params_file", "namespace", "remap", "arguments",
                "environment", "restart", "required"});
    LaunchedProcess made;
    made.name = name;
    made.restart = restart_;
    made.environment = environment_;
    if (node["environment"]) {
      for (auto& [variable, value] : values_.texts_by_name(node["environment"], "environment"))
        made.environment[variable] = value;
    }
    // So that an argument can leave a variable as it is where `goalnet launch` was started.
    std::erase_if(made.environment, [](const auto& entry) { return entry.second.empty(); });
    if (node["restart"]) made.restart = restart(node["restart"], restart_);
    if (node["required"]) made.required = values_.flag(node["required"], "required");
    if (node["component"].IsDefined() == node["command"].IsDefined())
      slip(key, "process '" + name + "' needs either 'component: NAME' or 'command: [PROGRAM, …]'");
    made.command = node["component"] ? component(name, node) : command(node);
    if (node["component"]) {
      const std::string space = node_namespace(node);
      made.node =
          (space.starts_with("/") ? "" : "/") + space + (space.empty() || space == "/" ? "" : "/") + name;
    }
    return made;
  }

  std::string node_namespace(const YAML::Node& node) const {
    return node["namespace"] ? values_.text(node["namespace"]) : namespace_;
  }

  std::vector<std::string> component(const std::string& name, const YAML::Node& node) const {
    const std::string kind = values_.text(node["component"]);
    const auto& known = surroundings_.components;
    if (std::find(known.begin(), known.end(), kind) == known.end())
      slip(node["component"], "there is no component '" + kind.substr(0, 60) + "'; known: " + listed(known));
    std::vector<std::string> words = {surroundings_.goalnet, "component", kind, "--ros-args"};
    const auto add = [&words](const char* flag, const std::string& value) {
      words.push_back(flag);
      words.push_back(value);
    };
    const std::string space = node_namespace(node);
    if (!space.empty() && space != "/") {
      add("-r", "__ns:=" + space);
      // Transforms carry the same frame names for every robot.
      add("-r", "/tf:=tf");
      add("-r", "/tf_static:=tf_static");
    }
    if (name != kind) add("-r", "__node:=" + name);
    if (!use_sim_time_.empty() && kind != "simulator") add("-p", "use_sim_time:=" + use_sim_time_);
    if (node["params_file"]) {
      const std::filesystem::path file(values_.text(node["params_file"]));
      const std::string path = file.is_absolute() ? file.string() : folder_ + "/" + file.string();
      if (access(path.c_str(), R_OK) != 0)
        slip(node["params_file"], "cannot read the parameter file " + path);
      add("--params-file", path);
    }
    if (node["parameters"]) {
      for (const auto& [parameter, value] : values_.texts_by_name(node["parameters"], "parameters"))
        add("-p", parameter + ":=" + (value.empty() ? "''" : value));
    }
    if (node["remap"]) {
      for (const auto& [from, to] : values_.texts_by_name(node["remap"], "remap"))
        add("-r", from + ":=" + to);
    }
    if (node["arguments"]) append(node["arguments"], words);
    return words;
  }

  std::vector<std::string> command(const YAML::Node& node) const {
    for (const char* only : {"parameters", "params_file", "namespace", "remap"}) {
      if (node[only]) slip(node[only], std::string("'") + only + "' is for components only");
    }
    std::vector<std::string> words;
    append(node["command"], words);
    if (words.empty() || words[0].empty())
      slip(node["command"], "'command' must be a list: [PROGRAM, ARGUMENT, …]");
    if (node["arguments"]) append(node["arguments"], words);
    words[0] = executable(words[0], node["command"]);
    return words;
  }

  void append(const YAML::Node& list, std::vector<std::string>& words) const {
    if (!list.IsSequence()) slip(list, "a list of words is needed here: [PROGRAM, ARGUMENT, …]");
    for (const auto& word : list) words.push_back(values_.text(word));
  }

  std::string executable(const std::string& program, const YAML::Node& node) const {
    if (program.find('/') != std::string::npos) {
      const std::string path = program[0] == '/' ? program : folder_ + "/" + program;
      if (access(path.c_str(), X_OK) != 0 || std::filesystem::is_directory(path))
        slip(node, path + " cannot be executed");
      return path;
    }
    std::istringstream folders(surroundings_.search_path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      const std::string path = folder + "/" + program;
      if (!folder.empty() && access(path.c_str(), X_OK) == 0 && !std::filesystem::is_directory(path))
        return path;
    }
    slip(node, "there is no program '" + program.substr(0, 60) + "' in PATH");
  }

  const std::string folder_;
  const LaunchSurroundings& surroundings_;
  LaunchValues values_;
  std::string namespace_;
  std::string use_sim_time_;
  std::map<std::string, std::string> environment_;
  RestartParams restart_;
};

std::string place(const std::string& origin, const YAML::Mark& mark) {
  return mark.is_null() ? origin : origin + ":" + std::to_string(mark.line + 1);
}

}  // namespace

Expected<LaunchPlan> parse_launch(const std::string& text, const std::string& origin,
                                  const std::string& folder, const std::map<std::string, std::string>& given,
                                  const LaunchSurroundings& surroundings) {
  try {
    return Reader(folder, surroundings).read(YAML::Load(text), given);
  } catch (const Slip& error) {
    return fail(Outcome::kInvalidRequest, place(origin, error.mark) + ": " + error.what);
  } catch (const YAML::Exception& error) {
    return fail(Outcome::kInvalidRequest, place(origin, error.mark) + ": this is no YAML: " + error.msg);
  }
}

Expected<LaunchPlan> read_launch_file(const std::string& path,
                                      const std::map<std::string, std::string>& given,
                                      const LaunchSurroundings& surroundings) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    return fail(Outcome::kInvalidRequest, "cannot read the launch file " + path);
  std::string text(kLargestFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kLargestFile) return fail(Outcome::kInvalidRequest, path + ": larger than 1 MiB");
  const auto folder = std::filesystem::path(path).parent_path();
  return parse_launch(text, path, folder.empty() ? "." : folder.string(), given, surroundings);
}

}  // namespace goalnet::tools
