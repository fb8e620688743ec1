#include "ryosen/hull/random_points.h"

#include <array>
#include <cmath>
#include <random>

#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

constexpr std::array families{
    PointFamilyRow{PointFamily::ball, "ball", "In a ball", "球の中"},
    PointFamilyRow{PointFamily::sphere, "sphere", "On a sphere", "球面上"},
    PointFamilyRow{PointFamily::cube, "cube", "In a cube", "立方体の中"},
    PointFamilyRow{PointFamily::grid, "grid", "A regular grid", "規則的な格子"},
    PointFamilyRow{PointFamily::cospherical, "cospherical", "Exactly on a sphere", "正確に同一球面上"},
    PointFamilyRow{PointFamily::lattice, "lattice", "By chance of a lattice", "格子点からランダム"},
};
static_assert(rows_are_in_order(families, &PointFamilyRow::family));

// Of its own ways from bits to numbers, since those of the standard library differ from one to another.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : bits_(seed) {}
  // Of -1 to 1.
  double number() { return static_cast<double>(static_cast<std::int64_t>(bits_()) >> 11) * 0x1p-52; }
  std::int64_t below(std::int64_t end) {
    return static_cast<std::int64_t>(((bits_() >> 32u) * static_cast<std::uint64_t>(end)) >> 32u);
  }
  glm::dvec3 in_cube() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  glm::dvec3 in_ball() {
    for (;;) {
      const glm::dvec3 p = in_cube();
      if (const double square = p.x * p.x + p.y * p.y + p.z * p.z; square <= 1 && square > 1e-6) return p;
    }
  }

 private:
  std::mt19937_64 bits_;
};

std::int64_t root_of(std::int64_t square) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

// A quaternion of whole numbers whose square length is `norm` turns (norm, 0, 0) to a point of whole coordinates at the
// same distance.
glm::dvec3 on_whole_sphere(Chance& chance, std::int64_t norm) {
  const std::int64_t most = root_of(norm);
  for (;;) {
    const std::int64_t m = chance.below(2 * most + 1) - most, n = chance.below(2 * most + 1) - most;
    const std::int64_t rest = norm - m * m - n * n;
    if (rest < 0) continue;
    const std::int64_t largest = root_of(rest), p = chance.below(2 * largest + 1) - largest;
    std::int64_t q = root_of(rest - p * p);
    if (q * q != rest - p * p) continue;
    if (chance.below(2) == 0) q = -q;
    return {static_cast<double>(m * m + n * n - p * p - q * q), static_cast<double>(2 * (m * q + n * p)),
            static_cast<double>(2 * (n * q - m * p))};
  }
}

// Along each axis of a grid of at least so many points.
std::size_t side_of_grid(std::size_t count) {
  std::size_t side = 1;
  while (side * side * side < count) ++side;
  return side;
}

double line_of_grid(std::size_t i, std::size_t side) {
  return side == 1 ? 0.0 : 2 * static_cast<double>(i) / static_cast<double>(side - 1) - 1;
}

}  // namespace

std::span<const PointFamilyRow> point_families() { return families; }

std::vector<glm::dvec3> random_points(PointFamily family, std::size_t count, std::uint64_t seed) {
  constexpr std::int64_t norm = 255255;  // 3 5 7 11 13 17: there are millions of whole points so far from the origin
  constexpr double unit = 0x1p-18;
  const std::size_t side = side_of_grid(count);
  const auto grid_point = [&](std::size_t i) {
    return glm::dvec3(line_of_grid(i / (side * side), side), line_of_grid(i / side % side, side),
                      line_of_grid(i % side, side));
  };
  Chance chance(seed);
  std::vector<glm::dvec3> points;
  points.reserve(count);
  const auto next_point = [&]() -> glm::dvec3 {
    switch (family) {
      case PointFamily::ball:
        return chance.in_ball();
      case PointFamily::sphere: {
        const glm::dvec3 p = chance.in_ball();
        return p / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
      }
      case PointFamily::cube:
        return chance.in_cube();
      case PointFamily::grid:
        return grid_point(points.size());
      case PointFamily::cospherical:
        return on_whole_sphere(chance, norm) * unit;
      case PointFamily::lattice:
        return grid_point(static_cast<std::size_t>(chance.below(static_cast<std::int64_t>(side * side * side))));
    }
    return {};
  };
  while (points.size() < count) points.push_back(next_point());
  return points;
}

}  // namespace ryosen
