#include "tools/goalnet/scenario_halves.h"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace goalnet::tools {
namespace {

using inference::ModelRun;
using inference::Scores;

struct Half {
  const char* name = "";
  std::size_t runs = 0;
  Scores mean;
};

std::array<Half, 2> halves_of(const std::vector<ModelRun>& runs) {
  std::array<Half, 2> halves;
  halves[0].name = "even", halves[1].name = "odd";
  for (const ModelRun& run : runs) {
    const std::string scenario = run.id.substr(0, run.id.find('_'));
    const char last = scenario.empty() ? '\0' : scenario.back();
    if (last < '0' || last > '9') continue;
    Half& half = halves[static_cast<std::size_t>(last - '0') % 2];
    half.mean += run.scores;
    ++half.runs;
  }
  for (Half& half : halves)
    if (half.runs > 0) half.mean = half.mean / static_cast<double>(half.runs);
  return halves;
}

}  // namespace

void print_halves(const std::vector<ModelRun>& runs) {
  for (const Half& half : halves_of(runs))
    if (half.runs > 0)
      std::printf("  %-4s scenarios, %zu: SJI %.3f  IED %.3f  F1 %.3f  GRR %.3f\n", half.name, half.runs,
                  half.mean.sji, half.mean.ied, half.mean.f1, half.mean.grr);
}

void add_halves(nlohmann::json& object, const std::vector<ModelRun>& runs) {
  for (const Half& half : halves_of(runs))
    if (half.runs > 0)
      object[half.name] = {{"count", half.runs},
                           {"sji", half.mean.sji},
                           {"ied", half.mean.ied},
                           {"f1", half.mean.f1},
                           {"grr", half.mean.grr}};
}

}  // namespace goalnet::tools
