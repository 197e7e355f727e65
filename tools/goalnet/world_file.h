// A world state as a file: what `goalnet infer` and `goalnet run --start` read, and `goalnet run --json`
// prints.
#pragma once

#include <string>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::tools {

struct WorldFile {
  WorldState world;    // the objects that the facts name are there in any case
  bool whole = false;  // "objects" were given: what the file does not say does not hold
};

// {"objects": ["Mug_1", ...], "facts": ["(On Mug_1 Sink)", ...]}; other keys are left alone, "objects" may be
// absent. Errors: kInvalidRequest, with the file's name.
Expected<WorldFile> read_world(const std::string& path);

}  // namespace goalnet::tools
