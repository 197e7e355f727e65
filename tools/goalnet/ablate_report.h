// docs/benchmark.md and its pictures, from the results of `goalnet ablate`.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "components/core/outcome.h"

namespace goalnet::tools {

// `results`: {"about": {...}, "runs": [...]} with runs as ablate_one makes them. Writes folder/benchmark.md
// and folder/benchmark/{goal_size,learning,held_out}.svg.
Expected<void> write_ablate_report(const nlohmann::json& results, const std::filesystem::path& folder);

}  // namespace goalnet::tools
