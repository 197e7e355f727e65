// What people type behind --ros-args, one word a line, and the names in it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "components/ros/arguments.h"
#include "components/ros/names.h"
#include "components/ros/parameter_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros;
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::istringstream lines(text);
  std::vector<std::string> words = {"--ros-args"};
  for (std::string line; std::getline(lines, line);) {
    // No files of this machine: a parameter file has its own fuzzer.
    if (line == "--params-file") line = "-p";
    words.push_back(line);
  }
  const auto arguments = parse_arguments(words);
  if (!arguments && arguments.error().message.empty()) std::abort();
  if (arguments) {
    // What nodes and loggers are made of is checked when it is typed.
    for (const char* node : {"planner", "brain"}) {
      const auto name = arguments->node_name(node);
      if (name && !check_node_name(*name)) std::abort();
      const auto space = arguments->node_namespace(name.value_or(node));
      if (space && normalize_namespace(*space).value() != *space) std::abort();
    }
    arguments->level_of("robot_1.planner");
  }
  for (const std::string& word : words) {
    const auto full = expand_name(word, "/robot_1", "planner");
    if (full) {
      // What was accepted is absolute, fits into a DDS topic name and is accepted again as it is.
      if ((*full)[0] != '/' || service_request_to_dds(*full).size() > 256) std::abort();
      const auto again = expand_name(*full, "/", "other");
      if (!again || *again != *full) std::abort();
    }
    const auto space = normalize_namespace(word);
    if (space && normalize_namespace(*space).value() != *space) std::abort();
    matches_node(word, "/robot_1/planner");
    if (!matches_node("/**", word)) std::abort();
    goalnet::ros::parse_parameter_value(word, "word");
  }
  return 0;
}
