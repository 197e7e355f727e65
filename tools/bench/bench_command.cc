#include "tools/bench/bench_command.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>

#include "components/core/outcome.h"
#include "tools/bench/bench_table.h"
#include "tools/goalnet/command_line.h"

namespace goalnet::tools {
namespace {

std::string list_of_benchmarks() {
  std::string text = "benchmarks:\n";
  for (const Benchmark& benchmark : benchmarks()) {
    text += std::string("  ") + benchmark.name +
            std::string(std::max<int>(1, 12 - static_cast<int>(std::string(benchmark.name).size())), ' ') +
            benchmark.summary + "\n";
  }
  return text;
}

// Nested objects as "a.b.c  value" lines.
void print_plain(const nlohmann::json& value, const std::string& path) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) print_plain(inner, path.empty() ? key : path + "." + key);
    return;
  }
  std::cout << "  " << path << std::string(path.size() < 44 ? 44 - path.size() : 1, ' ') << value.dump()
            << "\n";
}

}  // namespace

int bench_command(int argc, char** argv) {
  CLI::App app{"Measures how fast the parts are on this machine, and prints what was measured."};
  app.name("goalnet bench");
  app.footer(list_of_benchmarks());
  std::vector<std::string> names;
  BenchOptions options;
  bool as_json = false;
  app.add_option("name", names, "Which ones; all if none is named");
  app.add_flag("--json", as_json, "One JSON object on standard output and nothing else");
  app.add_flag("--quick", options.quick, "Fewer repetitions");
  app.add_option("--seed", options.seed, "For whatever is random")->capture_default_str();
  app.add_option("--data", options.data, "Folder of demonstrations [../shared/data/goalnet]");
  if (const auto code = parse_or_tell(app, argc, argv)) return *code;
  const auto all = benchmarks();
  for (const std::string& name : names) {
    if (std::none_of(all.begin(), all.end(), [&name](const Benchmark& b) { return name == b.name; })) {
      return tell(app.get_name(),
                  {Outcome::kInvalidRequest,
                   "there is no benchmark \"" + name.substr(0, 60) + "\"\n" + list_of_benchmarks()},
                  as_json);
    }
  }
  if (options.data.empty()) {
    const std::filesystem::path beside = std::filesystem::path(GOALNET_SOURCE_DIR) / "../shared/data/goalnet";
    std::error_code ignored;
    if (std::filesystem::exists(beside, ignored)) options.data = beside.lexically_normal().string();
  }
  nlohmann::json results = nlohmann::json::object();
  int code = 0;
  for (const Benchmark& benchmark : all) {
    if (!names.empty() && std::find(names.begin(), names.end(), benchmark.name) == names.end()) continue;
    std::cerr << "measuring " << benchmark.name << " …\n";
    try {
      results[benchmark.name] = benchmark.run(options);
    } catch (const std::exception& error) {
      results[benchmark.name] = {{"error", error.what()}};
      std::cerr << "goalnet bench " << benchmark.name << ": " << error.what() << "\n";
      code = static_cast<int>(Outcome::kInternal);
    }
    if (!as_json) {
      std::cout << benchmark.name << "\n";
      print_plain(results[benchmark.name], "");
    }
  }
  if (as_json) print_json(results, 2);
  return code;
}

}  // namespace goalnet::tools
