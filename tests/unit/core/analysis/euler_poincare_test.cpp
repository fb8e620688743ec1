#include "ryosen/analysis/euler_poincare.h"

#include <gtest/gtest.h>

#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/to_indexed.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

struct Terms {
  std::int64_t v, e, f, b, w, i, h, s;
  std::optional<std::int64_t> g;
};

void expect(const Mesh& mesh, const Terms& terms) {
  const EulerPoincare found = euler_poincare(mesh);
  EXPECT_EQ(found.vertices, terms.v);
  EXPECT_EQ(found.edges, terms.e);
  EXPECT_EQ(found.faces, terms.f);
  EXPECT_EQ(found.boundary_loops, terms.b);
  EXPECT_EQ(found.wire_cycles, terms.w);
  EXPECT_EQ(found.isolated, terms.i);
  EXPECT_EQ(found.rings, terms.h);
  EXPECT_EQ(found.parts, terms.s);
  EXPECT_EQ(found.genus, terms.g);
  EXPECT_EQ(found.holds(), terms.g.has_value());
}

std::string reason(const Mesh& mesh) { return why_no_genus(mesh, euler_poincare(mesh)).en; }

void apply_lines(Mesh& mesh, std::initializer_list<const char*> lines) {
  for (const char* line : lines) {
    Edit edit(mesh, nullptr);
    ryosen::apply(edit, op_of(mesh, line));
    edit.commit();
  }
}

TEST(euler_poincare, has_no_boundary_loops_where_boundary_edges_close_to_none_and_says_so) {
  const EulerTerm& b = euler_letters()[3];
  ASSERT_EQ(b.letter, 'B');
  for (const Polygons& faces : {cube(), two_quads(), bow_tie(), moebius_strip()}) {
    const Mesh mesh = make_mesh(faces);
    const EulerPoincare terms = euler_poincare(mesh);
    EXPECT_EQ(b.value(terms), terms.boundary_loops);
    EXPECT_EQ(why_no_value(mesh, terms, b).en, "");
  }
  const Mesh mesh = make_mesh(fin());
  const EulerPoincare terms = euler_poincare(mesh);
  EXPECT_FALSE(b.value(terms));
  EXPECT_NE(why_no_value(mesh, terms, b).en.find("three or more faces"), std::string::npos);
  EXPECT_NE(why_no_value(mesh, terms, b).ja, "");
  EXPECT_EQ(why_no_value(mesh, terms, euler_letters().back()).en, "not manifold at 0-1") << "that of G";
}

TEST(euler_poincare, of_surfaces) {
  expect(make_mesh(cube()), {8, 12, 6, 0, 0, 0, 0, 1, 0});
  expect(make_mesh(torus_grid(4, 5)), {20, 60, 40, 0, 0, 0, 0, 1, 1});
  expect(make_mesh(two_quads()), {6, 7, 2, 1, 0, 0, 0, 1, 0});
  expect(make_mesh(two_quads(), 8), {8, 7, 2, 1, 0, 2, 0, 3, 0});
  expect(make_mesh({}, 0), {0, 0, 0, 0, 0, 0, 0, 0, 0});
  expect(make_mesh({}, 3), {3, 0, 0, 0, 0, 3, 0, 3, 0});
  expect(mesh_of_exercise("cube_with_hole"), {16, 24, 10, 0, 0, 0, 2, 1, 1});
  expect(mesh_of_exercise("cube_with_two_holes"), {24, 36, 14, 0, 0, 0, 4, 1, 2});
}

// The kernel's sum holds on all of these, as each copy and each cut edge counts for itself; on points it does not.
TEST(euler_poincare, has_no_handles_where_the_mesh_is_not_manifold_and_says_where) {
  expect(make_mesh(fin()), {5, 7, 3, 0, 0, 0, 0, 1, std::nullopt});
  EXPECT_EQ(reason(make_mesh(fin())), "not manifold at 0-1");
  expect(make_mesh(bow_tie()), {5, 6, 2, 2, 0, 0, 0, 1, std::nullopt});
  EXPECT_EQ(reason(make_mesh(bow_tie())), "not manifold at v0");
  expect(make_mesh(two_tetrahedra_on_an_edge()), {6, 11, 8, 0, 0, 0, 0, 1, std::nullopt});
  for (const Polygons& faces : {fin(), bow_tie(), two_tetrahedra_on_an_edge()}) {
    const KernelSum kernel = kernel_sum(make_mesh(faces));
    EXPECT_EQ(kernel.left(), kernel.right());
    const EulerPoincare terms = euler_poincare(make_mesh(faces));
    EXPECT_NE(terms.left(), 2 * terms.parts) << "as if there were no handles";
  }
}

TEST(euler_poincare, has_no_handles_where_the_surface_is_one_sided) {
  for (const char* name : {"projective_plane.off", "klein_bottle.off", "moebius.off"}) {
    const Mesh mesh = asset_mesh(name);
    const EulerPoincare terms = euler_poincare(mesh);
    EXPECT_FALSE(terms.genus) << name;
    EXPECT_EQ(terms.no_genus, NoGenus::one_sided) << name;
    EXPECT_TRUE(reason(mesh).starts_with("one-sided: ")) << reason(mesh);
    EXPECT_EQ(terms.parts, 1);
  }
  expect(asset_mesh("projective_plane.off"), {6, 15, 10, 0, 0, 0, 0, 1, std::nullopt});
}

TEST(euler_poincare, is_counted_over_faces_that_disagree_but_can_be_turned) {
  const Mesh mesh = make_mesh({{0, 1, 2}, {0, 1, 3}});
  EXPECT_TRUE(mesh.has_copies());
  expect(mesh, {4, 5, 2, 1, 0, 0, 0, 1, 0});
  Polygons faces = torus_grid(3, 4);
  std::swap(faces[5][0], faces[5][1]);
  expect(make_mesh(faces), {12, 36, 24, 0, 0, 0, 0, 1, 1});
}

TEST(euler_poincare, counts_walks_along_wires_apart_from_boundary_loops) {
  // A wire alone, one of two edges, a triangle of wires.
  Mesh mesh = make_mesh({}, 2);
  apply_lines(mesh, {"make_edge v0 v1"});
  expect(mesh, {2, 1, 0, 0, 1, 0, 0, 1, 0});
  apply_lines(mesh, {"make_vertex 3,1,0"});
  expect(mesh, {3, 1, 0, 0, 1, 1, 0, 2, 0});
  apply_lines(mesh, {"make_edge v1 v2"});
  expect(mesh, {3, 2, 0, 0, 1, 0, 0, 1, 0});
  apply_lines(mesh, {"make_edge v2 v0"});
  expect(mesh, {3, 3, 0, 0, 2, 0, 0, 1, 0});
  apply_lines(mesh, {"make_loop 0-1"});
  expect(mesh, {3, 3, 1, 1, 0, 0, 0, 1, 0});
  // One that hangs on a boundary is part of the walk along it.
  apply_lines(mesh, {"make_vertex 5,5,5", "make_edge v0 v3"});
  expect(mesh, {4, 4, 1, 1, 0, 0, 0, 1, 0});
  EXPECT_EQ(kernel_sum(mesh).boundaries, 1);
}

TEST(euler_poincare, a_wire_parts_the_walk_along_a_boundary_or_makes_one_walk_of_two) {
  Mesh mesh = make_mesh({{0, 1, 2, 3}, {4, 5, 6}});
  expect(mesh, {7, 7, 2, 2, 0, 0, 0, 2, 0});
  apply_lines(mesh, {"make_edge v0 v2"});
  expect(mesh, {7, 8, 2, 2, 1, 0, 0, 2, 0});
  EXPECT_EQ(kernel_sum(mesh).boundaries, 3);
  apply_lines(mesh, {"make_edge v1 v4"});
  expect(mesh, {7, 9, 2, 2, 0, 0, 0, 1, 0});
  EXPECT_EQ(kernel_sum(mesh).boundaries, 2);
}

TEST(euler_poincare, a_wire_between_two_walks_of_one_part_is_a_handle) {
  // The cube without top and bottom has two boundary loops; a wire between them makes a handle.
  Mesh mesh = make_mesh({{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  expect(mesh, {8, 12, 4, 2, 0, 0, 0, 1, 0});
  apply_lines(mesh, {"make_edge v0 v6"});
  expect(mesh, {8, 13, 4, 2, -1, 0, 0, 1, 1});
}

TEST(euler_poincare, a_bridge_is_an_edge_until_make_ring_takes_it) {
  Mesh mesh = mesh_of_exercise("cube_with_hole");
  const ProblemSets sets(mesh);
  EXPECT_EQ(sets.count(ProblemKind::ring), 2u);
  const Face f(sets.of(ProblemKind::ring).nth(0));
  const Halfedge outer = mesh.halfedge(f), ring = mesh.ring(mesh.first_ring(f)).halfedge;
  const UniteRing op{mesh.prev(outer), mesh.prev(ring)};
  ASSERT_TRUE(op.check(mesh).legal());
  {
    Edit edit(mesh, nullptr);
    op.apply(edit);
    edit.commit();
  }
  expect(mesh, {16, 25, 10, 0, 0, 0, 1, 1, 1});
  // The list of problems says the same of the open mesh; the figures are those of the file that it is written to.
  const ProblemSets after(mesh);
  EXPECT_EQ(after.count(ProblemKind::ring), 1u);
  EXPECT_EQ(compute_figures(mesh).rings, 2u);
  EXPECT_EQ(compute_figures(mesh).edges, 24u);
  expect(from_indexed(to_indexed(mesh).mesh), {16, 24, 10, 0, 0, 0, 2, 1, 1});
}

}  // namespace
}  // namespace ryosen
