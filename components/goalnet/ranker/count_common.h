// How much two sorted lists have in common.
#pragma once

#include <cstddef>
#include <vector>

namespace goalnet::inference {

template <class Value>
std::size_t count_common(const std::vector<Value>& a, const std::vector<Value>& b) {
  std::size_t count = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i < *j) {
      ++i;
    } else if (*j < *i) {
      ++j;
    } else {
      ++count, ++i, ++j;
    }
  }
  return count;
}

}  // namespace goalnet::inference
