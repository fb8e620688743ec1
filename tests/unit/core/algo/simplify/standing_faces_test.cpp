// No face of a landscape comes to stand in a wall where its boundary, or points that are locked, lie in a line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "core/indexed/from_indexed.h"
#include "core/mesh/triangle_corners.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

// The least height of the unit normals.
double least_rise(const Mesh& mesh, const glm::dvec3& up = {0, 0, 1}) {
  double least = 1;
  for (Face f(0); f.index < mesh.face_slots(); ++f.index)
    if (mesh.is_alive(f))
      least = std::min(least, glm::dot(up, glm::normalize(area_normal(corners_of(mesh, mesh.halfedge(f))))));
  return least;
}

Mesh simplified(Mesh mesh, const std::string& words) {
  Journal journal;
  run_algorithm(mesh, journal, "simplify " + words);
  return mesh;
}

Mesh moved(const Mesh& mesh, const std::function<glm::dvec3(const glm::dvec3&)>& change) {
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p = change(p);
  return Mesh(std::move(columns));
}

Mesh tile(std::uint64_t seed) {
  Dice dice(seed);
  const auto columns = static_cast<std::uint32_t>(3 + dice.below(5)), rows = static_cast<std::uint32_t>(3 + dice.below(5));
  const double height = 0.1 + 0.2 * dice.unit();
  IndexedMesh source;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x)
      source.positions.emplace_back(x, y, height * (std::sin(1.3 * x + double(seed)) + std::cos(1.1 * y)));
  for (std::uint32_t y = 0; y + 1 < rows; ++y)
    for (std::uint32_t x = 0; x + 1 < columns; ++x) {
      const std::uint32_t a = y * columns + x, c = a + columns;
      const std::vector<std::uint32_t> corners = dice.one_in(3) ? std::vector{a, a + 1, c, a + 1, c + 1, c}
                                                                 : std::vector{a, a + 1, c + 1, a, c + 1, c};
      source.corners.insert(source.corners.end(), corners.begin(), corners.end());
      for (const std::size_t end : {source.corners.size() - 3, source.corners.size()})
        source.face_offsets.push_back(static_cast<std::uint32_t>(end));
    }
  return from_indexed(std::move(source));
}

TEST(StandingFaces, none_of_a_locked_tile) {
  const Mesh mesh = report_mesh("locked_tile12.off");
  const Mesh made = simplified(mesh, "ratio=0.7 boundary=locked");
  EXPECT_EQ(made.live().faces, 8u);
  EXPECT_GT(least_rise(made), 0.2);
}

TEST(StandingFaces, none_of_that_tile_turned_mirrored_or_scaled) {
  const Mesh mesh = report_mesh("locked_tile12.off");
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Mesh turned = moved(mesh, [&](const glm::dvec3& p) { return glm::dvec3(p.x, c * p.y - s * p.z, s * p.y + c * p.z); });
  EXPECT_GT(least_rise(simplified(turned, "ratio=0.7 boundary=locked"), {0, -s, c}), 0.2);
  const Mesh mirrored = moved(mesh, [](const glm::dvec3& p) { return glm::dvec3(p.y, p.x, p.z); });
  EXPECT_GT(least_rise(simplified(mirrored, "ratio=0.7 boundary=locked"), {0, 0, -1}), 0.2);
  for (const double size : {1e6, 1e-6}) {
    const Mesh scaled = moved(mesh, [&](const glm::dvec3& p) { return size * p; });
    EXPECT_GT(least_rise(simplified(scaled, "ratio=0.7 boundary=locked")), 0.2) << size;
  }
  EXPECT_GT(least_rise(simplified(mesh, "ratio=0.1 boundary=locked")), 0.2);
}

// Where a boundary is locked, whatever the goal; elsewhere while there is another way to it.
TEST(StandingFaces, none_of_other_tiles) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const char* const goal : {"ratio=0.7 boundary=locked", "ratio=0.3 boundary=locked",
                                   "ratio=0.7 boundary=weighted", "ratio=0.7 boundary=free"}) {
      const Mesh mesh = tile(seed);
      ASSERT_GT(least_rise(mesh), 0.4);
      const Mesh made = simplified(mesh, goal);
      EXPECT_LT(made.live().faces, mesh.live().faces);
      EXPECT_GT(least_rise(made), 0.2) << seed << " " << goal;
    }
}

}  // namespace
}  // namespace ryosen::test
