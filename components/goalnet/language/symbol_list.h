// Short lists of objects.
#pragma once

#include <algorithm>
#include <vector>

#include "components/goalnet/symbols.h"

namespace goalnet::inference {

inline bool contains(const std::vector<Symbol>& list, Symbol symbol) {
  return std::find(list.begin(), list.end(), symbol) != list.end();
}

}  // namespace goalnet::inference
