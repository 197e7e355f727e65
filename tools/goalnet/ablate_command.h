#pragma once

namespace goalnet::tools {

// goalnet ablate DIR [--folds-run N] [--epochs N] [--only NAME …] [--out docs] [--report-only]: trains and
// scores the paper's model, its baseline, ablations and explorations, and writes OUT/benchmark.md with
// pictures. Results are kept in OUT/benchmark/results.json; what stands there already is not trained again.
// Returns the exit code (outcome.h).
int ablate_command(int argc, char** argv);

}  // namespace goalnet::tools
