#include "ryosen/indexed/from_indexed.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

void expect_sound(const Mesh& mesh) {
  const auto broken = check_invariants(mesh);
  EXPECT_FALSE(broken) << broken->rule << ": " << broken->sentence;
}

TEST(from_indexed, keeps_every_corner_list_and_its_first_corner) {
  for (const Polygons& faces : {tetrahedron(), cube(), two_quads(), closed_fan(7), torus_grid(5, 4)}) {
    const Mesh mesh = make_mesh(faces);
    expect_sound(mesh);
    EXPECT_EQ(polygons_of(mesh), faces);
  }
}

TEST(from_indexed, closed_meshes_have_no_outside) {
  const Mesh mesh = make_mesh(cube());
  EXPECT_EQ(mesh.live(), (ElementCounts{8, 12, 6}));
  for (std::uint32_t h = 0; h < mesh.halfedge_slots(); ++h) EXPECT_FALSE(mesh.is_outside(Halfedge(h)));
}

TEST(from_indexed, boundary_loops_run_outside) {
  const Mesh mesh = make_mesh(two_quads());
  expect_sound(mesh);
  std::uint32_t length = 0;
  for (Halfedge h : loop(mesh, mesh.halfedge(Vertex(2)))) {
    EXPECT_TRUE(mesh.is_outside(h));
    ++length;
  }
  EXPECT_EQ(length, 6u);
}

TEST(from_indexed, bow_tie_becomes_two_copies_of_one_point) {
  const Mesh mesh = make_mesh(bow_tie());
  expect_sound(mesh);
  EXPECT_EQ(mesh.live(), (ElementCounts{6, 6, 2}));
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{5, 6, 2}));
  EXPECT_TRUE(same_point(mesh, Vertex(0), Vertex(5)));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 2}, {5, 3, 4}}));
}

TEST(from_indexed, third_face_on_an_edge_cuts_all_three) {
  const Mesh mesh = make_mesh(fin());
  expect_sound(mesh);
  EXPECT_EQ(mesh.live(), (ElementCounts{9, 9, 3}));
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{5, 7, 3}));
  const Halfedge h = find_halfedge(mesh, Vertex(0), Vertex(1));
  EXPECT_TRUE(point_edge(mesh, h).is_nonmanifold());
  EXPECT_TRUE(is_cut_on_points(mesh, h));
}

TEST(from_indexed, two_tetrahedra_on_an_edge_are_two_closed_ones) {
  const Mesh mesh = make_mesh(two_tetrahedra_on_an_edge());
  expect_sound(mesh);
  EXPECT_EQ(mesh.live(), (ElementCounts{8, 12, 8}));
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{6, 11, 8}));
  for (std::uint32_t h = 0; h < mesh.halfedge_slots(); ++h) EXPECT_FALSE(mesh.is_outside(Halfedge(h)));
}

TEST(from_indexed, copies_are_numbered_by_point_then_by_lowest_face) {
  const Mesh mesh = make_mesh({{3, 1, 2}, {3, 4, 5}, {2, 6, 7}, {3, 8, 9}});
  expect_sound(mesh);
  EXPECT_EQ(polygons_of(mesh), (Polygons{{3, 1, 2}, {11, 4, 5}, {10, 6, 7}, {12, 8, 9}}));
}

TEST(from_indexed, misoriented_faces_stay_cut) {
  const Mesh mesh = make_mesh({{0, 1, 2}, {0, 1, 3}});
  expect_sound(mesh);
  EXPECT_EQ(mesh.live(), (ElementCounts{6, 6, 2}));
  EXPECT_TRUE(point_edge(mesh, find_halfedge(mesh, Vertex(0), Vertex(1))).is_misoriented());
}

TEST(from_indexed, moebius_strip_and_duplicates_load) {
  expect_sound(make_mesh(moebius_strip()));
  const Mesh same = make_mesh({{0, 1, 2}, {1, 2, 0}});
  expect_sound(same);
  EXPECT_EQ(same.live(), (ElementCounts{6, 6, 2}));
  EXPECT_EQ(counts_on_points(same), (ElementCounts{3, 3, 2}));
  const Mesh opposite = make_mesh({{0, 1, 2}, {0, 2, 1}});
  expect_sound(opposite);
  EXPECT_EQ(opposite.live(), (ElementCounts{3, 3, 2}));
}

TEST(from_indexed, quarantined_face_holds_a_dead_number) {
  IndexedMesh source = indexed({{0, 1, 2}, {}, {2, 1, 3}});
  static_assert(sizeof(QuarantinedFace) <= 48, "a broken file may hold one for every byte");
  source.quarantine.push_back({1, 7, "face_too_few_corners", {0, 1}, {}, {}, {}});
  const Mesh mesh = from_indexed(std::move(source));
  expect_sound(mesh);
  EXPECT_EQ(mesh.face_slots(), 3u);
  EXPECT_FALSE(mesh.is_alive(Face(1)));
  EXPECT_EQ(mesh.live().faces, 2u);
}

TEST(from_indexed, isolated_points_stay) {
  const Mesh mesh = make_mesh(tetrahedron(), 6);
  expect_sound(mesh);
  EXPECT_TRUE(mesh.is_isolated(Vertex(4)));
  EXPECT_EQ(mesh.live().vertices, 6u);
}

}  // namespace
}  // namespace ryosen
