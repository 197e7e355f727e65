#pragma once

namespace goalnet::tools {

// goalnet eval DIR [--model FILE] [--grounding given|none] [--runs OUT.jsonl] [--threads N] [--json]: scores
// a model on a folder of demonstrations in the benchmark's loop. Returns the exit code (outcome.h).
int eval_command(int argc, char** argv);

}  // namespace goalnet::tools
