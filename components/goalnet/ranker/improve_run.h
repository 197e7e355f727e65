// A run that agrees with a pool better than any run in it: the steps that most of the pool's runs share
// seldom stand together in one of them.
#pragma once

#include <span>
#include <vector>

#include "components/goalnet/ranker/run_pool.h"

namespace goalnet::inference {

// What an agreement counts when runs are compared, 0..1. IED, where the model is weakest, counts most; GRR
// least, because whatever helps the others raises it too.
float worth(const Agreement& agreement);

// Leaves out, inserts and exchanges steps of `run`, one at a time and each time the one that brings most, as
// long as its expected worth rises; at most a few times. `belief`: of each run of the pool; they sum to 1.
CandidateRun improve(CandidateRun run, const std::vector<CandidateRun>& pool, std::span<const float> belief,
                     const SymState& start);

float expected_sji(const CandidateRun& run, const std::vector<CandidateRun>& pool,
                   std::span<const float> belief);

}  // namespace goalnet::inference
