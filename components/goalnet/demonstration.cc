#include "components/goalnet/demonstration.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace goalnet::inference {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxStates = 1000;
constexpr std::size_t kMaxFacts = 20000;
constexpr std::size_t kMaxFileBytes = 64u << 20;

tl::unexpected<Error> bad(const std::string& name, const std::string& what) {
  return fail(Outcome::kInvalidRequest, name + ": " + what);
}

// The value of `key` if it is an array; a message otherwise.
Expected<const json*> array_at(const json& file, const std::string& name, const char* key) {
  const auto it = file.find(key);
  if (it == file.end()) return bad(name, std::string("the key '") + key + "' is missing");
  if (!it->is_array()) return bad(name, std::string("'") + key + "' should be an array");
  return &*it;
}

Expected<std::vector<Predicate>> read_facts(const json& list, const std::string& name,
                                            const std::string& where) {
  if (!list.is_array()) return bad(name, where + " should be an array of facts");
  if (list.size() > kMaxFacts)
    return bad(name, where + " holds more than " + std::to_string(kMaxFacts) + " facts");
  std::vector<Predicate> facts;
  facts.reserve(list.size());
  for (const json& item : list) {
    if (!item.is_string()) return bad(name, where + " should hold texts like \"(On Mug_1 Sink)\"");
    auto fact = parse_predicate(item.get_ref<const std::string&>());
    if (!fact) return bad(name, where + ": " + fact.error().message);
    facts.push_back(std::move(*fact));
  }
  return facts;
}

std::string without_parentheses(std::string text) {
  std::erase_if(text, [](char c) { return c == '(' || c == ')'; });
  return text;
}

Expected<Grounding> read_grounding(const json& file, const std::string& name) {
  Grounding grounding;
  const auto it = file.find("arg_mapping");
  if (it == file.end() || it->is_null()) return grounding;
  if (!it->is_object()) return bad(name, "'arg_mapping' should be an object: word -> objects");
  for (const auto& [word, objects] : it->items()) {
    if (!objects.is_array()) return bad(name, "'arg_mapping." + word + "' should be an array of names");
    std::vector<std::string>& names = grounding[word];
    for (const json& object : objects) {
      if (!object.is_string()) return bad(name, "'arg_mapping." + word + "' should hold names");
      names.push_back(without_parentheses(object.get<std::string>()));
    }
  }
  return grounding;
}

std::vector<std::string> objects_of(const FactSet& facts) {
  std::set<std::string> names;
  for (const Predicate& fact : facts) {
    names.insert(fact.subject);
    if (!fact.object.empty() && fact.relation != "state") names.insert(fact.object);
  }
  return {names.begin(), names.end()};
}

Expected<Demonstration> from_json(const json& file, const std::string& name) {
  if (!file.is_object()) return bad(name, "should be one JSON object");
  Demonstration demonstration;
  demonstration.id = std::filesystem::path(name).stem().string();
  const std::size_t bar = demonstration.id.find('_');
  demonstration.scenario = demonstration.id.substr(0, bar);
  demonstration.perturbed = demonstration.scenario == "a";
  if (demonstration.perturbed) {
    const auto scenario = file.find("filename");
    if (scenario != file.end() && scenario->is_string())
      demonstration.scenario = scenario->get<std::string>();
  }
  const auto sentence = file.find("sent");
  if (sentence == file.end() || !sentence->is_string())
    return bad(name, "the key 'sent' (a text) is missing");
  demonstration.sentence = sentence->get<std::string>();

  auto grounding = read_grounding(file, name);
  if (!grounding) return tl::unexpected(grounding.error());
  demonstration.grounding = std::move(*grounding);

  const auto states = array_at(file, name, "initial_states");
  if (!states) return tl::unexpected(states.error());
  if ((*states)->empty()) return bad(name, "'initial_states' is empty; at least the start state is needed");
  if ((*states)->size() > kMaxStates)
    return bad(name, "'initial_states' holds more than " + std::to_string(kMaxStates));
  for (const json& state : **states) {
    auto facts =
        read_facts(state, name, "'initial_states[" + std::to_string(demonstration.states.size()) + "]'");
    if (!facts) return tl::unexpected(facts.error());
    WorldState world;
    world.facts = FactSet(std::move(*facts));
    world.objects = objects_of(world.facts);
    demonstration.states.push_back(std::move(world));
  }
  for (std::size_t i = 0; i + 1 < demonstration.states.size(); ++i) {
    const FactSet &before = demonstration.states[i].facts, &after = demonstration.states[i + 1].facts;
    demonstration.steps.push_back(
        Goal{difference(after, before).values(), difference(before, after).values(), 1.0});
  }

  const auto actions = array_at(file, name, "action_seq");
  if (!actions) return tl::unexpected(actions.error());
  for (const json& action : **actions) {
    if (!action.is_string()) return bad(name, "'action_seq' should hold texts like \"moveto Kettle\"");
    if (action.get_ref<const std::string&>() != "noop")
      demonstration.actions.push_back(action.get<std::string>());
  }
  if (demonstration.actions.size() + 1 != demonstration.states.size())
    return bad(name, "has " + std::to_string(demonstration.states.size()) + " states for " +
                         std::to_string(demonstration.actions.size()) +
                         " actions; one more state than actions is needed");
  return demonstration;
}

}  // namespace

Expected<Demonstration> parse_demonstration(std::string_view text, const std::string& name) {
  try {
    return from_json(json::parse(text), name);
  } catch (const json::exception& error) {
    return bad(name, std::string("is not readable JSON: ") + error.what());
  }
}

Expected<Demonstration> read_demonstration(const std::filesystem::path& path) {
  std::error_code code;
  const auto size = std::filesystem::file_size(path, code);
  if (code) return bad(path.string(), "cannot be read: " + code.message());
  if (size > kMaxFileBytes) return bad(path.string(), "is larger than 64 MiB; this is no demonstration");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return bad(path.string(), "cannot be read");
  return parse_demonstration(text.str(), path.string());
}

Expected<std::vector<Demonstration>> read_demonstrations(const std::filesystem::path& folder) {
  std::error_code code;
  std::vector<std::filesystem::path> paths;
  for (auto it = std::filesystem::directory_iterator(folder, code);
       !code && it != std::filesystem::directory_iterator(); it.increment(code))
    if (it->path().extension() == ".json") paths.push_back(it->path());
  if (code) return bad(folder.string(), "cannot be read: " + code.message());
  if (paths.empty()) return bad(folder.string(), "holds no demonstrations (*.json)");
  std::sort(paths.begin(), paths.end());
  std::vector<Demonstration> demonstrations;
  for (const auto& path : paths) {
    auto demonstration = read_demonstration(path);
    if (!demonstration) return tl::unexpected(demonstration.error());
    demonstrations.push_back(std::move(*demonstration));
  }
  return demonstrations;
}

std::uint64_t fingerprint(const std::vector<Demonstration>& demonstrations) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  const auto add = [&](std::string_view text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    hash = (hash ^ 0xffu) * 0x100000001b3ull;  // a byte that is in no text: "ab","c" differs from "a","bc"
  };
  for (const Demonstration& demonstration : demonstrations) {
    add(demonstration.id);
    add(demonstration.sentence);
    for (const auto& [word, objects] : demonstration.grounding) {
      add(word);
      for (const std::string& object : objects) add(object);
    }
    for (const WorldState& state : demonstration.states)
      for (const Predicate& fact : state.facts) add(to_string(fact));
    for (const std::string& action : demonstration.actions) add(action);
  }
  return hash;
}

}  // namespace goalnet::inference
