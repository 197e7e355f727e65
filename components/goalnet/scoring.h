// The published scores of a run against a demonstration (SJI, IED, F1, GRR) and their cleaner variants.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/predicate.h"

namespace goalnet::inference {

// Each 0..1. With D the facts added and removed from the first to the last state, of the run and of the
// person:
struct Scores {
  double sji = 0;            // |common D| / |union of D|
  double f1 = 0;             // of the run's D against the person's
  double ied = 0;            // 1 - Levenshtein(actions) / longer length, in the published spelling of actions
  double grr = 0;            // 1 when everything the person changed was changed (doing more is free)
  double grr_formula = 0;    // the paper's formula: 1 when nothing else was changed
  double exact = 0;          // both
  double ied_canonical = 0;  // ied without the published evaluation's slip about "keep"

  Scores& operator+=(const Scores& other);
  Scores operator/(double n) const;
};

// Actions are in the demonstrations' spelling; "noop" is left out. Names are compared without case.
Scores score_run(const FactSet& start, const FactSet& demonstrated_end,
                 std::span<const std::string> demonstrated, const FactSet& run_end,
                 std::span<const std::string> run);

// 1 - Levenshtein / longer length; 1 when both are empty, 0 when one is.
double edit_similarity(std::span<const std::string> left, std::span<const std::string> right);

}  // namespace goalnet::inference
