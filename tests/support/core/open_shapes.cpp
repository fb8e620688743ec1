#include "tests/support/core/open_shapes.h"

#include <cmath>
#include <numbers>

#include "ryosen/geometry/single_precision.h"

namespace ryosen::test {

namespace {

void add_face(IndexedMesh& list, std::initializer_list<std::uint32_t> corners) {
  list.corners.insert(list.corners.end(), corners);
  list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
}

}  // namespace

IndexedMesh tube(std::uint32_t corners, double radius, double height) {
  IndexedMesh list;
  for (const auto& [r, z] : {std::pair(1.0, 0.0), std::pair(radius, height)})
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * i / corners;
      list.positions.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    add_face(list, {i, next, next + corners, i + corners});
  }
  return list;
}

IndexedMesh cup(std::uint32_t corners, double radius, double height) {
  IndexedMesh list = tube(corners, radius, height);
  for (std::uint32_t i = corners; i > 0; --i) list.corners.push_back(i - 1);
  list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  return list;
}

IndexedMesh sphere_with_hole(std::uint32_t n, std::uint32_t missing_rows,
                             const std::function<double(std::uint32_t)>& rise) {
  IndexedMesh list;
  const std::uint32_t rows = n - missing_rows, around = 2 * n;
  for (std::uint32_t row = 1; row <= rows; ++row)
    for (std::uint32_t k = 0; k < around; ++k) {
      const double polar = M_PI * (row - (row == rows ? rise(k) : 0)) / n, angle = M_PI * k / n;
      list.positions.push_back(
          {std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), -std::cos(polar)});
    }
  const auto pole = static_cast<std::uint32_t>(list.positions.size());
  list.positions.push_back({0, 0, -1});
  for (std::uint32_t k = 0; k < around; ++k) {
    const std::uint32_t next = (k + 1) % around;
    add_face(list, {pole, next, k});
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
      const std::uint32_t low = row * around, high = low + around;
      add_face(list, {low + k, low + next, high + next});
      add_face(list, {low + k, high + next, high + k});
    }
  }
  return list;
}

IndexedMesh turned(IndexedMesh list) {
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.1), t = std::sin(1.1);
  for (glm::dvec3& p : list.positions) {
    p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    p = {p.x, d * p.y - t * p.z, t * p.y + d * p.z};
  }
  return list;
}

IndexedMesh as_floats(IndexedMesh list) {
  for (glm::dvec3& p : list.positions) p = to_single(p);
  return list;
}

IndexedMesh wavy_fan(std::uint32_t spokes) {
  IndexedMesh fan;
  fan.positions.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / spokes;
    fan.positions.emplace_back(std::cos(angle), std::sin(angle), 0.1 * std::sin(7 * angle));
    fan.corners.insert(fan.corners.end(), {0, 1 + i, 1 + (i + 1) % spokes});
    fan.face_offsets.push_back(static_cast<std::uint32_t>(fan.corners.size()));
  }
  return fan;
}

}  // namespace ryosen::test
