#include "ryosen/indexed/indexed.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace ryosen {
namespace {

using List = CompactList<std::int64_t>;

TEST(compact_list, holds_its_values_and_is_one_pointer) {
  static_assert(sizeof(List) == sizeof(void*));
  List list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.size(), 0u);
  EXPECT_EQ(list.begin(), list.end());
  list = {3, -1, 1ll << 60};
  EXPECT_EQ(list, (std::vector<std::int64_t>{3, -1, 1ll << 60}));
  list[1] = 5;
  EXPECT_EQ(list, (List{3, 5, 1ll << 60}));
  EXPECT_FALSE(list == List({3, 5}));
}

TEST(compact_list, copies_are_their_own_and_a_move_leaves_nothing) {
  List list{1, 2};
  List copy = list;
  copy[0] = 9;
  EXPECT_EQ(list, (List{1, 2}));
  const List& same = list;
  list = same;
  EXPECT_EQ(list.size(), 2u);
  const List moved = std::move(list);
  EXPECT_EQ(moved, (List{1, 2}));
  list.clear();  // NOLINT(bugprone-use-after-move): it goes on as an empty one
  EXPECT_EQ(list, List());
  copy = list;
  EXPECT_TRUE(copy.empty());
}

}  // namespace
}  // namespace ryosen
