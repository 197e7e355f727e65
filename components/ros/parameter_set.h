// The parameters of a component in one table: declared on its node, read into its struct, checked when set,
// printed for people. One row a parameter, written once.
//
//   void describe(ros::ParameterSet& set, Params& params) {
//     set.number("rate", params.rate, "how often facts are computed at most [Hz]", 1.0, 1000.0);
//     set.text("scene", params.scene, "scene", "a name in config/scenes or a file");
//   }
#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/parameters.h"

namespace goalnet::ros {

// When a parameter may be set from outside.
enum class Settable {
  kAtStart,       // read-only: by -p and files only
  kUnconfigured,  // takes effect with the next configure; refused in other states
  kAnyTime,       // takes effect at once
};
std::string_view to_string(Settable settable);  // "at start", "unconfigured", "any time"

// Rows refer to the members they were given: the struct must outlive the set. One thread.
class ParameterSet {
 public:
  struct Row {
    std::string name;
    ParameterValue default_value;
    ParameterDescriptor descriptor;
    Settable settable = Settable::kUnconfigured;
    std::function<Expected<void>(const ParameterValue&)> check = {};  // beside type and range
    std::function<void(const ParameterValue&)> assign = {};           // to the bound member
  };

  // The value that `value` has now is the default. A row stays valid until the next one is added.
  Row& number(std::string name, double& value, std::string description, double from, double to);
  template <std::integral T>
  requires(!std::same_as<T, bool>) Row& whole(std::string name, T& value, std::string description,
                                              double from, double to) {
    return add(std::move(name), static_cast<std::int64_t>(value), std::move(description),
               ParameterRange{from, to, 1.0}, "",
               [&value](const ParameterValue& v) { value = static_cast<T>(std::get<std::int64_t>(v)); });
  }
  Row& flag(std::string name, bool& value, std::string description);
  Row& text(std::string name, std::string& value, std::string description, std::string constraints = "");
  Row& texts(std::string name, std::vector<std::string>& value, std::string description);
  // A text that must be one of `choices`.
  Row& choice(std::string name, std::string& value, std::string description,
              std::vector<std::string> choices);

  const std::vector<Row>& rows() const { return rows_; }
  const Row* find(std::string_view name) const;

  // Gives the members the values that the node's parameters have now.
  void read(const Parameters& parameters) const;

 private:
  Row& add(std::string name, ParameterValue default_value, std::string description,
           std::optional<ParameterRange> range, std::string constraints,
           std::function<void(const ParameterValue&)> assign);
  std::vector<Row> rows_;
};

// For a terminal: a line or two for each.
std::string to_text(const ParameterSet& set);
// For a README: | parameter | type | default | allowed | set | meaning |.
std::string to_markdown(const ParameterSet& set);

}  // namespace goalnet::ros
