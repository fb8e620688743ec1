// Extrude of every set of faces of small meshes: the list that its header defines, built anew, must have the same
// faces, fans, edges and figures.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/extruding.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;
using oracle::Complex;
using oracle::Corners;

class SetsOfFaces {
 public:
  ~SetsOfFaces() { std::cout << legal_ << " extruded, " << refused_ << " refused\n"; }

  // All sets of at most `most` faces, each in an order of its own; of a mesh with many faces some, all in a long run.
  void all_sets(const oracle::PolygonList& list, int most = 64) {
    const Mesh mesh = kernel_mesh(list, 5);
    const std::uint32_t faces = mesh.face_slots();
    const std::uint32_t step = is_long_run() || faces < 9 ? 1 : faces > 10 ? 509 : 5;
    for (std::uint32_t set = 1; set < (1u << faces) && !testing::Test::HasFailure(); set += step) {
      std::vector<int> named = in_order(set, faces);
      std::rotate(named.begin(), named.begin() + set % static_cast<std::ptrdiff_t>(named.size()), named.end());
      if (static_cast<int>(named.size()) <= most) compare(mesh, list, named);
    }
  }

 private:
  static std::vector<int> in_order(std::uint32_t set, std::uint32_t faces) {
    std::vector<int> named;
    for (std::uint32_t i = 0; i < faces; ++i)
      if (set >> i & 1) named.push_back(static_cast<int>(i));
    return named;
  }

  void compare(const Mesh& before, const oracle::PolygonList& list, const std::vector<int>& named) {
    Extrude op;
    for (int f : named) op.faces.emplace_back(static_cast<std::uint32_t>(f));
    op.offset = glm::dvec3(0.25, -0.5, 2);
    const Complex points = oracle::on_points(complex_of(before));
    const oracle::Extruded expected = oracle::extruded(points, named);
    const std::string name = command_of(before, op) + " on " + to_text(list);
    const bool keeps_equal = oracle::facts_of(expected.after).equal_faces == oracle::facts_of(points).equal_faces;
    ASSERT_EQ(check(before, op).legal(), keeps_equal) << name;
    ++(keeps_equal ? legal_ : refused_);
    if (!keeps_equal) return;
    Mesh mesh = before;
    {
      const testing::ScopedTrace trace(__FILE__, __LINE__, name);
      apply_and_prove(mesh, op);
    }
    ASSERT_EQ(differs_from_reading(mesh), "") << name;
    expect_list(before, mesh, expected, name);
  }

  static void expect_list(const Mesh& before, const Mesh& mesh, const oracle::Extruded& expected,
                          const std::string& name) {
    const int old = static_cast<int>(before.vertex_slots());
    const Complex found = oracle::on_points(complex_of(mesh));
    ASSERT_EQ(oracle::faces_with_new_points_in_order(found, old),
              oracle::faces_with_new_points_in_order(expected.after, old))
        << name;
    const ElementCounts was = counts_on_points(before), is = counts_on_points(mesh);
    EXPECT_EQ(is.vertices - was.vertices, static_cast<std::uint32_t>(expected.points)) << name;
    EXPECT_EQ(is.edges - was.edges, static_cast<std::uint32_t>(expected.walls + expected.border_points)) << name;
    EXPECT_EQ(is.faces - was.faces, static_cast<std::uint32_t>(expected.walls)) << name;
    std::vector<Corners> faces;
    for (const auto& loops : expected.after.faces) faces.push_back(loops[0]);
    const Mesh anew = kernel_mesh(oracle::polygon_list(expected.after.size(), faces), 5);
    const Figures here = compute_figures(mesh), there = compute_figures(anew);
    for (const ProblemKind kind :
         {ProblemKind::boundary_loop, ProblemKind::nonmanifold_edge, ProblemKind::misoriented_edge,
          ProblemKind::nonmanifold_vertex, ProblemKind::duplicate_face})
      EXPECT_EQ(here[kind], there[kind]) << name;
    EXPECT_EQ(here.components, there.components) << name;
  }

  std::size_t legal_ = 0, refused_ = 0;
};

oracle::PolygonList list_of_shape(const Polygons& shape) {
  std::vector<Corners> faces;
  int points = 0;
  for (const auto& face : shape) {
    faces.emplace_back(face.begin(), face.end());
    for (int v : faces.back()) points = std::max(points, v + 1);
  }
  return oracle::polygon_list(points, faces);
}

Polygons quad_grid(std::uint32_t columns, std::uint32_t rows) {
  Polygons faces;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t v = y * (columns + 1) + x;
      faces.push_back({v, v + 1, v + columns + 2, v + columns + 1});
    }
  return faces;
}

TEST(extrude_oracle, every_set_of_faces_of_named_shapes) {
  SetsOfFaces all;
  for (const Polygons& shape : {tetrahedron(), cube(), two_quads(), closed_fan(5), bow_tie(), fin(), moebius_strip(),
                                torus_grid(3, 3), two_tetrahedra_on_an_edge(), quad_grid(3, 3)})
    all.all_sets(list_of_shape(shape));
}

TEST(extrude_oracle, every_set_of_faces_where_sheets_meet) {
  SetsOfFaces all;
  const Polygons book{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}, {0, 1, 6}};
  const Polygons misoriented{{0, 1, 2}, {0, 1, 3}, {1, 2, 4}};
  const Polygons hanging_pair{{0, 1, 2}, {0, 2, 1}, {2, 1, 3}};
  const Polygons thrice_the_same{{0, 1, 2}, {0, 2, 1}, {0, 1, 2}};
  // A cone that is cut along the edge 0-1 at which a fin stands, open and closed to a tetrahedron.
  const Polygons cone_and_fin{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 4}};
  const Polygons tetrahedron_and_fin{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {1, 0, 4}};
  const Polygons three_boxes_around_a_point{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5},
                                            {0, 5, 6}, {0, 6, 4}, {0, 7, 8}, {0, 8, 9}};
  for (const Polygons& shape : {book, misoriented, hanging_pair, thrice_the_same, cone_and_fin, tetrahedron_and_fin,
                                three_boxes_around_a_point})
    all.all_sets(list_of_shape(shape));
}

TEST(extrude_oracle, sets_of_faces_of_random_meshes) {
  SetsOfFaces all;
  const std::uint64_t seeds = is_long_run() ? 2000 : 12;
  for (std::uint64_t seed = 0; seed < seeds && !HasFailure(); ++seed) {
    RandomMesh random = random_mesh(seed);
    if (random.faces.size() > 9) random.faces.resize(9);
    all.all_sets(oracle::polygon_list(random.points, random.faces), is_long_run() ? 9 : 4);
  }
}

}  // namespace
}  // namespace ryosen
