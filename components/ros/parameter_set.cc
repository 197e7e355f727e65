#include "components/ros/parameter_set.h"

#include <fmt/format.h>

#include <algorithm>

namespace goalnet::ros {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

// "1 .. 1000", "refuse or queue", "a file"; empty: anything of the type.
std::string allowed(const ParameterSet::Row& row) {
  std::string text;
  if (const auto& range = row.descriptor.range) text = fmt::format("{:g} .. {:g}", range->from, range->to);
  if (!row.descriptor.additional_constraints.empty())
    text += (text.empty() ? "" : "; ") + row.descriptor.additional_constraints;
  return text;
}

}  // namespace

std::string_view to_string(Settable settable) {
  switch (settable) {
    case Settable::kAtStart:
      return "at start";
    case Settable::kUnconfigured:
      return "unconfigured";
    case Settable::kAnyTime:
      return "any time";
  }
  return "";
}

ParameterSet::Row& ParameterSet::add(std::string name, ParameterValue default_value, std::string description,
                                     std::optional<ParameterRange> range, std::string constraints,
                                     std::function<void(const ParameterValue&)> assign) {
  Row row;
  row.name = std::move(name);
  row.default_value = std::move(default_value);
  row.descriptor.description = std::move(description);
  row.descriptor.range = range;
  row.descriptor.additional_constraints = std::move(constraints);
  row.assign = std::move(assign);
  rows_.push_back(std::move(row));
  return rows_.back();
}

ParameterSet::Row& ParameterSet::number(std::string name, double& value, std::string description, double from,
                                        double to) {
  return add(std::move(name), value, std::move(description), ParameterRange{from, to, 0.0}, "",
             [&value](const ParameterValue& v) { value = std::get<double>(v); });
}

ParameterSet::Row& ParameterSet::flag(std::string name, bool& value, std::string description) {
  return add(std::move(name), value, std::move(description), std::nullopt, "",
             [&value](const ParameterValue& v) { value = std::get<bool>(v); });
}

ParameterSet::Row& ParameterSet::text(std::string name, std::string& value, std::string description,
                                      std::string constraints) {
  return add(std::move(name), value, std::move(description), std::nullopt, std::move(constraints),
             [&value](const ParameterValue& v) { value = std::get<std::string>(v); });
}

ParameterSet::Row& ParameterSet::texts(std::string name, std::vector<std::string>& value,
                                       std::string description) {
  return add(std::move(name), value, std::move(description), std::nullopt, "",
             [&value](const ParameterValue& v) { value = std::get<std::vector<std::string>>(v); });
}

ParameterSet::Row& ParameterSet::choice(std::string name, std::string& value, std::string description,
                                        std::vector<std::string> choices) {
  Row& row = text(std::move(name), value, std::move(description), joined(choices));
  row.check = [choices = std::move(choices)](const ParameterValue& v) -> Expected<void> {
    const auto& word = std::get<std::string>(v);
    if (std::find(choices.begin(), choices.end(), word) != choices.end()) return {};
    return fail(Outcome::kInvalidRequest,
                fmt::format("\"{}\" is not {}", word.substr(0, 60), joined(choices)));
  };
  return row;
}

const ParameterSet::Row* ParameterSet::find(std::string_view name) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [name](const Row& row) { return row.name == name; });
  return found == rows_.end() ? nullptr : &*found;
}

void ParameterSet::read(const Parameters& parameters) const {
  for (const Row& row : rows_) {
    if (const ParameterValue* value = parameters.find(row.name)) row.assign(*value);
  }
}

std::string to_text(const ParameterSet& set) {
  std::string text;
  for (const auto& row : set.rows()) {
    text += fmt::format("  {} ({}, default {})\n      {}", row.name, type_name(row.default_value),
                        to_string(row.default_value), row.descriptor.description);
    if (const std::string what = allowed(row); !what.empty()) text += "; " + what;
    text += fmt::format("; set: {}\n", to_string(row.settable));
  }
  return text;
}

std::string to_markdown(const ParameterSet& set) {
  std::string text = "| parameter | type | default | allowed | set | meaning |\n|---|---|---|---|---|---|\n";
  for (const auto& row : set.rows()) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.name, type_name(row.default_value),
                        to_string(row.default_value), allowed(row), to_string(row.settable),
                        row.descriptor.description);
  }
  return text;
}

}  // namespace goalnet::ros
