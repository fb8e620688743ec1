#include "tests/support/core/shapes.h"

#include <algorithm>
#include <cmath>

#include "ryosen/mesh/circulate.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

IndexedMesh indexed(const Polygons& faces, std::size_t points) {
  IndexedMesh mesh;
  for (const auto& face : faces) {
    for (std::uint32_t corner : face) {
      mesh.corners.push_back(corner);
      points = std::max(points, std::size_t{corner} + 1);
    }
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  for (std::size_t i = 0; i < points; ++i) {
    const double t = static_cast<double>(i);
    mesh.positions.push_back({t, t * t, std::sin(t) * t});
  }
  return mesh;
}

Mesh make_mesh(const Polygons& faces, std::size_t points) { return from_indexed(indexed(faces, points)); }

SeededMesh seeded_mesh(std::uint64_t seed) {
  const RandomMesh random = random_mesh(seed);
  SeededMesh mesh{{}, static_cast<std::size_t>(random.points)};
  for (const auto& face : random.faces) mesh.faces.emplace_back(face.begin(), face.end());
  return mesh;
}

Polygons tetrahedron() { return {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}; }

Polygons cube() { return {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}; }

Polygons torus_grid(std::uint32_t rows, std::uint32_t columns) {
  Polygons faces;
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return (i % rows) * columns + j % columns; };
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return faces;
}

Polygons two_quads() { return {{0, 1, 2, 3}, {1, 0, 4, 5}}; }

Polygons closed_fan(std::uint32_t spokes) {
  Polygons faces;
  for (std::uint32_t i = 0; i < spokes; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % spokes});
  return faces;
}

Polygons bow_tie() { return {{0, 1, 2}, {0, 3, 4}}; }

Polygons fin() { return {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}; }

Polygons moebius_strip() { return {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}; }

Polygons two_tetrahedra_on_an_edge() {
  Polygons faces = tetrahedron();
  for (const std::vector<std::uint32_t>& face : {std::vector<std::uint32_t>{0, 1, 4}, {0, 5, 1}, {1, 5, 4}, {0, 4, 5}})
    faces.push_back(face);
  return faces;
}

Polygons polygons_of(const Mesh& mesh) {
  Polygons faces;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    faces.emplace_back();
    for (Vertex v : vertices_around(mesh, Face(i))) faces.back().push_back(v.index);
  }
  return faces;
}

}  // namespace ryosen::test
