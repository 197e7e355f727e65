#pragma once

namespace goalnet::tools {

// goalnet infer STATE.json "INSTRUCTION" [--model FILE] [--steps N] [--json]: the goals that a model infers,
// each step played under the benchmark's rules. STATE.json: {"objects": [names], "facts": ["(On Mug_1 Sink)",
// ...]}. Returns the exit code (outcome.h).
int infer_command(int argc, char** argv);

}  // namespace goalnet::tools
