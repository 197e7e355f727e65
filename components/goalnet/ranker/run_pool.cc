#include "components/goalnet/ranker/run_pool.h"

#include <algorithm>
#include <array>

#include "components/goalnet/ranker/count_common.h"
#include "components/goalnet/ranker/edit_distance.h"

namespace goalnet::inference {
namespace {

// As the published evaluation spells actions: "keep in" counts as "keep on". The sixteen verbs that are left
// need four bits, symbols fourteen.
std::uint32_t spelled(const SymAction& action) {
  static_assert(kVerbs == 18 && kMaxSymbols == 1u << 14);
  const auto verb = static_cast<std::uint32_t>(action.verb), keep = static_cast<std::uint32_t>(Verb::kKeepOn);
  const std::uint32_t kind = verb <= keep ? verb : std::max(verb - 2, keep);
  return kind << 28 | static_cast<std::uint32_t>(action.x) << 14 | action.y;
}

float edit_agreement(const std::vector<SymAction>& left, const std::vector<SymAction>& right) {
  constexpr std::size_t kLongest = 128;
  if (left.empty() || right.empty()) return 0;
  std::array<std::uint32_t, kLongest> a, b;
  const std::size_t n = std::min(left.size(), kLongest), m = std::min(right.size(), kLongest);
  for (std::size_t i = 0; i < n; ++i) a[i] = spelled(left[i]);
  for (std::size_t i = 0; i < m; ++i) b[i] = spelled(right[i]);
  const std::size_t distance = edit_distance({a.data(), n}, {b.data(), m});
  return 1 - static_cast<float>(distance) / static_cast<float>(std::max(n, m));
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
