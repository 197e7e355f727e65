// From keys to numbers, also when there are many: pieces split, nothing is lost, nothing is found twice.
#include "components/planner/hash_index.h"

#include <gtest/gtest.h>

#include "components/planner/symbols.h"

namespace goalnet::planner {
namespace {

// Hashes that differ in their last bits only all belong to one piece, which then cannot be split.
std::uint64_t spread(std::int32_t key) { return static_cast<std::uint64_t>(key) * 0x9E3779B97F4A7C15ULL; }
std::uint64_t alike(std::int32_t key) { return static_cast<std::uint64_t>(key); }

void fill_and_find(std::uint64_t (*hash)(std::int32_t), std::int32_t count) {
  HashIndex index;
  std::vector<std::int32_t> keys;
  const auto add = [&](std::int32_t key) {
    const auto next = static_cast<std::int32_t>(keys.size());
    const std::int32_t number = index.find_or_add(
        hash(key), next, [&](std::int32_t other) { return keys[static_cast<std::size_t>(other)] == key; },
        [&](std::int32_t other) { return hash(keys[static_cast<std::size_t>(other)]); });
    if (number == next) keys.push_back(key);
    return number;
  };
  for (int round = 0; round < 2; ++round) {  // the second after clear()
    keys.clear();
    index.clear();
    for (std::int32_t key = 0; key < count; ++key) ASSERT_EQ(add(3 * key), key);
    for (std::int32_t key = 0; key < count; ++key) ASSERT_EQ(add(3 * key), key) << "known";
    for (std::int32_t key = 0; key < 3 * count; ++key) {
      const std::int32_t found = index.find(
          hash(key), [&](std::int32_t other) { return keys[static_cast<std::size_t>(other)] == key; });
      ASSERT_EQ(found, key % 3 == 0 ? key / 3 : HashIndex::kNone) << key;
    }
  }
}

TEST(HashIndex, FindsWhatWasAddedAndNothingElse) { fill_and_find(spread, 300'000); }
TEST(HashIndex, BearsHashesThatAreAlike) { fill_and_find(alike, 50'000); }

TEST(SymbolTable, ManyNames) {
  SymbolTable table;
  for (std::int32_t i = 0; i < 200'000; ++i) ASSERT_EQ(table.add("name_" + std::to_string(i)), i);
  for (std::int32_t i = 0; i < 200'000; i += 7) ASSERT_EQ(table.find("NAME_" + std::to_string(i)), i);
  EXPECT_EQ(table.find("name_200000"), SymbolTable::kNone);
  table.clear();
  EXPECT_EQ(table.find("name_7"), SymbolTable::kNone);
  EXPECT_EQ(table.add("other"), 0);
}

}  // namespace
}  // namespace goalnet::planner
