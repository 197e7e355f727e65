#include "components/goalnet/network/grammar.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "components/goalnet/network/index.h"

namespace goalnet::inference::network {
namespace {

constexpr std::array<std::string_view, kRelations> kNames = {"Near", "Grasping", "On", "In", "state"};
constexpr std::size_t kMaxValues = 4096;  // bounds a hostile file

int position(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

}  // namespace

std::string_view to_string(GoalRelation relation) { return kNames[at(static_cast<int>(relation))]; }

int relation_id(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  return found == kNames.end() ? -1 : static_cast<int>(found - kNames.begin());
}

const std::string& main_argument(const Predicate& predicate) {
  const bool robot_first = predicate.relation == "Near" || predicate.relation == "Grasping";
  return robot_first ? predicate.object : predicate.subject;
}

Predicate make_predicate(GoalRelation relation, const std::string& main, const std::string& second) {
  const bool robot_first = relation == GoalRelation::kNear || relation == GoalRelation::kGrasping;
  if (robot_first) return {std::string(to_string(relation)), "Robot", main};
  return {std::string(to_string(relation)), main, second};
}

Grammar::Grammar(std::vector<std::string> values, std::size_t classes)
    : values_(std::move(values)), value_(classes, std::vector<std::uint8_t>(values_.size())) {
  for (auto* table : {&main_, &second_}) {
    for (auto& row : *table) row.resize(classes);
  }
}

void Grammar::allow(GoalRelation relation, int main_class) {
  if (main_class >= 0) main_[at(static_cast<int>(relation))][at(main_class)] = 1;
}

void Grammar::allow_second(GoalRelation relation, int second_class) {
  if (second_class >= 0) second_[at(static_cast<int>(relation))][at(second_class)] = 1;
}

void Grammar::allow_value(int main_class, int value) {
  if (main_class >= 0 && value >= 0) value_[at(main_class)][at(value)] = 1;
}

bool Grammar::main_allowed(GoalRelation relation, int main_class, bool graspable) const {
  if (main_class >= 0) return main_[at(static_cast<int>(relation))][at(main_class)] != 0;
  return relation == GoalRelation::kNear || (relation != GoalRelation::kState && graspable);
}

bool Grammar::second_allowed(GoalRelation relation, int second_class) const {
  return second_class >= 0 && second_[at(static_cast<int>(relation))][at(second_class)] != 0;
}

bool Grammar::value_allowed(int main_class, int value) const {
  return main_class >= 0 && value_[at(main_class)][at(value)] != 0;
}

int Grammar::value(std::string_view name) const { return position(values_, name); }

std::string Grammar::to_json(const std::vector<std::string>& classes) const {
  nlohmann::json json = {{"values", values_},
                         {"main", nlohmann::json::object()},
                         {"second", nlohmann::json::object()},
                         {"value", nlohmann::json::object()}};
  for (int r = 0; r < kRelations; ++r) {
    const std::string name(kNames[at(r)]);
    json["main"][name] = json["second"][name] = nlohmann::json::array();
    for (std::size_t c = 0; c < classes.size(); ++c) {
      if (main_[at(r)][c]) json["main"][name].push_back(classes[c]);
      if (second_[at(r)][c]) json["second"][name].push_back(classes[c]);
    }
  }
  for (std::size_t c = 0; c < classes.size(); ++c) {
    for (std::size_t v = 0; v < values_.size(); ++v) {
      if (value_[c][v]) json["value"][classes[c]].push_back(values_[v]);
    }
  }
  return json.dump();
}

Expected<Grammar> Grammar::parse(const std::string& text, const std::vector<std::string>& classes) {
  const auto refuse = [](const std::string& why) {
    return fail(Outcome::kInvalidRequest, "the model's grammar " + why);
  };
  try {
    const auto json = nlohmann::json::parse(text);
    auto values = json.at("values").get<std::vector<std::string>>();
    if (values.empty() || values.size() > kMaxValues) return refuse("has no usable list of values");
    Grammar grammar(std::move(values), classes.size());
    for (const char* table : {"main", "second"}) {
      for (const auto& [relation, names] : json.at(table).items()) {
        const int r = relation_id(relation);
        if (r < 0) return refuse("names the unknown relation \"" + relation.substr(0, 40) + "\"");
        for (const auto& name : names) {
          const int c = position(classes, name.get<std::string>());
          if (c < 0) return refuse("names a class that the lexicon lacks");
          const auto relation_value = static_cast<GoalRelation>(r);
          std::string_view(table) == "main" ? grammar.allow(relation_value, c)
                                            : grammar.allow_second(relation_value, c);
        }
      }
    }
    for (const auto& [name, allowed] : json.at("value").items()) {
      const int c = position(classes, name);
      if (c < 0) return refuse("names a class that the lexicon lacks");
      for (const auto& value : allowed) {
        const int v = grammar.value(value.get<std::string>());
        if (v < 0) return refuse("names a value that it does not list");
        grammar.allow_value(c, v);
      }
    }
    return grammar;
  } catch (const nlohmann::json::exception& error) {
    return refuse(std::string("cannot be read: ") + error.what());
  }
}

}  // namespace goalnet::inference::network
