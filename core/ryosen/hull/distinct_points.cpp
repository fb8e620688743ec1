#include "ryosen/hull/distinct_points.h"

#include <algorithm>
#include <array>

#include "ryosen/geometry/box.h"
#include "ryosen/geometry/place_keys.h"

namespace ryosen::hull {

namespace {

constexpr std::uint32_t bits_per_axis = 10, cells_per_axis = 1u << bits_per_axis;

// Each of the lower ten bits followed by two zeros.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | (bits << 16u)) & 0x030000ffu;
  bits = (bits | (bits << 8u)) & 0x0300f00fu;
  bits = (bits | (bits << 4u)) & 0x030c30c3u;
  return (bits | (bits << 2u)) & 0x09249249u;
}

// The cells of a grid over the box of the points, along a curve that keeps near ones together [Morton66].
class CellCurve {
 public:
  CellCurve(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers) {
    Box box;
    for (const std::uint32_t i : numbers) box.add(points[i]);
    low_ = box.lowest;
    // Halves, since a difference of doubles may be beyond the largest one.
    half_extent_ = box.highest / 2.0 - box.lowest / 2.0;
  }

  std::uint32_t cell(const glm::dvec3& p) const {
    std::uint32_t key = 0;
    for (int axis = 0; axis < 3; ++axis) key = (key << 1u) | spread(step(p[axis], axis));
    return key;
  }

 private:
  // Equal coordinates have equal steps.
  std::uint32_t step(double value, int axis) const {
    if (!(half_extent_[axis] > 0)) return 0;
    const double share = (value / 2 - low_[axis] / 2) / half_extent_[axis];
    return std::min(cells_per_axis - 1, static_cast<std::uint32_t>(share * cells_per_axis));
  }

  glm::dvec3 low_{0.0}, half_extent_{0.0};
};

struct Placed {
  std::uint32_t cell, number;
};

// Stable, by cell.
void sort_by_cell(std::vector<Placed>& all) {
  constexpr std::uint32_t digit_bits = 10, digits = 1u << digit_bits;
  std::vector<Placed> sorted(all.size());
  for (std::uint32_t shift = 0; shift < 3 * bits_per_axis; shift += digit_bits) {
    std::array<std::uint32_t, digits + 1> begin{};
    for (const Placed& p : all) ++begin[((p.cell >> shift) & (digits - 1)) + 1];
    for (std::uint32_t d = 0; d < digits; ++d) begin[d + 1] += begin[d];
    for (const Placed& p : all) sorted[begin[(p.cell >> shift) & (digits - 1)]++] = p;
    all.swap(sorted);
  }
}

}  // namespace

DistinctPoints distinct_points(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers) {
  const CellCurve curve(points, numbers);
  std::vector<Placed> all;
  all.reserve(numbers.size());
  for (const std::uint32_t i : numbers) all.push_back({curve.cell(points[i]), i});
  sort_by_cell(all);
  DistinctPoints distinct;
  distinct.places.reserve(all.size());
  distinct.numbers.reserve(all.size());
  const auto keep = [&](std::uint32_t number) {
    distinct.places.push_back(points[number]);
    distinct.numbers.push_back(number);
  };
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    for (end = begin + 1; end < all.size() && all[end].cell == all[begin].cell;) ++end;
    if (end == begin + 1) {
      keep(all[begin].number);
      continue;
    }
    std::sort(all.data() + begin, all.data() + end, [&](const Placed& a, const Placed& b) {
      const glm::dvec3 &p = points[a.number], &q = points[b.number];
      return p == q ? a.number < b.number : is_before(p, q);
    });
    for (std::size_t i = begin; i < end; ++i)
      if (i == begin || points[all[i].number] != points[all[i - 1].number]) keep(all[i].number);
  }
  return distinct;
}

}  // namespace ryosen::hull
