#include "ryosen/base/enum_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace ryosen {
namespace {

enum class Colour : std::uint8_t { red, green2, blue };
enum class NoRow {};
struct Row {
  Colour colour;
  int value;
};

constexpr Row complete[] = {{Colour::red, 1}, {Colour::green2, 2}, {Colour::blue, 3}};
constexpr std::array<Row, 2> without_the_last{{{Colour::red, 1}, {Colour::green2, 2}}};
constexpr std::array<Row, 2> without_the_first{{{Colour::green2, 2}, {Colour::blue, 3}}};
constexpr Row turned[] = {{Colour::red, 1}, {Colour::blue, 3}, {Colour::green2, 2}};
constexpr Row twice[] = {{Colour::red, 1}, {Colour::green2, 2}, {Colour::blue, 3}, {Colour::blue, 4}};

static_assert(rows_are_in_order(complete, &Row::colour));

TEST(enum_table, counts_the_values_that_have_a_name) {
  EXPECT_EQ(enum_count<Colour>, 3u);
  EXPECT_EQ(enum_count<NoRow>, 0u);
}

TEST(enum_table, finds_rows_that_are_missing_turned_or_too_many) {
  constexpr bool last = rows_are_in_order(without_the_last, &Row::colour);
  constexpr bool first = rows_are_in_order(without_the_first, &Row::colour);
  constexpr bool order = rows_are_in_order(turned, &Row::colour), more = rows_are_in_order(twice, &Row::colour);
  EXPECT_FALSE(last);
  EXPECT_FALSE(first);
  EXPECT_FALSE(order);
  EXPECT_FALSE(more);
}

}  // namespace
}  // namespace ryosen
