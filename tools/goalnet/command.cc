#include "tools/goalnet/command.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "components/core/config_path.h"
#include "components/core/outcome.h"

namespace goalnet::tools {
namespace {

constexpr int kUsageError = static_cast<int>(Outcome::kInvalidRequest);

// Single-character edits from one word to the other; commands are short, so the plain table does.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row[b.size()];
}

void print_help(std::span<const Command> commands, std::string_view usage) {
  std::printf("%.*s\ncommands:\n", static_cast<int>(usage.size()), usage.data());
  for (const Command& command : commands) {
    std::printf("  %-10.*s %.*s\n", static_cast<int>(command.name.size()), command.name.data(),
                static_cast<int>(command.summary.size()), command.summary.data());
  }
  std::puts("\n\"goalnet COMMAND --help\" tells more about one.");
  std::puts(
      "\nexit codes: 0 done; 10-19 refused (10 not understood, 11 unknown object, 12 no plan, 13 invalid "
      "request,\n"
      "14 busy); 20-29 limit (20 time, 21 steps, 22 cancelled); 30-39 fault (30 motion failed, 31 world "
      "stale,\n"
      "32 component lost, 33 emergency stop, 39 internal error).");
}

int unknown_command(std::span<const Command> commands, std::string_view name) {
  const auto nearest =
      std::min_element(commands.begin(), commands.end(), [name](const Command& a, const Command& b) {
        return edit_distance(a.name, name.substr(0, 40)) < edit_distance(b.name, name.substr(0, 40));
      });
  std::fprintf(
      stderr, "goalnet: there is no command \"%.*s\"; did you mean \"%.*s\"? \"goalnet --help\" lists all.\n",
      static_cast<int>(std::min<std::size_t>(name.size(), 60)), name.data(),
      static_cast<int>(nearest->name.size()), nearest->name.data());
  return kUsageError;
}

// Output that is lost, on a full disk for example, must not look like success to a script.
int checked(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  std::fprintf(stderr, "goalnet: the output could not be written: %s\n", std::strerror(errno));
  return code == 0 ? static_cast<int>(Outcome::kInternal) : code;
}

}  // namespace

int become(std::string_view program, std::string_view command, int argc, char** argv) {
  const std::string path = program_folder() + "/" + std::string(program);
  std::string goalnet = "goalnet", name(command);
  std::vector<char*> arguments = {goalnet.data(), name.data()};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  arguments.push_back(nullptr);
  execv(path.c_str(), arguments.data());
  std::fprintf(stderr, "goalnet %s: cannot start %s: %s\n", name.c_str(), path.c_str(), std::strerror(errno));
  return static_cast<int>(Outcome::kInternal);
}

int dispatch(std::span<const Command> commands, std::string_view usage, int argc, char** argv) {
  const std::string_view name = argc > 1 ? argv[1] : "";
  if (name == "--help" || name == "-h" || name == "help") {
    print_help(commands, usage);
    return checked(0);
  }
  if (name == "--version") {
    std::puts("goalnet " GOALNET_VERSION);
    return 0;
  }
  if (name.empty()) {
    std::fputs("goalnet: which command? \"goalnet --help\" lists them.\n", stderr);
    return kUsageError;
  }
  const auto command = std::find_if(commands.begin(), commands.end(),
                                    [name](const Command& candidate) { return candidate.name == name; });
  if (command == commands.end()) return unknown_command(commands, name);
  if (command->function == nullptr) return become(command->program, name, argc - 1, argv + 1);
  std::string called = "goalnet " + std::string(name);
  std::vector<char*> arguments(argv + 1, argv + argc);
  arguments[0] = called.data();
  arguments.push_back(nullptr);
  return checked(command->function(argc - 1, arguments.data()));
}

}  // namespace goalnet::tools
