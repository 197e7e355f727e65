#include "components/goalnet/ranker/edit_distance.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace goalnet::inference {
namespace {

using List = std::span<const std::uint32_t>;

// Which of at most 32 elements equal `value`, one bit each. Without a branch, so that it becomes vector
// instructions.
std::uint32_t equal_to(List list, std::uint32_t value) {
  static constexpr auto kBits = [] {
    std::array<std::uint32_t, 32> bits{};
    for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = 1u << i;
    return bits;
  }();
  std::uint32_t found = 0;
  for (std::size_t i = 0; i < list.size(); ++i) found |= list[i] == value ? kBits[i] : 0u;
  return found;
}

// A column of the table of distances in two words: where it rises by one from row to row and where it falls
// (Myers 1999, in Hyyrö's form). `rows`: 1 to 64 elements.
std::size_t by_bits(List rows, List columns) {
  const List low = rows.first(std::min<std::size_t>(rows.size(), 32)), high = rows.subspan(low.size());
  const std::uint64_t last = std::uint64_t{1} << (rows.size() - 1);
  std::uint64_t rises = ~std::uint64_t{0}, falls = 0;
  std::size_t distance = rows.size();
  for (const std::uint32_t value : columns) {
    std::uint64_t equal = equal_to(low, value);
    if (!high.empty()) equal |= static_cast<std::uint64_t>(equal_to(high, value)) << 32;
    const std::uint64_t diagonal = (((equal & rises) + rises) ^ rises) | equal | falls;
    std::uint64_t right_rises = falls | ~(diagonal | rises), right_falls = rises & diagonal;
    distance += (right_rises & last) != 0;
    distance -= (right_falls & last) != 0;
    right_rises = right_rises << 1 | 1;
    right_falls <<= 1;
    rises = right_falls | ~(diagonal | right_rises);
    falls = right_rises & diagonal;
  }
  return distance;
}

std::size_t by_table(List rows, List columns) {
  std::vector<std::size_t> column(rows.size() + 1);
  std::iota(column.begin(), column.end(), std::size_t{0});
  for (const std::uint32_t value : columns) {
    std::size_t diagonal = column[0]++;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t exchanged = diagonal + (rows[i] == value ? 0 : 1);
      diagonal = column[i + 1];
      column[i + 1] = std::min({column[i] + 1, diagonal + 1, exchanged});
    }
  }
  return column.back();
}

}  // namespace

std::size_t edit_distance(List left, List right) {
  // Where both begin or end alike nothing is edited.
  const auto [a, b] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
  left = {a, left.end()}, right = {b, right.end()};
  while (!left.empty() && !right.empty() && left.back() == right.back())
    left = left.first(left.size() - 1), right = right.first(right.size() - 1);
  if (left.size() > right.size()) std::swap(left, right);
  if (left.empty()) return right.size();
  return left.size() <= 64 ? by_bits(left, right) : by_table(left, right);
}

}  // namespace goalnet::inference
