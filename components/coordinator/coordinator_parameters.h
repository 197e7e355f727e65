// The coordinator's parameters as they are declared; the table is CoordinatorNode::describe.
#pragma once

#include <cstdint>
#include <string>

#include "components/coordinator/params.h"

namespace goalnet::coordinator {

struct DeclaredParams {
  CoordinatorParams core;
  std::string when_busy = "refuse";
  std::string domain = "household";
  std::uint64_t first_id = 0;
};

}  // namespace goalnet::coordinator
