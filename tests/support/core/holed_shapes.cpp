#include "tests/support/core/holed_shapes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

namespace {

using UnitCube = std::array<int, 3>;

void add_triangle(IndexedMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  for (const std::uint32_t corner : {a, b, c}) mesh.corners.push_back(corner);
  mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

void add_two_triangles(IndexedMesh& mesh, const std::array<std::uint32_t, 4>& corners) {
  add_triangle(mesh, corners[0], corners[1], corners[2]);
  add_triangle(mesh, corners[0], corners[2], corners[3]);
}

// The surface of unit cubes, each side of which two of them share within.
IndexedMesh outside_of(const std::set<UnitCube>& cells) {
  IndexedMesh mesh;
  std::map<UnitCube, std::uint32_t> numbers;
  const auto number_of = [&](const UnitCube& at) {
    const auto [entry, is_new] = numbers.try_emplace(at, static_cast<std::uint32_t>(numbers.size()));
    if (is_new) mesh.positions.emplace_back(at[0], at[1], at[2]);
    return entry->second;
  };
  for (const UnitCube& cell : cells)
    for (unsigned axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        UnitCube beyond = cell;
        beyond[axis] += side ? 1 : -1;
        if (cells.contains(beyond)) continue;
        const unsigned u = (axis + (side ? 1 : 2)) % 3, v = (axis + (side ? 2 : 1)) % 3;
        std::array<std::uint32_t, 4> corners{};
        for (unsigned i = 0; i < 4; ++i) {
          UnitCube at = cell;
          at[axis] += side;
          at[u] += i == 1 || i == 2 ? 1 : 0;
          at[v] += i >= 2 ? 1 : 0;
          corners[i] = number_of(at);
        }
        add_two_triangles(mesh, corners);
      }
  return mesh;
}

void add_sphere(IndexedMesh& mesh, const glm::dvec3& middle, double radius) {
  constexpr std::uint32_t rows = 8, around = 2 * rows;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const std::uint32_t top = first + (rows - 1) * around, bottom = top + 1;
  for (std::uint32_t i = 1; i < rows; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const double down = std::numbers::pi * i / rows, turn = 2 * std::numbers::pi * j / around;
      const glm::dvec3 out{std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), std::cos(down)};
      mesh.positions.push_back(middle + radius * out);
    }
  mesh.positions.push_back(middle + glm::dvec3{0, 0, radius});
  mesh.positions.push_back(middle - glm::dvec3{0, 0, radius});
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return first + i * around + j % around; };
  for (std::uint32_t j = 0; j < around; ++j) {
    add_triangle(mesh, top, at(0, j), at(0, j + 1));
    for (std::uint32_t i = 0; i + 2 < rows; ++i)
      add_two_triangles(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    add_triangle(mesh, bottom, at(rows - 2, j + 1), at(rows - 2, j));
  }
}

}  // namespace

IndexedMesh torus_at_places(std::uint32_t around, std::uint32_t across, double radius, double tube) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      const double out = radius + tube * std::cos(b);
      mesh.positions.emplace_back(out * std::cos(a), out * std::sin(a), tube * std::sin(b));
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % around) * across + j % across; };
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j)
      add_two_triangles(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

IndexedMesh plate_with_holes(std::uint32_t holes) {
  std::set<UnitCube> cells;
  const int count = static_cast<int>(holes);
  for (int x = 0; x < 4 * count + 2; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 2; ++z)
        if (x % 4 < 2 || y < 2 || y > 3) cells.insert({x, y, z});
  return outside_of(cells);
}

IndexedMesh rows_of_spheres(std::uint32_t count, double apart) {
  IndexedMesh mesh;
  for (std::uint32_t k = 0; k < count; ++k) add_sphere(mesh, {apart * (k % 10), apart * (k / 10), 0}, 1);
  return mesh;
}

IndexedMesh scattered_spheres(std::uint32_t count, std::uint64_t seed) {
  Dice dice(seed);
  IndexedMesh mesh;
  for (std::uint32_t k = 0; k < count; ++k) {
    const glm::dvec3 middle = 12.0 * glm::dvec3(dice.unit(), dice.unit(), dice.unit());
    add_sphere(mesh, middle, 0.4 + 0.2 * dice.below(5));
  }
  return mesh;
}

IndexedMesh torn_torus(std::uint32_t missing, std::uint64_t seed) {
  Dice dice(seed);
  IndexedMesh mesh = torus_at_places(20, 10, 2, 0.5);
  for (std::uint32_t i = 0; i < missing; ++i) {
    const auto first = mesh.corners.begin() + 3 * dice.below(static_cast<int>(mesh.corners.size() / 3));
    mesh.corners.erase(first, first + 3);
    mesh.face_offsets.pop_back();
  }
  return mesh;
}

IndexedMesh checkered_sheet(std::uint32_t side) {
  IndexedMesh mesh;
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) mesh.positions.emplace_back(x, y, 0);
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return y * (side + 1) + x; };
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      add_triangle(mesh, at(x, y), at(x + 1, y), at(x + 1, y + 1));
      add_triangle(mesh, at(x, y), at(x, y + 1), at(x + 1, y + 1));
    }
  return mesh;
}

}  // namespace ryosen::test
