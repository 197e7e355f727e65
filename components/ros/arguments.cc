#include "components/ros/arguments.h"

#include <algorithm>
#include <tuple>

#include "components/ros/names.h"
#include "components/ros/parameter_file.h"

namespace goalnet::ros {
namespace {

tl::unexpected<Error> bad(const std::string& what) {
  return fail(Outcome::kInvalidRequest, "--ros-args: " + what);
}

// "node:rest" -> {node, rest}; "/ns/node:rest" likewise; no ':' before the rest: node "".
std::pair<std::string, std::string> split_node(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) return {"", text};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

// Splits at the first ":=".
Expected<std::pair<std::string, std::string>> split_assignment(const std::string& flag,
                                                               const std::string& text) {
  const auto at = text.find(":=");
  if (at == std::string::npos || at == 0) {
    return bad(flag + " '" + text.substr(0, 200) + "' must look like " +
               (flag == "-r" ? "from:=to" : "name:=value"));
  }
  return std::pair(text.substr(0, at), text.substr(at + 2));
}

// Cuts "rostopic://" or "rosservice://" off `from`.
RemapKind take_scheme(std::string& from) {
  for (const auto& [scheme, kind] :
       {std::pair("rostopic://", RemapKind::kTopic), std::pair("rosservice://", RemapKind::kService)}) {
    if (!from.starts_with(scheme)) continue;
    from.erase(0, std::string_view(scheme).size());
    return kind;
  }
  return RemapKind::kName;
}

Expected<void> take_remap(const std::string& text, Arguments& out) {
  auto rule = split_assignment("-r", text);
  if (!rule) return tl::unexpected(rule.error());
  std::string from = rule->first, node;
  const std::string& to = rule->second;
  RemapKind kind = take_scheme(from);
  if (kind == RemapKind::kName) {
    std::tie(node, from) = split_node(from);
    kind = take_scheme(from);  // NODE:rostopic://FROM
  }
  if (from == "__node" || from == "__name") {
    if (auto ok = check_node_name(to); !ok) return bad(ok.error().message);
    out.remaps.push_back({node, RemapKind::kNodeName, "", to});
    return {};
  }
  if (from == "__ns") {
    auto space = normalize_namespace(to);
    if (!space) return bad(space.error().message);
    out.remaps.push_back({node, RemapKind::kNamespace, "", *space});
    return {};
  }
  if (from.empty() || to.empty()) return bad("-r '" + text.substr(0, 200) + "' must look like from:=to");
  for (const std::string& name : {from, to}) {
    if (auto ok = expand_name(name, "/", "node"); !ok) return bad("-r: " + ok.error().message);
  }
  out.remaps.push_back({node, kind, from, to});
  return {};
}

Expected<void> take_parameter(const std::string& text, Arguments& out) {
  auto assignment = split_assignment("-p", text);
  if (!assignment) return tl::unexpected(assignment.error());
  auto [node, name] = split_node(assignment->first);
  if (name.empty()) return bad("-p '" + text.substr(0, 200) + "' must look like name:=value");
  auto value = parse_parameter_value(assignment->second, "-p " + name);
  if (!value) return tl::unexpected(value.error());
  out.parameters.push_back({node.empty() ? "/**" : node, name, std::move(*value), "-p"});
  return {};
}

Expected<void> take_level(const std::string& text, Arguments& out) {
  const auto at = text.find(":=");
  auto level = parse_log_level(at == std::string::npos ? text : text.substr(at + 2));
  if (!level) return bad("--log-level: " + level.error().message);
  if (at == std::string::npos) {
    out.log_level = *level;
  } else {
    out.logger_levels.emplace_back(text.substr(0, at), *level);
  }
  return {};
}

Expected<void> take_value(const std::string& flag, const std::string& value, Arguments& out) {
  if (flag == "-r" || flag == "--remap") return take_remap(value, out);
  if (flag == "-p" || flag == "--param") return take_parameter(value, out);
  if (flag == "--log-level") return take_level(value, out);
  if (flag == "-e" || flag == "--enclave") {
    out.enclave = value;
    return {};
  }
  if (flag != "--params-file") return {};  // where and how rcl's log library writes files: there is none here
  auto parameters = read_parameter_file(value);
  if (!parameters) return tl::unexpected(parameters.error());
  out.parameters.insert(out.parameters.end(), parameters->begin(), parameters->end());
  return {};
}

bool takes_value(const std::string& flag) {
  return flag == "-r" || flag == "--remap" || flag == "-p" || flag == "--param" || flag == "--log-level" ||
         flag == "-e" || flag == "--enclave" || flag == "--params-file" || flag == "--log-config-file" ||
         flag == "--log-file-name";
}

std::optional<std::string> first_rule(const std::vector<Remap>& rules, RemapKind kind,
                                      const std::string& name) {
  const auto found = std::find_if(rules.begin(), rules.end(), [&](const Remap& rule) {
    return rule.kind == kind && (rule.node.empty() || rule.node == name);
  });
  return found == rules.end() ? std::nullopt : std::optional(found->to);
}

}  // namespace

std::optional<std::string> Arguments::node_name(const std::string& name) const {
  return first_rule(remaps, RemapKind::kNodeName, name);
}

std::optional<std::string> Arguments::node_namespace(const std::string& name) const {
  return first_rule(remaps, RemapKind::kNamespace, name);
}

std::optional<LogLevel> Arguments::level_of(const std::string& logger) const {
  std::optional<LogLevel> level = log_level;
  std::size_t nearest = 0;
  for (const auto& [name, one] : logger_levels) {
    const bool above = logger == name || logger.starts_with(name + ".");
    if (!above || name.size() < nearest) continue;
    nearest = name.size();
    level = one;
  }
  return level;
}

Expected<Arguments> parse_arguments(const std::vector<std::string>& words) {
  Arguments out;
  bool for_ros = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--ros-args") {
      for_ros = true;
    } else if (!for_ros) {
      out.remaining.push_back(word);
    } else if (word == "--") {
      for_ros = false;
    } else if (takes_value(word)) {
      if (i + 1 >= words.size()) return bad(word + " needs a value");
      if (auto ok = take_value(word, words[++i], out); !ok) return tl::unexpected(ok.error());
    } else if (word == "--enable-rosout-logs" || word == "--disable-rosout-logs") {
      out.rosout = word[2] == 'e';
    } else if (word == "--enable-stdout-logs" || word == "--disable-stdout-logs") {
      out.console = word[2] == 'e';
    } else if (word == "--enable-external-lib-logs" || word == "--disable-external-lib-logs") {
      // rcl's switch for a log library that is not here
    } else if (word.find(":=") != std::string::npos && word[0] != '-') {
      if (auto ok = take_remap(word, out); !ok)
        return tl::unexpected(ok.error());  // the old form, without -r
    } else {
      return bad("unknown argument '" + word.substr(0, 200) +
                 "'; known: -r, -p, --params-file, --log-level, -e, --disable-rosout-logs, "
                 "--disable-stdout-logs, --");
    }
  }
  return out;
}

}  // namespace goalnet::ros
