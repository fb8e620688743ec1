#include "render/space_order.h"

#include <array>
#include <glm/common.hpp>

#include "render/screen.h"

namespace ryosen {
namespace {

constexpr std::uint32_t bits_per_axis = 10;

// Moves the ten lowest bits apart so that two free bits follow each.
std::uint32_t spread(std::uint32_t value) {
  value = (value | (value << 16)) & 0x030000ffu;
  value = (value | (value << 8)) & 0x0300f00fu;
  value = (value | (value << 4)) & 0x030c30c3u;
  return (value | (value << 2)) & 0x09249249u;
}

struct Keyed {
  std::uint32_t key;
  std::uint32_t number;
};

}  // namespace

std::vector<std::uint32_t> space_order(std::span<const glm::vec3> points) {
  DrawBox box;
  for (const glm::vec3& p : points) box.add(p);
  constexpr float cells = float((1u << bits_per_axis) - 1);
  const glm::vec3 size = box.max - box.min;
  const float largest = glm::max(size.x, glm::max(size.y, size.z));
  const float scale = largest > 0 ? cells / largest : 0;
  std::vector<Keyed> items(points.size()), other(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const glm::uvec3 cell((points[i] - box.min) * scale);
    items[i] = {spread(cell.x) | (spread(cell.y) << 1) | (spread(cell.z) << 2), i};
  }
  constexpr std::uint32_t digit_bits = 10, digits = 1u << digit_bits;
  for (std::uint32_t shift = 0; shift < 3 * bits_per_axis; shift += digit_bits) {
    std::array<std::uint32_t, digits + 1> start{};
    for (const Keyed& item : items) ++start[((item.key >> shift) & (digits - 1)) + 1];
    for (std::uint32_t d = 0; d < digits; ++d) start[d + 1] += start[d];
    for (const Keyed& item : items) other[start[(item.key >> shift) & (digits - 1)]++] = item;
    items.swap(other);
  }
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].number;
  return order;
}

}  // namespace ryosen
