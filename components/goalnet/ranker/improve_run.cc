#include "components/goalnet/ranker/improve_run.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace goalnet::inference {
namespace {

// A run that a person might do, and how far that is believed.
struct Truth {
  const CandidateRun* run;
  float belief;
};

// The most believed first; those that hardly count together are left out.
std::vector<Truth> truths_of(const std::vector<CandidateRun>& pool, std::span<const float> belief) {
  constexpr float kHardly = 0.02f;
  std::vector<Truth> truths;
  for (std::size_t i = 0; i < pool.size(); ++i) truths.push_back({&pool[i], belief[i]});
  std::stable_sort(truths.begin(), truths.end(),
                   [](const Truth& a, const Truth& b) { return a.belief > b.belief; });
  float left_out = 0;
  while (truths.size() > 1 && left_out + truths.back().belief < kHardly) {
    left_out += truths.back().belief;
    truths.pop_back();
  }
  return truths;
}

float expected_worth(const CandidateRun& run, const std::vector<Truth>& truths) {
  float sum = 0;
  for (const Truth& truth : truths) sum += truth.belief * worth(agreement(run, *truth.run));
  return sum;
}

// Steps that enough of the truths hold. Fewer could not make up for what the step costs with all others.
std::vector<SymAction> shared_steps(const std::vector<Truth>& truths) {
  constexpr float kBelieved = 0.25f;
  std::map<SymAction, float> share;
  for (const Truth& truth : truths)
    for (const SymAction& step : std::set<SymAction>(truth.run->macros.begin(), truth.run->macros.end()))
      share[step] += truth.belief;
  std::vector<SymAction> steps;
  for (const auto& [step, believed] : share)
    if (believed >= kBelieved) steps.push_back(step);
  return steps;
}

// Calls `consider(i, rest)` for all lists of steps that differ from these by one: the first i of these, then
// the rest.
template <class Consider>
void vary(const std::vector<SymAction>& macros, const std::vector<SymAction>& steps, Consider consider) {
  std::vector<SymAction> rest;
  const auto from = [&](std::size_t i) { return macros.begin() + static_cast<long>(i); };
  for (std::size_t i = 0; i < macros.size(); ++i) {
    rest.assign(from(i + 1), macros.end());
    consider(i, rest);
  }
  for (const SymAction& step : steps) {
    if (std::find(macros.begin(), macros.end(), step) != macros.end()) continue;
    for (std::size_t i = 0; i <= macros.size(); ++i) {
      rest.assign(from(i), macros.end());
      rest.insert(rest.begin(), step);
      consider(i, rest);
      if (i == macros.size()) continue;
      rest.erase(rest.begin() + 1);
      consider(i, rest);
    }
  }
}

// The run after none of its macros, after the first, ...
std::vector<CandidateRun> beginnings(const std::vector<SymAction>& macros, const SymState& start) {
  std::vector<CandidateRun> runs = {play(start, {})};
  for (const SymAction& macro : macros) {
    CandidateRun next = runs.back();
    play_on(next, start, {&macro, 1});
    runs.push_back(std::move(next));
  }
  return runs;
}

}  // namespace

float worth(const Agreement& one) { return (one.sji + 1.6f * one.ied + one.f1 + 0.5f * one.grr) / 4.1f; }

CandidateRun improve(CandidateRun run, const std::vector<CandidateRun>& pool, std::span<const float> belief,
                     const SymState& start) {
  constexpr int kMostChanges = 4;
  constexpr float kLeastGain = 1e-4f;
  const std::vector<Truth> truths = truths_of(pool, belief);
  const std::vector<SymAction> steps = shared_steps(truths);
  float most = expected_worth(run, truths);
  for (int change = 0; change < kMostChanges; ++change) {
    most += kLeastGain;
    std::optional<CandidateRun> best;
    const auto begun = beginnings(run.macros, start);
    vary(run.macros, steps, [&](std::size_t kept, const std::vector<SymAction>& rest) {
      CandidateRun varied = begun[kept];
      play_on(varied, start, rest);
      if (varied.actions == run.actions) return;
      const float value = expected_worth(varied, truths);
      if (value > most) most = value, best = std::move(varied);
    });
    if (!best) break;
    run = std::move(*best);
  }
  return run;
}

float expected_sji(const CandidateRun& run, const std::vector<CandidateRun>& pool,
                   std::span<const float> belief) {
  float sum = 0;
  for (std::size_t i = 0; i < pool.size(); ++i) sum += belief[i] * agreement(run, pool[i]).sji;
  return sum;
}

}  // namespace goalnet::inference
