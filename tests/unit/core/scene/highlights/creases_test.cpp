#include "ryosen/scene/highlights/feature_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

std::uint32_t crease_count(const Mesh& mesh) {
  Neighbourhood around(mesh);
  std::uint32_t n = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) n += mesh.is_alive(Edge(i)) && is_crease(around, Edge(i));
  return n;
}

Mesh placed(const Polygons& faces, std::vector<glm::dvec3> places, std::vector<std::uint32_t> bridged = {}) {
  IndexedMesh source = indexed(faces);
  source.bridged = std::move(bridged);
  source.positions = std::move(places);
  return from_indexed(std::move(source));
}

// Two faces on the edge 0-1, bent by an angle; `second` is the second one.
Mesh bent(double degrees, const Polygons& faces) {
  const double angle = degrees * std::numbers::pi / 180;
  return placed(faces, {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -std::cos(angle), std::sin(angle)}});
}

TEST(creases, begin_at_thirty_degrees) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(crease_count(bent(sign * 0, {{0, 1, 2}, {1, 0, 3}})), 0u);
    EXPECT_EQ(crease_count(bent(sign * 29.999, {{0, 1, 2}, {1, 0, 3}})), 0u);
    EXPECT_EQ(crease_count(bent(sign * 30.001, {{0, 1, 2}, {1, 0, 3}})), 1u);
    EXPECT_EQ(crease_count(bent(sign * 179, {{0, 1, 2}, {1, 0, 3}})), 1u);
  }
}

TEST(creases, are_told_by_the_bend_where_the_faces_are_turned_against_each_other) {
  EXPECT_EQ(crease_count(bent(0, {{0, 1, 2}, {0, 1, 3}})), 0u);
  EXPECT_EQ(crease_count(bent(29.999, {{0, 1, 2}, {0, 1, 3}})), 0u);
  EXPECT_EQ(crease_count(bent(30.001, {{0, 1, 2}, {0, 1, 3}})), 1u);
}

TEST(creases, are_edges_of_two_faces) {
  EXPECT_EQ(crease_count(make_mesh({{0, 1, 2}})), 0u) << "boundary";
  EXPECT_EQ(crease_count(make_mesh(fin())), 0u) << "non-manifold";
  EXPECT_EQ(crease_count(placed(tetrahedron(), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}})), 6u);
}

TEST(creases, need_faces_with_area_at_finite_places) {
  EXPECT_EQ(crease_count(placed({{0, 1, 2}, {1, 0, 3}}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}})), 0u);
  const double far = std::numeric_limits<double>::infinity();
  EXPECT_EQ(crease_count(placed({{0, 1, 2}, {1, 0, 3}}, {{0, 0, 0}, {1, 0, 0}, {0, far, 0}, {0, 0, 1}})), 0u);
  const double tiny = 1e-200, large = 1e200;
  EXPECT_EQ(crease_count(placed({{0, 1, 2}, {1, 0, 3}}, {{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}})), 1u);
  EXPECT_EQ(crease_count(placed({{0, 1, 2}, {1, 0, 3}}, {{0, 0, 0}, {large, 0, 0}, {0, large, 0}, {0, 0, large}})), 1u);
}

TEST(creases, of_polygons_go_by_the_area_normal) {
  // A concave face whose first three corners turn the other way, flat beside a triangle.
  EXPECT_EQ(
      crease_count(placed({{0, 1, 2, 3}, {1, 0, 4}}, {{0, 0, 0}, {1, 0, 0}, {0.4, 0.4, 0}, {0, 1, 0}, {0.5, -1, 0}})),
      0u);
  // A face of many corners.
  Polygons faces{{}, {1, 0, 40}};
  std::vector<glm::dvec3> places;
  for (std::uint32_t i = 0; i < 40; ++i) {
    faces[0].push_back(i);
    places.push_back({std::cos(i * 0.157), std::sin(i * 0.157), 0});
  }
  places.push_back({1.2, 0.1, 0});
  EXPECT_EQ(crease_count(placed(faces, places)), 0u);
  places.back() = {0.9, 0.1, 1};
  EXPECT_EQ(crease_count(placed(faces, places)), 1u);
}

TEST(creases, of_a_face_with_a_ring_go_by_all_its_loops) {
  // A square with a hole that another face fills.
  Mesh mesh = placed({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}, {4, 5, 6, 7}},
                     {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}}, {0});
  ASSERT_TRUE(mesh.has_rings());
  EXPECT_EQ(crease_count(mesh), 0u);
  const Halfedge outer = find_halfedge(mesh, Vertex(0), Vertex(1)), inner = find_halfedge(mesh, Vertex(4), Vertex(7));
  const UniteRing bridge{outer, inner};
  ASSERT_TRUE(bridge.check(mesh).legal());
  Edit edit(mesh, nullptr);
  bridge.apply(edit);
  edit.commit();
  ASSERT_FALSE(mesh.has_rings());
  EXPECT_EQ(crease_count(mesh), 0u) << "the bridge lies in one face";
}

}  // namespace
}  // namespace ryosen
