// No face of a landscape comes to stand in a wall where its boundary, or points that are locked, lie in a line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "ryosen/analysis/measure/distance.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/triangle_corners.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

// The least height of the unit normals, of all faces or of those with two corners or more on a boundary.
double least_rise(const Mesh& mesh, const glm::dvec3& up = {0, 0, 1}, bool at_rims = false) {
  double least = 1;
  for (Face f(0); f.index < mesh.face_slots(); ++f.index) {
    if (!mesh.is_alive(f)) continue;
    int at_rim = 0;
    for (const Halfedge h : loop(mesh, mesh.halfedge(f))) at_rim += mesh.is_boundary(mesh.from(h)) ? 1 : 0;
    if (at_rim < 2 && at_rims) continue;
    least = std::min(least, glm::dot(up, glm::normalize(area_normal(corners_of(mesh, mesh.halfedge(f))))));
  }
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

// A landscape; `hole` leaves out squares inside it, `noise` moves each point by so much.
struct TileShape {
  std::uint32_t columns, rows;
  double noise = 0;
  bool hole = false;
};

Mesh tile(std::uint64_t seed, const TileShape& shape) {
  Dice dice(seed);
  const std::uint32_t columns = shape.columns, rows = shape.rows;
  const double height = 0.1 + 0.2 * dice.unit();
  const auto noise = [&] { return shape.noise * (2 * dice.unit() - 1); };
  IndexedMesh source;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x)
      source.positions.emplace_back(x + noise(), y + noise(),
                                    height * (std::sin(1.3 * x + double(seed)) + std::cos(1.1 * y)) + noise());
  const auto is_in_hole = [&](std::uint32_t x, std::uint32_t y) {
    return shape.hole && 3 * x >= columns && 3 * x < 2 * columns && 3 * y >= rows && 3 * y < 2 * rows;
  };
  for (std::uint32_t y = 0; y + 1 < rows; ++y)
    for (std::uint32_t x = 0; x + 1 < columns; ++x) {
      if (is_in_hole(x, y)) continue;
      const std::uint32_t a = y * columns + x, c = a + columns;
      const std::vector<std::uint32_t> corners =
          dice.one_in(3) ? std::vector{a, a + 1, c, a + 1, c + 1, c} : std::vector{a, a + 1, c + 1, a, c + 1, c};
      source.corners.insert(source.corners.end(), corners.begin(), corners.end());
      for (const std::size_t end : {source.corners.size() - 3, source.corners.size()})
        source.face_offsets.push_back(static_cast<std::uint32_t>(end));
    }
  return from_indexed(std::move(source));
}

void expect_no_standing_faces(const Mesh& mesh, const glm::dvec3& up = {0, 0, 1}) {
  ASSERT_GT(least_rise(mesh, up), 0.4);
  for (const std::string boundary : {"locked", "weighted", "free"})
    for (const std::string ratio : {"0.7", "0.5", "0.3", "0.1"}) {
      const Mesh made = simplified(mesh, "ratio=" + ratio + " boundary=" + boundary);
      EXPECT_LT(made.live().faces, mesh.live().faces);
      EXPECT_GT(least_rise(made, up), 0) << boundary << " " << ratio;
      EXPECT_GT(least_rise(made, up, true), 0.2) << boundary << " " << ratio << ": " << made.live().faces << " faces";
    }
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
  const Mesh turned =
      moved(mesh, [&](const glm::dvec3& p) { return glm::dvec3(p.x, c * p.y - s * p.z, s * p.y + c * p.z); });
  EXPECT_GT(least_rise(simplified(turned, "ratio=0.7 boundary=locked"), {0, -s, c}), 0.2);
  const Mesh mirrored = moved(mesh, [](const glm::dvec3& p) { return glm::dvec3(p.y, p.x, p.z); });
  EXPECT_GT(least_rise(simplified(mirrored, "ratio=0.7 boundary=locked"), {0, 0, -1}), 0.2);
  for (const double size : {1e6, 1e-6}) {
    const Mesh scaled = moved(mesh, [&](const glm::dvec3& p) { return size * p; });
    EXPECT_GT(least_rise(simplified(scaled, "ratio=0.7 boundary=locked")), 0.2) << size;
  }
  EXPECT_GT(least_rise(simplified(mesh, "ratio=0.1 boundary=locked")), 0.2);
}

TEST(StandingFaces, none_of_other_tiles) {
  expect_no_standing_faces(report_mesh("locked_tile12.off"));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const auto side = [&](std::uint64_t other) { return static_cast<std::uint32_t>(3 + (seed * other) % 5); };
    expect_no_standing_faces(tile(seed, {side(1), side(3)}));
    expect_no_standing_faces(tile(seed, {side(2), side(1), 0.1}));
    expect_no_standing_faces(tile(seed, {10 + side(1), 9 + side(2), 0, true}));
    expect_no_standing_faces(tile(seed, {8 + side(2), 8 + side(3), 0.1, true}));
    const double c = std::cos(0.1 * double(seed)), s = std::sin(0.1 * double(seed));
    expect_no_standing_faces(
        moved(tile(seed, {10, 12}),
              [&](const glm::dvec3& p) { return glm::dvec3(p.x, c * p.y - s * p.z, s * p.y + c * p.z); }),
        {0, -s, c});
  }
}

// A face at a rim that hardly looks along its corners is not to turn against them: on this mesh that cost half as much
// again.
TEST(StandingFaces, rims_stay_as_near_as_other_faces) {
  const Mesh bunny = asset_mesh("stanford_bunny.obj"), made = simplified(bunny, "ratio=0.1");
  Progress unheard;
  const auto distance = surface_distance(made, bunny, {.gap = 0.05, .samples = 2000}, unheard);
  EXPECT_LT(distance->hausdorff, 0.00065);
}

}  // namespace
}  // namespace ryosen::test
