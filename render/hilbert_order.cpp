#include "render/hilbert_order.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <utility>
#include <vector>

#include "ryosen/base/parallel.h"

namespace ryosen {
namespace {

constexpr std::uint32_t bits_per_axis = 10;

constexpr float last_cell = float((1u << bits_per_axis) - 1);

// So many points at once, so that the compiler can do the same to several.
constexpr std::uint32_t block = 64;
using Row = std::array<std::uint32_t, block>;

// Spreads the ten lowest bits so that each is followed by two zero bits.
constexpr std::uint32_t spread(std::uint32_t value) {
  value = (value | (value << 16)) & 0x030000ffu;
  value = (value | (value << 8)) & 0x0300f00fu;
  value = (value | (value << 4)) & 0x030c30c3u;
  return (value | (value << 2)) & 0x09249249u;
}

// One step of the curve at a level, without branches: where the bit of the axis is set, the first axis is turned round
// below it, elsewhere the two are exchanged there.
inline void turn(std::uint32_t& first, std::uint32_t& axis, unsigned level) {
  const std::uint32_t below = (1u << level) - 1, is_set = 0u - ((axis >> level) & 1u);
  const std::uint32_t exchanged = (first ^ axis) & below & ~is_set;
  axis ^= exchanged;
  first ^= exchanged | (below & is_set);
}

// The indices of cells on the Hilbert curve, from the coarsest level down [Skilling04]. Unlike a Z-order curve it has
// no jumps, so every run has a small bounding box.
Row places_on_curve(Row& x, Row& y, Row& z) {
  for (unsigned level = bits_per_axis - 1; level > 0; --level) {
    for (std::uint32_t i = 0; i < block; ++i) {
      std::uint32_t first = x[i];
      first ^= ((1u << level) - 1) & (0u - ((first >> level) & 1u));
      turn(first, y[i], level);
      turn(first, z[i], level);
      x[i] = first;
    }
  }
  Row places;
  for (std::uint32_t i = 0; i < block; ++i) {
    const std::uint32_t a = x[i], b = a ^ y[i], c = b ^ z[i];
    std::uint32_t turned = c >> 1;  // becomes, bit by bit, whether an odd number of the bits above it in c are set
    turned ^= turned >> 1;
    turned ^= turned >> 2;
    turned ^= turned >> 4;
    turned ^= turned >> 8;
    places[i] = (spread(a ^ turned) << 2) | (spread(b ^ turned) << 1) | spread(c ^ turned);
  }
  return places;
}

std::uint32_t cell(float place, float low, float scale) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(glm::clamp((place - low) * scale, 0.0f, last_cell)));
}

struct Keyed {
  std::uint32_t key;
  std::uint32_t number;
};

constexpr std::uint32_t digit_bits = 10, digits = 1u << digit_bits;

// One stable pass of a radix sort by the digit of the key at `shift`: put(place, item); each thread counts and moves a
// part of its own.
template <class Put>
void sort_by_digit(const UnwrittenVector<Keyed>& from, std::uint32_t shift, unsigned threads, const Put& put) {
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
    for (std::uint32_t i = begin; i < end; ++i) put(place[t][digit_of(from[i])]++, from[i]);
  });
}

UnwrittenVector<Keyed> keyed_points(std::uint32_t count, const DrawBox& box, const ReadPoints& read) {
  const glm::vec3 size = box.max - box.min;
  const float largest = glm::max(size.x, glm::max(size.y, size.z)), scale = largest > 0 ? last_cell / largest : 0;
  UnwrittenVector<Keyed> items(count);
  for_each_part((count + block - 1) / block, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    std::array<glm::vec3, block> points{};
    Row x, y, z;
    for (std::uint32_t first = begin * block; first < std::min(count, end * block); first += block) {
      const std::uint32_t here = std::min(block, count - first);
      read(first, std::span(points).first(here));
      for (std::uint32_t i = 0; i < block; ++i) {
        x[i] = cell(points[i].x, box.min.x, scale);
        y[i] = cell(points[i].y, box.min.y, scale);
        z[i] = cell(points[i].z, box.min.z, scale);
      }
      const Row places = places_on_curve(x, y, z);
      for (std::uint32_t i = 0; i < here; ++i) items[first + i] = {places[i], first + i};
    }
  });
  return items;
}

}  // namespace

UnwrittenVector<std::uint32_t> hilbert_order(std::uint32_t count, const DrawBox& box, const ReadPoints& read) {
  static_assert(3 * bits_per_axis == 3 * digit_bits, "three passes sort by all of the key");
  const unsigned threads = threads_for(count);
  UnwrittenVector<Keyed> items = keyed_points(count, box, read);
  {
    UnwrittenVector<Keyed> other(count);
    sort_by_digit(items, 0, threads, [&](std::uint32_t place, const Keyed& item) { other[place] = item; });
    sort_by_digit(other, digit_bits, threads, [&](std::uint32_t place, const Keyed& item) { items[place] = item; });
  }
  UnwrittenVector<std::uint32_t> order(count);
  sort_by_digit(items, 2 * digit_bits, threads,
                [&](std::uint32_t place, const Keyed& item) { order[place] = item.number; });
  return order;
}

}  // namespace ryosen
