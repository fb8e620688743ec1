#include "ryosen/base/recent_cells.h"

#include <gtest/gtest.h>

#include <vector>

namespace ryosen {
namespace {

std::vector<int> since(const RecentCells<int>& cells, std::uint64_t cursor) {
  std::vector<int> found;
  cells.for_each_since(cursor, [&](int cell) { found.push_back(cell); });
  return found;
}

TEST(recent_cells, each_reader_gets_what_it_has_not_seen) {
  RecentCells<int> cells;
  EXPECT_FALSE(cells.has_all_since(0)) << "who has seen nothing reads everything anew";
  const std::uint64_t first = cells.clock();
  cells.add(1);
  cells.add(2);
  const std::uint64_t second = cells.clock();
  cells.add(3);
  EXPECT_EQ(since(cells, first), (std::vector{1, 2, 3}));
  EXPECT_EQ(since(cells, second), (std::vector{3}));
  EXPECT_EQ(since(cells, cells.clock()), std::vector<int>());
  EXPECT_FALSE(cells.has_all_since(cells.clock() + 1)) << "of another stream";
}

TEST(recent_cells, who_is_behind_what_is_kept_has_missed_something) {
  RecentCells<int> cells;
  const std::uint64_t first = cells.clock();
  for (std::size_t i = 0; i < RecentCells<int>::most_cells; ++i) cells.add(static_cast<int>(i));
  EXPECT_TRUE(cells.has_all_since(first));
  EXPECT_EQ(since(cells, first).size(), RecentCells<int>::most_cells);
  const std::uint64_t later = cells.clock();
  cells.add(-1);
  EXPECT_FALSE(cells.has_all_since(first));
  EXPECT_TRUE(cells.has_all_since(first + 1));
  EXPECT_EQ(since(cells, later), (std::vector{-1}));
}

TEST(recent_cells, forgetting_sends_all_readers_back) {
  RecentCells<int> cells;
  cells.add(1);
  const std::uint64_t before = cells.clock();
  cells.forget();
  EXPECT_FALSE(cells.has_all_since(before));
  const std::uint64_t after = cells.clock();
  EXPECT_TRUE(cells.has_all_since(after));
  cells.forget();
  EXPECT_FALSE(cells.has_all_since(after)) << "also twice without a cell between";
}

}  // namespace
}  // namespace ryosen
