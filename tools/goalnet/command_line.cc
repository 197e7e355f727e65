#include "tools/goalnet/command_line.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace goalnet::tools {

void print_json(const nlohmann::ordered_json& object, int indent) {
  std::printf("%s\n",
              object.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
  std::fflush(stdout);
}

int tell(std::string_view command, const Error& error, bool as_json) {
  if (as_json) print_json({{"outcome", to_string(error.outcome)}, {"message", error.message}});
  std::fprintf(stderr, "%.*s: %s\n", static_cast<int>(command.size()), command.data(), error.message.c_str());
  return static_cast<int>(error.outcome);
}

std::optional<int> parse_or_tell(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    const bool as_json =
        std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
    const std::string name = app.get_name();
    return tell(
        name, {Outcome::kInvalidRequest, std::string(error.what()) + "; \"" + name + " --help\" tells more"},
        as_json);
  }
  return std::nullopt;
}

}  // namespace goalnet::tools
