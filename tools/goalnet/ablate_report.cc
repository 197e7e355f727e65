#include "tools/goalnet/ablate_report.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

#include "tools/goalnet/ablate_variants.h"
#include "tools/goalnet/svg_chart.h"

namespace goalnet::tools {
namespace {

using Json = nlohmann::json;
constexpr std::array<const char*, 4> kScores = {"sji", "ied", "f1", "grr"};

std::string fixed(double value, int digits = 3) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::vector<const Json*> runs_of(const Json& results, std::string_view variant) {
  std::vector<const Json*> runs;
  for (const Json& run : results.at("runs")) {
    if (run.at("variant") == variant) runs.push_back(&run);
  }
  return runs;
}

// Mean and, with several folds, the spread between them.
std::string mean_of(const std::vector<const Json*>& runs, const char* setting, const char* score) {
  double sum = 0, squares = 0;
  for (const Json* run : runs) {
    const double value = run->at(setting).at(score);
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(runs.size()), mean = sum / n;
  std::string text = fixed(mean);
  if (runs.size() > 1) text += " ± " + fixed(std::sqrt(std::max(0.0, (squares - sum * mean) / (n - 1))));
  return text;
}

std::string table(const Json& results, Variant::Group group, const char* setting) {
  std::string text;
  for (const Variant& variant : variants()) {
    const auto runs = runs_of(results, variant.name);
    if (variant.group != group || runs.empty()) continue;
    text += "| " + std::string(variant.title);
    for (const char* score : kScores) text += " | " + mean_of(runs, setting, score);
    for (std::size_t i = 0; i < kScores.size(); ++i)
      text += " | " + (variant.paper ? fixed((*variant.paper)[i]) : "");
    text += " |\n";
  }
  return text;
}

std::string tables(const Json& results, const char* setting) {
  std::string text =
      "| | SJI | IED | F1 | GRR | paper: SJI | IED | F1 | GRR |\n|---|---|---|---|---|---|---|---|---|\n";
  text += table(results, Variant::Group::kModel, setting);
  text += "| *parts removed* | | | | | | | | |\n" + table(results, Variant::Group::kAblation, setting);
  text += "| *explorations* | | | | | | | | |\n" + table(results, Variant::Group::kExploration, setting);
  return text + "\n";
}

// Scores of the paper's model by how many facts the person changed.
Chart goal_size_chart(const Json& results) {
  Chart chart{"GoalNet by the size of the goal set (grounding given)",
              "facts changed by the person",
              "mean score",
              {},
              0,
              1};
  constexpr std::array<const char*, 3> kNames = {"SJI", "F1", "GRR"};
  std::map<int, std::vector<const Json*>> by_size;
  for (const Json* run : runs_of(results, "goalnet")) {
    for (const Json& row : run->at("sizes")) by_size[std::min(row.at(0).get<int>(), 12)].push_back(&row);
  }
  for (std::size_t score = 0; score < kNames.size(); ++score) {
    ChartLine line{kNames[score], {}, score == 0};
    for (const auto& [size, rows] : by_size) {
      double sum = 0;
      for (const Json* row : rows) sum += row->at(score + 1).get<double>();
      if (rows.size() >= 3) line.points.emplace_back(size, sum / static_cast<double>(rows.size()));
    }
    chart.lines.push_back(std::move(line));
  }
  return chart;
}

// A column of the curves, averaged over folds, by epoch.
Chart curve_chart(const Json& results, std::size_t column, const std::string& title, double highest) {
  Chart chart{title, "epoch", column % 2 == 0 ? "loss" : "whole goals right", {}, 0, highest};
  for (const Variant& variant : variants()) {
    ChartLine line{std::string(variant.name), {}, variant.name == "goalnet"};
    const auto runs = runs_of(results, variant.name);
    if (runs.empty() || runs[0]->at("curve").empty()) continue;
    for (std::size_t epoch = 0; epoch < runs[0]->at("curve").size(); ++epoch) {
      double sum = 0;
      for (const Json* run : runs) sum += run->at("curve").at(epoch).at(column).get<double>();
      line.points.emplace_back(epoch + 1, sum / static_cast<double>(runs.size()));
    }
    chart.lines.push_back(std::move(line));
  }
  return chart;
}

// Processor time; 0 where it was not measured.
double seconds_of(const Json& results, std::string_view variant) {
  double sum = 0;
  for (const Json* run : runs_of(results, variant)) sum += run->value("cpu_seconds", 0.0);
  return sum;
}

}  // namespace

Expected<void> write_ablate_report(const Json& results, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder / "benchmark", error);
  const Json& about = results.at("about");
  std::string text =
      "# The GoalNet benchmark\n\nWritten by `goalnet ablate`; do not edit. " +
      about.at("demonstrations").dump() + " demonstrations (data fingerprint " +
      about.at("fingerprint").get<std::string>() + "), scenarios held out: " + about.at("folds_run").dump() +
      " of " + about.at("folds").dump() + " folds, " + about.at("epochs").dump() + " epochs, seed " +
      about.at("seed").dump() +
      ". The paper's numbers are on its own test set, which shares its scenarios' style but not our folds: "
      "compare "
      "differences between rows rather than rows across.\n\n## Grounding given\n\n" +
      tables(results, "given") + "## No grounding (sentence and state only)\n\n" + tables(results, "none");
  const double plain = seconds_of(results, "goalnet"), planned = seconds_of(results, "planner");
  if (plain > 0 && planned > 0) {
    text += "## What the planner in the loop costs\n\nTraining took " + fixed(plain, 1) +
            " s of processor time with SymSim and " + fixed(planned, 1) +
            " s with the planner in the loop: " + fixed(planned / plain, 2) +
            " times as long, in the same run (the paper: 13 times).\n\n";
  }
  text +=
      "## Scores and the size of the goal set\n\n![scores by goal size](benchmark/goal_size.svg)\n\n## "
      "Learning curves\n\n"
      "![training loss](benchmark/learning.svg)\n\n![held-out loss](benchmark/held_out.svg)\n\n"
      "![held-out goals right](benchmark/held_out_right.svg)\n";
  const std::pair<std::string, std::string> files[] = {
      {"benchmark.md", text},
      {"benchmark/goal_size.svg", to_svg(goal_size_chart(results))},
      {"benchmark/learning.svg", to_svg(curve_chart(results, 0, "Loss on training steps", 6))},
      {"benchmark/held_out.svg", to_svg(curve_chart(results, 2, "Loss on held-out scenarios", 6))},
      {"benchmark/held_out_right.svg",
       to_svg(curve_chart(results, 3, "Held-out steps with the whole goal right", 0.6))},
  };
  for (const auto& [name, content] : files) {
    std::ofstream file(folder / name, std::ios::binary | std::ios::trunc);
    file << content;
    if (!file.flush()) return fail(Outcome::kInvalidRequest, (folder / name).string() + " cannot be written");
  }
  return {};
}

}  // namespace goalnet::tools
