#include "components/goalnet/ranker/run_pool.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "components/goalnet/ranker/count_common.h"

namespace goalnet::inference {
namespace {

// As the published evaluation spells actions: "keep in" counts as "keep on".
bool same(const SymAction& a, const SymAction& b) {
  const auto kind = [](Verb verb) {
    return verb == Verb::kKeepIn || verb == Verb::kKeepNear ? Verb::kKeepOn : verb;
  };
  return kind(a.verb) == kind(b.verb) && a.x == b.x && a.y == b.y;
}

float edit_agreement(const std::vector<SymAction>& left, const std::vector<SymAction>& right) {
  constexpr std::size_t kLongest = 128;
  if (left.empty() || right.empty()) return 0;
  const std::size_t n = std::min(left.size(), kLongest), m = std::min(right.size(), kLongest);
  std::array<std::uint16_t, kLongest + 1> row;
  std::iota(row.begin(), row.begin() + static_cast<long>(m) + 1, std::uint16_t{0});
  for (std::size_t i = 1; i <= n; ++i) {
    std::uint16_t diagonal = row[0];
    row[0] = static_cast<std::uint16_t>(i);
    for (std::size_t j = 1; j <= m; ++j) {
      const auto swapped = static_cast<std::uint16_t>(diagonal + (same(left[i - 1], right[j - 1]) ? 0 : 1));
      diagonal = row[j];
      row[j] = std::min(
          {static_cast<std::uint16_t>(row[j] + 1), static_cast<std::uint16_t>(row[j - 1] + 1), swapped});
    }
  }
  return 1 - static_cast<float>(row[m]) / static_cast<float>(std::max(n, m));
}

}  // namespace

CandidateRun play(const SymState& start, std::span<const SymAction> macros) {
  CandidateRun run;
  run.end = start;
  play_on(run, start, macros);
  return run;
}

void play_on(CandidateRun& run, const SymState& start, std::span<const SymAction> macros) {
  SymState before;
  for (const SymAction& macro : macros) {
    const auto steps = with_means(macro, run.end);
    if (steps.empty()) continue;
    bool changed = false;
    for (const SymAction& step : steps) {
      before = run.end;
      apply(step, run.end);
      if (run.end == before) continue;
      run.actions.push_back(step);
      changed = true;
    }
    if (changed) run.macros.push_back(macro);
  }
  run.change = delta(start, run.end);
}

std::pair<Agreement, Agreement> mutual_agreement(const CandidateRun& run, const CandidateRun& truth) {
  Agreement result;
  const float hit = static_cast<float>(count_common(run.change.added, truth.change.added) +
                                       count_common(run.change.removed, truth.change.removed));
  const float got = static_cast<float>(run.change.added.size() + run.change.removed.size());
  const float wanted = static_cast<float>(truth.change.added.size() + truth.change.removed.size());
  if (hit > 0) {
    result.sji = hit / (got + wanted - hit);
    result.f1 = 2 * hit / (got + wanted);
  }
  result.grr = hit == wanted ? 1.0f : 0.0f;
  result.ied = edit_agreement(run.actions, truth.actions);
  // All but the share of the wanted that was reached is the same from both sides.
  Agreement reverse = result;
  reverse.grr = hit == got ? 1.0f : 0.0f;
  return {result, reverse};
}

Agreement agreement(const CandidateRun& run, const CandidateRun& truth) {
  return mutual_agreement(run, truth).first;
}

}  // namespace goalnet::inference
