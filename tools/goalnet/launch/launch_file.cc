#include "tools/goalnet/launch/launch_file.h"

#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>

namespace goalnet::tools {
namespace {

constexpr std::size_t kLargestFile = 1u << 20;
constexpr std::size_t kMostProcesses = 200;

// Thrown inside this file only: YAML errors come as exceptions anyway.
struct Slip {
  YAML::Mark mark;
  std::string what;
};

[[noreturn]] void slip(const YAML::Node& node, const std::string& what) { throw Slip{node.Mark(), what}; }

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_keys(const YAML::Node& map, const std::string& what, std::initializer_list<const char*> known) {
  if (!map.IsMap()) slip(map, what + " must be a map of names and values");
  for (const auto& entry : map) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    slip(entry.first, what + " has no key '" + key.substr(0, 60) +
                          "'; known: " + listed(std::vector<std::string>(known.begin(), known.end())));
  }
}

class Reader {
 public:
  Reader(std::string folder, const LaunchSurroundings& surroundings)
      : folder_(std::move(folder)), surroundings_(surroundings) {}

  LaunchPlan read(const YAML::Node& root, const std::map<std::string, std::string>& given) {
    check_keys(root, "a launch file",
               {"arguments", "namespace", "use_sim_time", "environment", "restart", "patience", "processes"});
    take_arguments(root["arguments"], given);
    if (root["namespace"]) namespace_ = text(root["namespace"]);
    if (root["use_sim_time"]) use_sim_time_ = text(root["use_sim_time"]);
    if (root["environment"]) environment_ = texts_by_name(root["environment"], "environment");
    if (root["restart"]) restart_ = restart(root["restart"], restart_);
    LaunchPlan plan;
    if (root["patience"]) plan.patience = number(root["patience"], "patience", 0.0, 3600.0);
    const YAML::Node processes = root["processes"];
    if (!processes || !processes.IsMap() || processes.size() == 0)
      slip(root, "a launch file needs 'processes:' with at least one entry, NAME: {component: NAME}");
    if (processes.size() > kMostProcesses) slip(processes, "more than 200 processes");
    for (const auto& entry : processes) {
      const std::string name = text(entry.first);
      const bool twice = std::any_of(plan.processes.begin(), plan.processes.end(),
                                     [&](const LaunchedProcess& one) { return one.name == name; });
      if (twice) slip(entry.first, "there are two processes called '" + name + "'");
      plan.processes.push_back(process(name, entry.first, entry.second));
    }
    return plan;
  }

 private:
  void take_arguments(const YAML::Node& declared, const std::map<std::string, std::string>& given) {
    if (declared) {
      if (!declared.IsMap()) slip(declared, "'arguments' must be a map of names and default values");
      for (const auto& entry : declared) {
        if (!entry.second.IsScalar() && !entry.second.IsNull())
          slip(entry.second, "an argument's default must be plain text");
        arguments_[entry.first.as<std::string>()] = entry.second.IsNull() ? "" : entry.second.Scalar();
      }
    }
    for (const auto& [name, value] : given) {
      if (!arguments_.contains(name)) {
        std::vector<std::string> known;
        for (const auto& [one, ignored] : arguments_) known.push_back(one);
        throw Slip{YAML::Mark::null_mark(),
                   "there is no argument '" + name.substr(0, 60) +
                       "'; this file has: " + (known.empty() ? "none" : listed(known))};
      }
      arguments_[name] = value;
    }
  }

  // A scalar with its ${names} replaced.
  std::string text(const YAML::Node& node) const {
    if (!node.IsScalar()) slip(node, "plain text is needed here");
    const std::string& raw = node.Scalar();
    std::string out;
    for (std::size_t at = 0; at < raw.size();) {
      const std::size_t open = raw.find("${", at);
      out += raw.substr(at, open - at);
      if (open == std::string::npos) break;
      const std::size_t close = raw.find('}', open);
      if (close == std::string::npos) slip(node, "'${' without '}'");
      const std::string name = raw.substr(open + 2, close - open - 2);
      const auto found = arguments_.find(name);
      if (found == arguments_.end())
        slip(node, "${" + name.substr(0, 60) + "} is not among the file's arguments");
      out += found->second;
      at = close + 1;
    }
    return out;
  }

  double number(const YAML::Node& node, const std::string& name, double least, double most) const {
    double value = 0;
    std::istringstream in(text(node));
    if (!(in >> value) || !in.eof() || !(value >= least && value <= most)) {
      std::ostringstream what;
      what << "'" << name << "' must be a number from " << least << " to " << most;
      slip(node, what.str());
    }
    return value;
  }

  bool flag(const YAML::Node& node, const std::string& name) const {
    const std::string word = text(node);
    if (word != "true" && word != "false") slip(node, "'" + name + "' must be true or false");
    return word == "true";
  }

  std::map<std::string, std::string> texts_by_name(const YAML::Node& node, const std::string& what) const {
    if (!node.IsMap()) slip(node, "'" + what + "' must be a map of names and values");
    std::map<std::string, std::string> out;
    for (const auto& entry : node) out[text(entry.first)] = text(entry.second);
    return out;
  }

  RestartParams restart(const YAML::Node& node, RestartParams params) const {
    const auto when = [&](const YAML::Node& word_node) {
      const std::string word = text(word_node);
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
    check_keys(node, "'restart'", {"when", "delay", "longest_delay", "limit", "window"});
    if (node["when"]) params.when = when(node["when"]);
    if (node["delay"]) params.delay = number(node["delay"], "delay", 0.0, 3600.0);
    if (node["longest_delay"])
      params.longest_delay = number(node["longest_delay"], "longest_delay", 0.0, 3600.0);
    if (node["limit"]) params.limit = static_cast<int>(number(node["limit"], "limit", 0.0, 1e6));
    if (node["window"]) params.window = number(node["window"], "window", 0.0, 1e6);
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
      for (auto& [variable, value] : texts_by_name(node["environment"], "environment"))
        made.environment[variable] = value;
    }
    if (node["restart"]) made.restart = restart(node["restart"], restart_);
    if (node["required"]) made.required = flag(node["required"], "required");
    if (node["component"].IsDefined() == node["command"].IsDefined())
      slip(key, "process '" + name + "' needs either 'component: NAME' or 'command: [PROGRAM, …]'");
    made.command = node["component"] ? component(name, node) : command(node);
    return made;
  }

  std::vector<std::string> component(const std::string& name, const YAML::Node& node) const {
    const std::string kind = text(node["component"]);
    const auto& known = surroundings_.components;
    if (std::find(known.begin(), known.end(), kind) == known.end())
      slip(node["component"], "there is no component '" + kind.substr(0, 60) + "'; known: " + listed(known));
    std::vector<std::string> words = {surroundings_.goalnet, "component", kind, "--ros-args"};
    const auto add = [&words](const char* flag, const std::string& value) {
      words.push_back(flag);
      words.push_back(value);
    };
    const std::string space = node["namespace"] ? text(node["namespace"]) : namespace_;
    if (!space.empty() && space != "/") {
      add("-r", "__ns:=" + space);
      // Transforms carry the same frame names for every robot.
      add("-r", "/tf:=tf");
      add("-r", "/tf_static:=tf_static");
    }
    if (name != kind) add("-r", "__node:=" + name);
    if (!use_sim_time_.empty() && kind != "simulator") add("-p", "use_sim_time:=" + use_sim_time_);
    if (node["params_file"]) {
      const std::filesystem::path file(text(node["params_file"]));
      const std::string path = file.is_absolute() ? file.string() : folder_ + "/" + file.string();
      if (access(path.c_str(), R_OK) != 0)
        slip(node["params_file"], "cannot read the parameter file " + path);
      add("--params-file", path);
    }
    if (node["parameters"]) {
      for (const auto& [parameter, value] : texts_by_name(node["parameters"], "parameters"))
        add("-p", parameter + ":=" + (value.empty() ? "''" : value));
    }
    if (node["remap"]) {
      for (const auto& [from, to] : texts_by_name(node["remap"], "remap")) add("-r", from + ":=" + to);
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
    for (const auto& word : list) words.push_back(text(word));
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
  std::map<std::string, std::string> arguments_;
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
