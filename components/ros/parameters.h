// The parameters of one node: declared with type, default and range, overridden by files and the command
// line, read and set while running. No DDS here; parameter_services.h shows them to ROS 2 tools.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/parameter_value.h"

namespace goalnet::ros {

// Numbers from..to, both allowed, in steps from `from`; step 0: any number between.
struct ParameterRange {
  double from = 0;
  double to = 0;
  double step = 0;
};

struct ParameterDescriptor {
  std::string description = {};
  bool read_only = false;  // fixed once the node runs
  std::optional<ParameterRange> range = std::nullopt;
  std::string additional_constraints = {};  // in words
};

struct Parameter {
  std::string name;
  ParameterValue value;
  bool operator==(const Parameter&) const = default;
};

// What changed, for /parameter_events.
struct ParameterChange {
  std::vector<Parameter> added;
  std::vector<Parameter> changed;
};

// One thread: the node's event loop.
class Parameters {
 public:
  // Called before a change; an error refuses it, and its message is the reason shown to whoever asked.
  using Validator = std::function<Expected<void>(const std::vector<Parameter>&)>;
  using Observer = std::function<void(const ParameterChange&)>;

  // Values that declared parameters take instead of their defaults, with where each comes from.
  void set_override(const std::string& name, ParameterValue value, std::string origin);

  // As if there had been none: for a value that declare() refused.
  void forget_override(const std::string& name) { overrides_.erase(name); }

  // Declares and returns the value in force. kInvalidRequest if an override has another type or is out of
  // range, or if the name is declared already.
  Expected<ParameterValue> declare(const std::string& name, const ParameterValue& default_value,
                                   const ParameterDescriptor& descriptor);

  bool has(const std::string& name) const { return entries_.contains(name); }
  const ParameterValue* find(const std::string& name) const;  // nullptr if not declared
  const ParameterDescriptor* descriptor(const std::string& name) const;
  std::vector<std::string> names() const;  // sorted

  // Sets all or none. kInvalidRequest: unknown name, other type, out of range, read-only, refused by a
  // validator.
  Expected<void> set(const std::vector<Parameter>& values);

  void add_validator(Validator validator) { validators_.push_back(std::move(validator)); }
  void add_observer(Observer observer) { observers_.push_back(std::move(observer)); }

  // Overrides that nothing declared: most likely a slip in a file.
  std::vector<std::string> unused_overrides() const;

  // All values as a ROS 2 parameter file.
  std::string dump(const std::string& node_full_name) const;

 private:
  struct Entry {
    ParameterValue value;
    ParameterDescriptor descriptor;
  };
  struct Override {
    ParameterValue value;
    std::string origin;
    bool used = false;
  };
  std::map<std::string, Entry> entries_;
  std::map<std::string, Override> overrides_;
  std::vector<Validator> validators_;
  std::vector<Observer> observers_;
};

// The ParameterValue alternative that holds a C++ type: int64 for integers, double for floats, string for
// texts.
template <class T>
struct ParameterTypeOf {
  using Type = std::conditional_t<
      std::is_same_v<T, bool>, bool,
      std::conditional_t<
          std::is_integral_v<T>, std::int64_t,
          std::conditional_t<std::is_floating_point_v<T>, double,
                             std::conditional_t<std::is_convertible_v<T, std::string>, std::string, T>>>>;
};

}  // namespace goalnet::ros
