// In which order points are taken into a hull.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ryosen {

enum class HullOrder : std::uint8_t { as_given, random, farthest };

struct HullOrderRow {
  HullOrder order;
  std::string_view id;
};
// In the order of the enum.
std::span<const HullOrderRow> hull_orders();
const HullOrderRow* find_hull_order(std::string_view id);

// The numbers below `count` by chance: the same for the same seed, on every machine.
std::vector<std::uint32_t> shuffled_numbers(std::uint32_t count, std::uint64_t seed);

}  // namespace ryosen
