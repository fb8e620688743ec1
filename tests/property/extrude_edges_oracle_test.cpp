// Extruding every set of edges of small meshes: the list that its header defines, built anew, must have the same faces,
// fans, edges and figures.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/extrude_edges.h"
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
using oracle::Pair;

class SetsOfEdges {
 public:
  // `most`: of how many edges of a mesh all sets are tried.
  explicit SetsOfEdges(std::size_t most = is_long_run() ? 16 : 8) : most_(most) {}
  ~SetsOfEdges() { std::cout << extruded_ << " extruded\n"; }

  // All sets of edges, each in an order of its own; of a mesh with many edges some.
  void all_sets(const Mesh& mesh) {
    std::vector<Halfedge> edges;
    const Complex points = oracle::on_points(complex_of(mesh));
    std::set<Pair> met;
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i)
      if (mesh.is_alive(Edge(i)) && met.insert(pair_of(mesh, halfedge(Edge(i)))).second)
        edges.push_back(halfedge(Edge(i), i % 2));
    const std::size_t shown = std::min(edges.size(), most_);
    for (std::uint32_t set = 1; set < (1u << shown) && !testing::Test::HasFailure(); ++set) {
      std::vector<Halfedge> named;
      // Another part of a mesh with many edges for each set.
      for (std::size_t i = 0; i < shown; ++i)
        if (set >> i & 1) named.push_back(edges[(i * 5 + (edges.size() > most_ ? set : 0)) % edges.size()]);
      std::rotate(named.begin(), named.begin() + set % static_cast<std::ptrdiff_t>(named.size()), named.end());
      compare(mesh, points, named);
    }
  }

 private:
  static Pair pair_of(const Mesh& mesh, Halfedge h) {
    const auto a = static_cast<int>(point(mesh, mesh.from(h)).index);
    const auto b = static_cast<int>(point(mesh, mesh.to(h)).index);
    return std::minmax({a, b});
  }

  // As the sides of faces run: that of the one face, else either way, which the quad tells.
  static std::vector<Pair> sides_of(const Mesh& before, const std::vector<Halfedge>& named, const Mesh& after) {
    std::vector<Pair> sides;
    std::set<Pair> met;
    for (Halfedge h : named) {
      if (!met.insert(pair_of(before, h)).second) continue;
      Halfedge side = before.is_outside(h) ? twin(h) : h;
      if (before.is_outside(side) || !before.is_outside(twin(side))) {
        const Face quad(before.face_slots() + static_cast<std::uint32_t>(sides.size()));
        const bool is_along = point(after, after.from(after.halfedge(quad))) == point(before, before.from(side));
        if (is_along != before.is_outside(side)) side = twin(side);
      }
      sides.emplace_back(static_cast<int>(point(before, before.from(side)).index),
                         static_cast<int>(point(before, before.to(side)).index));
    }
    return sides;
  }

  void compare(const Mesh& before, const Complex& points, const std::vector<Halfedge>& named) {
    const ExtrudeEdges op{named, {}, glm::dvec3(0.25, -0.5, 2)};
    const std::string name = command_of(before, op) + " on " + to_text(points);
    ASSERT_TRUE(check(before, op).legal()) << name;
    ++extruded_;
    Mesh mesh = before;
    {
      const testing::ScopedTrace trace(__FILE__, __LINE__, name);
      apply_and_prove(mesh, op);
    }
    ASSERT_EQ(differs_from_reading(mesh), "") << name;
    const std::vector<Pair> sides = sides_of(before, named, mesh);
    const Complex expected = oracle::with_extruded_edges(points, sides);
    const auto old = static_cast<int>(before.vertex_slots());
    ASSERT_EQ(oracle::faces_with_new_points_in_order(oracle::on_points(complex_of(mesh)), old),
              oracle::faces_with_new_points_in_order(expected, old))
        << name;
    const ElementCounts was = counts_on_points(before), is = counts_on_points(mesh);
    const std::size_t tops = expected.live.size() - points.live.size();
    EXPECT_EQ(is.vertices - was.vertices, tops) << name;
    EXPECT_EQ(is.edges - was.edges, tops + sides.size()) << name;
    EXPECT_EQ(is.faces - was.faces, sides.size()) << name;
  }

  std::size_t most_, extruded_ = 0;
};

Mesh with_wires(Mesh mesh, std::initializer_list<const char*> wires) {
  for (const char* wire : wires) apply_and_prove(mesh, std::string("make_edge ") + wire);
  return mesh;
}

TEST(extrude_edges_oracle, every_set_of_edges_of_named_shapes) {
  SetsOfEdges all;
  const Polygons book{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}};
  const Polygons misoriented{{0, 1, 2}, {0, 1, 3}, {1, 2, 4}};
  const Polygons hanging_pair{{0, 1, 2}, {0, 2, 1}, {2, 1, 3}};
  const Polygons cone_and_fin{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 4}};
  for (const Polygons& shape :
       {tetrahedron(), cube(), two_quads(), closed_fan(5), bow_tie(), fin(), moebius_strip(), torus_grid(3, 3),
        two_tetrahedra_on_an_edge(), book, misoriented, hanging_pair, cone_and_fin})
    all.all_sets(make_mesh(shape));
}

TEST(extrude_edges_oracle, every_set_of_edges_where_wires_are) {
  SetsOfEdges all;
  all.all_sets(with_wires(make_mesh({}, 5), {"0 1", "1 2 0-1", "1 3 0-1", "3 4 1-3"}));
  all.all_sets(with_wires(make_mesh({{0, 1, 2}}, 5), {"0 3", "3 4 0-3", "4 1 3-4"}));
  all.all_sets(with_wires(make_mesh({{0, 1, 2}, {0, 3, 4}}, 7), {"0 5 1-0", "5 6 0-5"}));
  all.all_sets(with_wires(make_mesh(bow_tie(), 7), {"5 6"}));
  Mesh behind_fan = with_wires(make_mesh({{0, 1, 2}, {0, 2, 3}}, 5), {"0 4"});  // the wire is on a copy when it closes
  apply_and_prove(behind_fan, "make_face 0 3 1");
  all.all_sets(behind_fan);
}

TEST(extrude_edges_oracle, sets_of_edges_of_random_meshes) {
  SetsOfEdges all(is_long_run() ? 9 : 8);
  const std::uint64_t seeds = is_long_run() ? 400 : 6;
  for (std::uint64_t seed = 0; seed < seeds && !HasFailure(); ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    all.all_sets(make_mesh(random.faces, random.points));
  }
}

}  // namespace
}  // namespace ryosen
