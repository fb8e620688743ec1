#include "tests/bench/generated_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace ryosen::bench {

namespace {

std::vector<std::uint32_t> random_order(std::size_t count, std::uint32_t seed) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937_64 random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

}  // namespace

IndexedMesh torus(std::uint32_t rows, std::uint32_t columns) {
  IndexedMesh mesh;
  mesh.positions.reserve(std::size_t{rows} * columns);
  mesh.corners.reserve(std::size_t{6} * rows * columns);
  mesh.face_offsets.reserve(std::size_t{2} * rows * columns + 1);
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return (i % rows) * columns + j % columns; };
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double u = 2 * std::numbers::pi * i / rows, v = 2 * std::numbers::pi * j / columns;
      const double r = 2 + std::cos(v);
      mesh.positions.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const std::uint32_t a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
      for (std::uint32_t corner : {a, b, c, a, c, d}) mesh.corners.push_back(corner);
      for (int face = 0; face < 2; ++face) mesh.face_offsets.push_back(mesh.face_offsets.back() + 3);
    }
  }
  return mesh;
}

IndexedMesh shuffled(IndexedMesh mesh) {
  const std::vector<std::uint32_t> points = random_order(mesh.positions.size(), 1),
                                   faces = random_order(mesh.face_count(), 2);
  IndexedMesh result;
  result.positions.resize(mesh.positions.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.positions[points[i]] = mesh.positions[i];
  for (std::uint32_t f : faces) {
    for (std::uint32_t corner : mesh.face(f)) result.corners.push_back(points[corner]);
    result.face_offsets.push_back(static_cast<std::uint32_t>(result.corners.size()));
  }
  return result;
}

}  // namespace ryosen::bench
