// Seams of corner values in simplification: normals of flat faces are none but where they are to be kept.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/simplify/flat_normals.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/triangle_corners.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

// The mesh with a value for each corner of its own, made of the normal of its face.
Mesh with_flat_normals(const Mesh& mesh, double rounding = 0) {
  IndexedMesh source = to_indexed(mesh).mesh;
  source.normals = {};
  source.normals.components = 3;
  for (std::size_t f = 0; f < source.face_count(); ++f) {
    const auto corners = source.face(f);
    const glm::dvec3 &a = source.positions[corners[0]], &b = source.positions[corners[1]],
                     &c = source.positions[corners[2]];
    glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    if (rounding > 0) normal = rounding * glm::round(normal / rounding);
    for (std::size_t i = 0; i < corners.size(); ++i) source.normals.index.push_back(static_cast<std::uint32_t>(f));
    source.normals.pool.push_back(normal);
  }
  return from_indexed(std::move(source));
}

void expect_flat_normals(const Mesh& mesh) {
  const std::vector<CornerAttribute> attributes = corner_attributes(mesh);
  ASSERT_EQ(attributes.size(), 1u);
  const AttributeColumn &index = mesh.attributes()[attributes[0].index_column],
                        &pool = mesh.attributes()[attributes[0].pool_column];
  for (Face f(0); f.index < mesh.face_slots(); ++f.index) {
    if (!mesh.is_alive(f)) continue;
    const glm::dvec3 own = glm::normalize(area_normal(corners_of(mesh, mesh.halfedge(f))));
    for (const Halfedge h : halfedges_around(mesh, f)) {
      ASSERT_NE(index.data[h.index], no_index);
      EXPECT_GT(glm::dot(own, attribute_value<glm::dvec3>(pool, index.data[h.index])), 1 - 1e-12);
    }
  }
}

TEST(SimplifySeams, flat_normals_are_no_seams_and_stay_flat) {
  Mesh octahedron = report_mesh("flat_normals.obj");
  Journal journal;
  run_algorithm(octahedron, journal, "simplify faces=4");
  EXPECT_EQ(octahedron.live().faces, 4u);
  expect_flat_normals(octahedron);
}

TEST(SimplifySeams, flat_normals_change_no_result) {
  for (const char* const shape : {"sphere", "icosahedron", "torus", "cylinder"})
    for (const double rounding : {0.0, 0.01}) {
      SCOPED_TRACE(shape);
      Journal journal;
      Mesh plain = made_by(shape);
      run_algorithm(plain, journal, "simplify ratio=1 faces=100000 triangulate=on");
      Mesh flat = with_flat_normals(plain, rounding);
      plain = from_indexed(to_indexed(plain).mesh);
      run_algorithm(plain, journal, "simplify ratio=0.4");
      run_algorithm(flat, journal, "simplify ratio=0.4");
      EXPECT_EQ(to_indexed(flat).mesh.corners, to_indexed(plain).mesh.corners);
      expect_flat_normals(flat);
    }
}

TEST(SimplifySeams, kept_they_hold_under_their_rule) {
  for (const bool is_report : {true, false}) {
    Mesh mesh = is_report ? report_mesh("flat_normals.obj") : with_flat_normals(made_by("icosahedron"));
    const std::uint32_t faces = mesh.live().faces, edges = mesh.live().edges;
    Journal journal;
    const AlgorithmResult result = run_algorithm(mesh, journal, "simplify faces=4 seams=keep");
    EXPECT_EQ(mesh.live().faces, faces);
    ASSERT_TRUE(result.goal_report);
    EXPECT_EQ(result.goal_report->remaining[static_cast<std::size_t>(EdgeRule::seam)], edges);
  }
}

// A value for each corner of each face: every edge is a seam of texture.
TEST(SimplifySeams, those_of_texture_stay) {
  IndexedMesh source = to_indexed(made_by("icosahedron")).mesh;
  source.texcoords.components = 2;
  for (std::size_t i = 0; i < source.corners.size(); ++i) {
    source.texcoords.pool.emplace_back(double(i), 0.5, 0);
    source.texcoords.index.push_back(static_cast<std::uint32_t>(i));
  }
  const Mesh mesh = from_indexed(std::move(source));
  Journal journal;
  for (const char* const words : {"faces=8", "faces=8 seams=keep", "error=100"}) {
    Mesh made = mesh;
    const AlgorithmResult result = run_algorithm(made, journal, std::string("simplify ") + words);
    EXPECT_EQ(made.live().faces, 20u) << words;
    EXPECT_EQ(result.goal_report->remaining[static_cast<std::size_t>(EdgeRule::seam)], 30u) << words;
  }
}

TEST(SimplifySeams, normals_of_smooth_faces_are_no_flat_ones) {
  Mesh smooth = made_by("sphere");
  EXPECT_FALSE(take_flat_normals(smooth)) << "there are none";
  IndexedMesh source = to_indexed(smooth).mesh;
  source.normals.components = 3;
  source.normals.index = source.corners;
  for (const glm::dvec3& p : source.positions) source.normals.pool.push_back(glm::normalize(p));
  Mesh mesh = from_indexed(std::move(source));
  EXPECT_FALSE(take_flat_normals(mesh));
  EXPECT_EQ(corner_attributes(mesh).size(), 1u);
}

}  // namespace
}  // namespace ryosen::test
