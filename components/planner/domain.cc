#include "components/planner/domain.h"

#include <algorithm>

namespace goalnet::planner {

bool Domain::has_recursion() const {
  return std::any_of(layer.begin(), layer.end(), [](std::int32_t l) { return l >= 0; });
}

bool Domain::is_a(TypeId type, TypeId ancestor) const {
  if (ancestor == 0 || type == ancestor) return true;
  const auto& above = ancestors[static_cast<std::size_t>(type)];
  return std::binary_search(above.begin(), above.end(), ancestor);
}

bool Domain::is_a(TypeId type, const TypeSet& any_of) const {
  return std::any_of(any_of.begin(), any_of.end(), [&](TypeId ancestor) { return is_a(type, ancestor); });
}

}  // namespace goalnet::planner
