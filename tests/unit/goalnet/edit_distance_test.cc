#include "components/goalnet/ranker/edit_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "components/goalnet/random.h"

namespace goalnet::inference {
namespace {

using List = std::vector<std::uint32_t>;

// By its definition.
std::size_t defined(const List& a, const List& b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j)
      table[i][j] = i == 0   ? j
                    : j == 0 ? i
                             : std::min({table[i - 1][j] + 1, table[i][j - 1] + 1,
                                         table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
  return table[a.size()][b.size()];
}

TEST(EditDistance, CountsWhatIsLeftOutInsertedAndExchanged) {
  EXPECT_EQ(edit_distance(List{}, List{}), 0u);
  EXPECT_EQ(edit_distance(List{1, 2, 3}, List{}), 3u);
  EXPECT_EQ(edit_distance(List{1, 2, 3}, List{1, 3}), 1u);
  EXPECT_EQ(edit_distance(List{1, 2, 3}, List{1, 4, 3}), 1u);
  EXPECT_EQ(edit_distance(List{1, 2, 3}, List{2, 3, 1}), 2u);
}

// Around the lengths at which the words are full.
TEST(EditDistance, IsWhatTheTableOfItsDefinitionSays) {
  Random random(5);
  for (const std::size_t longest : {6u, 20u, 33u, 66u, 130u})
    for (int round = 0; round < 200; ++round) {
      List a(random.below(longest + 1)), b(random.below(longest + 1));
      const std::size_t letters = 1 + random.below(12);
      for (List* list : {&a, &b})
        for (std::uint32_t& element : *list) element = static_cast<std::uint32_t>(random.below(letters));
      ASSERT_EQ(edit_distance(a, b), defined(a, b)) << a.size() << " and " << b.size() << " elements";
      ASSERT_EQ(edit_distance(b, a), defined(a, b)) << b.size() << " and " << a.size() << " elements";
    }
}

}  // namespace
}  // namespace goalnet::inference
