#include "ryosen/base/rows.h"

#include <gtest/gtest.h>

#include <array>
#include <list>

namespace ryosen {
namespace {

struct NamedRow {
  std::string_view id;
  int value;
};
constexpr std::array named_rows{NamedRow{"a", 1}, NamedRow{"b", 2}, NamedRow{"c", 3}};

TEST(rows, are_found_by_their_ids) {
  EXPECT_EQ(find_row(named_rows, "b"), &named_rows[1]);
  EXPECT_EQ(find_row(named_rows, ""), nullptr);
  EXPECT_EQ(find_row(named_rows, "ab"), nullptr);
  EXPECT_EQ(find_row(std::array<NamedRow, 0>(), "a"), nullptr);
  const std::list<NamedRow> list(named_rows.begin(), named_rows.end());
  EXPECT_EQ(find_row(list, "c"), &list.back());
}

TEST(rows, tell_their_ids) {
  EXPECT_EQ(ids_of_rows(named_rows), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(joined_ids(named_rows), "a|b|c");
  EXPECT_EQ(joined_ids(named_rows, ", "), "a, b, c");
  EXPECT_EQ(joined_ids(std::array<NamedRow, 0>()), "");
}

}  // namespace
}  // namespace ryosen
