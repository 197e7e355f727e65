#pragma once

namespace goalnet::tools {

// goalnet bench [NAME…] [--json] [--quick] [--seed N] [--data DIR]: runs the named benchmarks, or all.
int bench_command(int argc, char** argv);

}  // namespace goalnet::tools
