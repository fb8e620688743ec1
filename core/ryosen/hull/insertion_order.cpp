#include "ryosen/hull/insertion_order.h"

#include <array>
#include <numeric>
#include <random>
#include <utility>

#include "ryosen/base/enum_table.h"
#include "ryosen/base/rows.h"

namespace ryosen {

namespace {

constexpr std::array orders{
    HullOrderRow{HullOrder::as_given, "as_given"},
    HullOrderRow{HullOrder::random, "random"},
    HullOrderRow{HullOrder::farthest, "farthest"},
};
static_assert(rows_are_in_order(orders, &HullOrderRow::order));

}  // namespace

std::span<const HullOrderRow> hull_orders() { return orders; }

const HullOrderRow* find_hull_order(std::string_view id) { return find_row(orders, id); }

std::vector<std::uint32_t> shuffled_numbers(std::uint32_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::mt19937_64 random(seed);
  for (std::uint32_t i = count; i > 1; --i) {
    // The upper half of a product instead of a remainder: a number below i, all equally likely but for 2^-32 of them.
    const auto j = static_cast<std::uint32_t>(((random() >> 32u) * i) >> 32u);
    std::swap(numbers[i - 1], numbers[j]);
  }
  return numbers;
}

}  // namespace ryosen
