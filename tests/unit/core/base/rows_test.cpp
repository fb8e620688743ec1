#include "ryosen/base/rows.h"

#include <gtest/gtest.h>

#include <array>
#include <list>

namespace ryosen {
namespace {

struct Row {
  std::string_view id;
  int value;
};
constexpr std::array rows{Row{"a", 1}, Row{"b", 2}, Row{"c", 3}};

TEST(rows, are_found_by_their_ids) {
  EXPECT_EQ(find_row(rows, "b"), &rows[1]);
  EXPECT_EQ(find_row(rows, ""), nullptr);
  EXPECT_EQ(find_row(rows, "ab"), nullptr);
  EXPECT_EQ(find_row(std::array<Row, 0>(), "a"), nullptr);
  const std::list<Row> list(rows.begin(), rows.end());
  EXPECT_EQ(find_row(list, "c"), &list.back());
}

TEST(rows, tell_their_ids) {
  EXPECT_EQ(ids_of_rows(rows), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(joined_ids(rows), "a|b|c");
  EXPECT_EQ(joined_ids(rows, ", "), "a, b, c");
  EXPECT_EQ(joined_ids(std::array<Row, 0>()), "");
}

}  // namespace
}  // namespace ryosen
