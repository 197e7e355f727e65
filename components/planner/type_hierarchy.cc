#include "components/planner/type_hierarchy.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace goalnet::planner {

std::optional<TypeId> find_ancestors(const std::vector<std::vector<TypeId>>& parents,
                                     std::vector<std::vector<TypeId>>* ancestors) {
  const std::size_t count = parents.size();
  ancestors->assign(count, {});
  // 0 = untouched, 1 = being visited, 2 = done; depth-first without recursion because chains can be long.
  std::vector<std::uint8_t> colour(count, 0);
  for (std::size_t root = 0; root < count; ++root) {
    std::vector<std::pair<std::size_t, std::size_t>> stack;
    if (colour[root] == 0) stack.emplace_back(root, 0);
    while (!stack.empty()) {
      auto& [type, child] = stack.back();
      colour[type] = 1;
      if (child < parents[type].size()) {
        const auto above = static_cast<std::size_t>(parents[type][child++]);
        if (colour[above] == 1) return static_cast<TypeId>(above);
        if (colour[above] == 0) stack.emplace_back(above, 0);
        continue;
      }
      std::vector<TypeId>& mine = (*ancestors)[type];
      mine = {0, static_cast<TypeId>(type)};
      for (const TypeId above : parents[type]) {
        const auto& theirs = (*ancestors)[static_cast<std::size_t>(above)];
        mine.insert(mine.end(), theirs.begin(), theirs.end());
      }
      std::sort(mine.begin(), mine.end());
      mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
      colour[type] = 2;
      stack.pop_back();
    }
  }
  return std::nullopt;
}

}  // namespace goalnet::planner
