#include "render/hilbert_order.h"

#include <array>
#include <glm/common.hpp>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
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

constexpr std::uint32_t digit_bits = 10, digits = 1u << digit_bits;

// One stable pass of a radix sort by the digit of the key at `shift`; each thread counts and moves a part of its own.
void sort_by_digit(const UnwrittenVector<Keyed>& from, std::uint32_t shift, unsigned threads,
                   UnwrittenVector<Keyed>& to) {
  const auto count = static_cast<std::uint32_t>(from.size());
  const auto digit_of = [shift](const Keyed& item) { return (item.key >> shift) & (digits - 1); };
  std::vector<std::array<std::uint32_t, digits>> place(threads);
  for_each_part(count, threads, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    place[t].fill(0);
    for (std::uint32_t i = begin; i < end; ++i) ++place[t][digit_of(from[i])];
  });
  std::uint32_t sum = 0;
  for (std::uint32_t d = 0; d < digits; ++d)
    for (auto& of_part : place) sum += std::exchange(of_part[d], sum);
  for_each_part(count, threads, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) to[place[t][digit_of(from[i])]++] = from[i];
  });
}

}  // namespace

UnwrittenVector<std::uint32_t> hilbert_order(std::uint32_t count,
                                             const std::function<glm::vec3(std::uint32_t)>& point) {
  const unsigned threads = threads_for(count);
  std::vector<DrawBox> boxes(threads);
  for_each_part(count, threads, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    DrawBox box;
    for (std::uint32_t i = begin; i < end; ++i) box.add(point(i));
    boxes[t] = box;
  });
  DrawBox box;
  for (const DrawBox& of_part : boxes) box.add(of_part);
  constexpr float cells = float((1u << bits_per_axis) - 1);
  const glm::vec3 size = box.max - box.min;
  const float largest = glm::max(size.x, glm::max(size.y, size.z));
  const float scale = largest > 0 ? cells / largest : 0;
  UnwrittenVector<Keyed> items(count), other(count);
  for_each_part(count, threads, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i)
      items[i] = {place_on_curve(glm::uvec3((point(i) - box.min) * scale)), i};
  });
  for (std::uint32_t shift = 0; shift < 3 * bits_per_axis; shift += digit_bits) {
    sort_by_digit(items, shift, threads, other);
    items.swap(other);
  }
  UnwrittenVector<std::uint32_t> order(count);
  for (std::uint32_t i = 0; i < count; ++i) order[i] = items[i].number;
  return order;
}

}  // namespace ryosen
