// The report of `goalnet ablate`: complete, repeatable, and silent about what was not measured.
#include "tools/goalnet/ablate_report.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "tools/goalnet/ablate_variants.h"
#include "tools/goalnet/svg_chart.h"

namespace goalnet::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

nlohmann::json run(const char* variant, int fold, double sji) {
  const nlohmann::json scores = {{"sji", sji}, {"ied", 0.2}, {"f1", 0.3}, {"grr", 0.4}};
  return {{"variant", variant},
          {"fold", fold},
          {"seconds", 10},
          {"cpu_seconds", 9},
          {"given", scores},
          {"none", scores},
          {"curve", {{3.0, 0.1, 4.0, 0.2}, {2.0, 0.2, 3.0, 0.3}}},
          {"sizes", {{1, 0.5, 0.5, 1}, {1, 0.5, 0.5, 1}, {1, 0.2, 0.2, 0}}}};
}

TEST(AblateReport, HoldsMeansSpreadAndThePapersNumbers) {
  const auto folder = std::filesystem::temp_directory_path() / ("ablate_test_" + std::to_string(::getpid()));
  const nlohmann::json results = {
      {"about",
       {{"demonstrations", 3},
        {"fingerprint", "abc"},
        {"folds", 5},
        {"folds_run", 2},
        {"epochs", 2},
        {"seed", 1}}},
      {"runs", {run("goalnet", 0, 0.4), run("goalnet", 1, 0.5), run("no_relations", 0, 0.3)}}};
  ASSERT_TRUE(write_ablate_report(results, folder));
  const std::string text = read(folder / "benchmark.md"), curve = read(folder / "benchmark" / "learning.svg");
  EXPECT_THAT(text, HasSubstr("| GoalNet | 0.450 ± 0.071 | 0.200"));
  EXPECT_THAT(text, HasSubstr("0.562 | 0.601 | 0.651 | 0.468"));
  EXPECT_THAT(text, HasSubstr("without relational information | 0.300 |"));
  EXPECT_THAT(text, Not(HasSubstr("grammar")));  // not measured, not shown
  EXPECT_THAT(text, Not(HasSubstr("planner in the loop costs")));
  EXPECT_THAT(curve, HasSubstr("no_relations"));
  ASSERT_TRUE(write_ablate_report(results, folder));
  EXPECT_EQ(read(folder / "benchmark.md"), text);
  EXPECT_EQ(read(folder / "benchmark" / "learning.svg"), curve);
  std::filesystem::remove_all(folder);
}

TEST(AblateVariants, EightAblationsAndFourExplorationsWithNamesOfTheirOwn) {
  std::map<Variant::Group, int> count;
  std::set<std::string_view> names;
  for (const Variant& variant : variants()) {
    ++count[variant.group];
    names.insert(variant.name);
  }
  EXPECT_EQ(count[Variant::Group::kAblation], 8);
  EXPECT_EQ(count[Variant::Group::kExploration], 4);
  EXPECT_EQ(names.size(), variants().size());
}

TEST(SvgChart, OddValuesStayInsideThePicture) {
  const Chart chart{"a < b & c", "x", "y", {{"empty", {}, false}, {"far", {{0, 1e9}, {0, -1e9}}, true}},
                    0,           1};
  const std::string svg = to_svg(chart);
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace goalnet::tools
