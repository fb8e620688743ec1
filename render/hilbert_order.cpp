#include "render/hilbert_order.h"

#include <array>
#include <glm/common.hpp>

#include "render/screen.h"

namespace ryosen {
namespace {

constexpr std::uint32_t bits_per_axis = 10;

// Spreads the ten lowest bits so that each is followed by two zero bits.
std::uint32_t spread(std::uint32_t value) {
  value = (value | (value << 16)) & 0x030000ffu;
  value = (value | (value << 8)) & 0x0300f00fu;
  value = (value | (value << 4)) & 0x030c30c3u;
  return (value | (value << 2)) & 0x09249249u;
}

// The index of a cell on the Hilbert curve, from the coarsest level down [Skilling04]. Unlike a Z-order curve it has no
// jumps, so every run has a small bounding box.
std::uint32_t place_on_curve(glm::uvec3 cell) {
  std::uint32_t axis[3] = {cell.x, cell.y, cell.z};
  for (std::uint32_t level = 1u << (bits_per_axis - 1); level > 1; level >>= 1) {
    const std::uint32_t below = level - 1;
    for (std::uint32_t& a : axis) {
      if (a & level) {
        axis[0] ^= below;
      } else {
        const std::uint32_t exchanged = (axis[0] ^ a) & below;
        axis[0] ^= exchanged;
        a ^= exchanged;
      }
    }
  }
  axis[1] ^= axis[0];
  axis[2] ^= axis[1];
  std::uint32_t turned = 0;
  for (std::uint32_t level = 1u << (bits_per_axis - 1); level > 1; level >>= 1) {
    if (axis[2] & level) turned ^= level - 1;
  }
  return (spread(axis[0] ^ turned) << 2) | (spread(axis[1] ^ turned) << 1) | spread(axis[2] ^ turned);
}

struct Keyed {
  std::uint32_t key;
  std::uint32_t number;
};

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const glm::vec3> points) {
  DrawBox box;
  for (const glm::vec3& p : points) box.add(p);
  constexpr float cells = float((1u << bits_per_axis) - 1);
  const glm::vec3 size = box.max - box.min;
  const float largest = glm::max(size.x, glm::max(size.y, size.z));
  const float scale = largest > 0 ? cells / largest : 0;
  std::vector<Keyed> items(points.size()), other(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    items[i] = {place_on_curve(glm::uvec3((points[i] - box.min) * scale)), i};
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
