// one step of goal inference: the network's encoders and decoder, against libtorch where it is built
#pragma once

#include "tools/bench/bench.h"

namespace goalnet::tools {

// Keys: "core" (encoders, network, decoding; the sentence read anew each time), "core_same_sentence", "model"
// (infer() with its strings), each a summary in us; with libtorch also "libtorch" (the forward pass for the
// same step, strings and history not charged) and "times_faster" (libtorch's median over core's).
nlohmann::json bench_infer(const BenchOptions& options);

}  // namespace goalnet::tools
