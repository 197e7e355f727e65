#include "tools/goalnet/world_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "components/core/read_file.h"

namespace goalnet::tools {

using nlohmann::json;

Expected<WorldFile> read_world(const std::string& path) {
  const auto bad = [&](const std::string& what) {
    return fail(Outcome::kInvalidRequest, path + ": " + what);
  };
  const auto text = read_file(path, 64 << 20);
  if (!text) return tl::unexpected<Error>(text.error());
  const auto is_list_of_texts = [](const json& list) {
    return list.is_array() &&
           std::all_of(list.begin(), list.end(), [](const json& item) { return item.is_string(); });
  };
  try {
    const json object = json::parse(*text);
    if (!object.is_object() || !object.contains("facts") || !is_list_of_texts(object["facts"]) ||
        !is_list_of_texts(object.value("objects", json::array())))
      return bad("should be {\"objects\": [\"Mug_1\", ...], \"facts\": [\"(On Mug_1 Sink)\", ...]}");
    std::vector<Predicate> facts;
    std::set<std::string> objects;
    for (const json& item : object.at("facts")) {
      auto fact = parse_predicate(item.get<std::string>());
      if (!fact) return bad(fact.error().message);
      objects.insert(fact->subject);
      if (!fact->object.empty() && fact->relation != "state") objects.insert(fact->object);
      facts.push_back(std::move(*fact));
    }
    if (object.contains("objects"))
      for (const json& name : object.at("objects")) objects.insert(name.get<std::string>());
    // A run that was refused names none: it saw no state.
    const bool whole = !object.value("objects", json::array()).empty();
    return WorldFile{{{objects.begin(), objects.end()}, FactSet(std::move(facts))}, whole};
  } catch (const json::exception& error) {
    return bad(error.what());
  }
}

}  // namespace goalnet::tools
