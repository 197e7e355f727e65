// Candidate runs for one instruction, and how well they agree with each other.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

// A whole run under the benchmark's rules.
struct CandidateRun {
  std::vector<SymAction> macros;   // as chosen
  std::vector<SymAction> actions;  // with their means; those that change nothing left out
  SymState end;
  SymDelta change;            // from the start to `end`
  float log_probability = 0;  // of the policy, per run
  float weight = 0;           // how much it counts as "what a person might do": the sum of the shares
  float sampled = 0, replayed = 0, read = 0;  // shares of the sources
  int source = 0;  // 0 greedy, 1 sampled, 2 a neighbour's replay, 3 the grammar's reading
};

// Applies macros one after the other (those that are not possible are left out).
CandidateRun play(const SymState& start, std::span<const SymAction> macros);
// Goes on with a run that began at `start`.
void play_on(CandidateRun& run, const SymState& start, std::span<const SymAction> macros);

// How `run` would score if `truth` were the demonstration.
struct Agreement {
  float sji = 0, f1 = 0, ied = 0, grr = 0;
  float mean() const { return (sji + f1 + ied + grr) / 4; }
};
Agreement agreement(const CandidateRun& run, const CandidateRun& truth);
// {agreement(a, b), agreement(b, a)} for little more than one of them.
std::pair<Agreement, Agreement> mutual_agreement(const CandidateRun& a, const CandidateRun& b);

}  // namespace goalnet::inference
