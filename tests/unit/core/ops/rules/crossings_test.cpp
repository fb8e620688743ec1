#include "ryosen/ops/rules/crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

std::vector<std::array<glm::dvec3, 3>> triangles_of(const Mesh& mesh, Face f) {
  std::vector<glm::dvec3> corners;
  for (Vertex v : vertices_around(mesh, f)) corners.push_back(mesh.position(v));
  std::vector<CornerTriangle> triangles;
  triangulate(corners, triangles);
  std::vector<std::array<glm::dvec3, 3>> result;
  for (const CornerTriangle& t : triangles) result.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  return result;
}

bool cross(const Mesh& mesh, Face f, Face g) {
  for (const auto& s : triangles_of(mesh, f))
    for (const auto& t : triangles_of(mesh, g))
      if (triangles_cross(s, t)) return true;
  return false;
}

// Every pair held against every other, nothing left out beforehand.
std::vector<Crossing> all_crossings_near(const Mesh& mesh, const std::vector<Face>& faces) {
  std::set<Face> near(faces.begin(), faces.end());
  for (int ring = 0; ring < 2; ++ring)
    for (Face f : std::set<Face>(near))
      for (Vertex v : vertices_around(mesh, f))
        for (Face g : faces_around(mesh, v))
          if (g) near.insert(g);
  std::set<Crossing> found;
  for (Face f : faces)
    for (Face g : near)
      if (f != g && cross(mesh, f, g)) found.emplace(std::min(f, g), std::max(f, g));
  return {found.begin(), found.end()};
}

TEST(crossings, are_those_that_a_search_over_all_pairs_finds) {
  std::size_t found = 0, asked = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const RandomMesh random = random_mesh(seed);
    IndexedMesh list = indexed(Polygons(), static_cast<std::size_t>(random.points));
    for (const auto& face : random.faces) {
      for (int corner : face) list.corners.push_back(static_cast<std::uint32_t>(corner));
      list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
    }
    Dice dice(seed);
    // On a coarse lattice, so that places are shared, and sides and faces touch.
    for (glm::dvec3& p : list.positions) p = {dice.below(4), dice.below(4), dice.below(4) + 0.5 * dice.below(2)};
    const Mesh mesh = from_indexed(std::move(list));
    for (int i = 0; i < 5 && mesh.live().faces > 0; ++i) {
      std::vector<Face> faces;
      for (int k = 1 + dice.below(4); k > 0; --k) {
        const Face f(static_cast<std::uint32_t>(dice.below(static_cast<int>(mesh.face_slots()))));
        if (mesh.is_alive(f)) faces.push_back(f);
      }
      const std::vector<Crossing> expected = all_crossings_near(mesh, faces);
      ASSERT_EQ(crossings_near(mesh, faces), expected) << "seed " << seed;
      found += expected.size();
      ++asked;
    }
  }
  EXPECT_GT(asked, 1000u);
  EXPECT_GT(found, 300u);
}

TEST(crossings, among_many_faces_around_a_point_are_those_of_all_pairs) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Dice dice(seed);
    constexpr std::uint32_t spokes = 150;
    IndexedMesh list = indexed(closed_fan(spokes));
    list.positions[0] = {0, 0, 0};
    for (std::uint32_t i = 1; i <= spokes; ++i)
      list.positions[i] = {2 * dice.unit() - 1, 2 * dice.unit() - 1, dice.unit()};
    const Mesh mesh = from_indexed(std::move(list));
    std::vector<Face> faces;
    for (std::uint32_t i = 0; i < spokes; i += seed % 2 == 0 ? 1 : 2) faces.emplace_back(i);
    const std::vector<Crossing> expected = all_crossings_near(mesh, faces);
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(crossings_near(mesh, faces), expected) << "seed " << seed;
  }
}

TEST(crossings, are_found_beside_a_place_that_is_not_finite) {
  IndexedMesh list = indexed({{0, 1, 2}, {0, 3, 4}, {0, 4, 5}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  list.positions = {{9, 9, 9}, {nan, 0, 0}, {1, 1, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Mesh mesh = from_indexed(std::move(list));
  const std::vector<Face> all{Face(0), Face(1), Face(2)};
  EXPECT_EQ(crossings_near(mesh, all), all_crossings_near(mesh, all));
}

}  // namespace
}  // namespace ryosen
