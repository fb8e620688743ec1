#include "ryosen/analysis/boundary_loops.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/analysis/problem_sets.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

BoundaryLoops loops_of(const Mesh& mesh) {
  Neighbourhood around(mesh);
  return find_boundary_loops(around, ProblemSets(mesh).of(ProblemKind::boundary_loop));
}

std::vector<std::size_t> lengths(const Mesh& mesh) {
  const BoundaryLoops loops = loops_of(mesh);
  std::vector<std::size_t> lengths;
  for (std::size_t i = 0; i < loops.size(); ++i) lengths.push_back(loops[i].size());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST(boundary_loops, of_an_annulus) {
  Polygons ring;
  for (std::uint32_t i = 0; i < 5; ++i) ring.push_back({i, (i + 1) % 5, 5 + (i + 1) % 5, 5 + i});
  EXPECT_EQ(lengths(make_mesh(ring)), (std::vector<std::size_t>{5, 5}));
  EXPECT_TRUE(lengths(make_mesh(cube())).empty());
}

TEST(boundary_loops, are_the_outside_cycles_where_nothing_is_cut) {
  const Mesh mesh = make_mesh(two_quads());
  const BoundaryLoops loops = loops_of(mesh);
  ASSERT_EQ(loops.size(), 1u);
  ASSERT_EQ(loops[0].size(), 6u);
  for (Halfedge h : loops[0]) EXPECT_TRUE(mesh.is_outside(h));
  // The walk goes from edge to edge.
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(mesh.from(loops[0][i]), mesh.to(loops[0][(i + 1) % 6]));
}

TEST(boundary_loops, are_kept_apart_by_a_bow_tie) {
  EXPECT_EQ(lengths(make_mesh(bow_tie())), (std::vector<std::size_t>{3, 3}));
}

TEST(boundary_loops, go_on_past_misoriented_edges) {
  EXPECT_EQ(lengths(make_mesh(moebius_strip())), (std::vector<std::size_t>{5}));
  EXPECT_EQ(lengths(make_mesh({{0, 1, 2}, {0, 1, 3}})), (std::vector<std::size_t>{4}));
}

TEST(boundary_loops, end_at_nonmanifold_edges) {
  EXPECT_TRUE(lengths(make_mesh(fin())).empty());
  // The fin stands on a closed tetrahedron: its own chain is open as well.
  Polygons faces = tetrahedron();
  faces.push_back({0, 1, 4});
  EXPECT_TRUE(lengths(make_mesh(faces)).empty());
}

}  // namespace
}  // namespace ryosen
