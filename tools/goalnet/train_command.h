#pragma once

namespace goalnet::tools {

// goalnet train DIR -o MODEL [--model KIND] [--seed N] [--fresh] [--set NAME=VALUE …] [--json]: learns a
// model from demonstrations. Goes on from OUT.checkpoint after an interruption. Returns the exit code
// (outcome.h).
int train_command(int argc, char** argv);

}  // namespace goalnet::tools
