// What the commands share: slips in the arguments, errors and JSON are told the same way by all of them.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "components/core/outcome.h"

namespace goalnet::tools {

// One JSON object on standard output. Bytes that are not UTF-8, from a file name or an argument, are
// replaced: a result is never lost to them. `indent` as nlohmann has it; -1: one line.
void print_json(const nlohmann::ordered_json& object, int indent = -1);

// "goalnet plan: a.pddl: cannot be opened" on standard error; with `as_json` also {"outcome", "message"} on
// standard output. Returns the exit code.
int tell(std::string_view command, const Error& error, bool as_json);

// Reads the arguments into `app`, which is called "goalnet NAME". An exit code if nothing is left to do: 0
// after --help, 13 after a slip, which was told; as JSON too if "--json" is among the arguments.
std::optional<int> parse_or_tell(CLI::App& app, int argc, char** argv);

}  // namespace goalnet::tools
