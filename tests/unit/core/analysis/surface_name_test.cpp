#include "ryosen/analysis/figures.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

std::string name_of_surface(const Mesh& mesh) {
  const auto name = surface_name(compute_figures(mesh));
  return name ? name->en : "";
}

TEST(surface_name, tells_surfaces_apart) {
  EXPECT_EQ(name_of_surface(asset_mesh("tetrahedron.off")), "sphere");
  EXPECT_EQ(name_of_surface(asset_mesh("torus.off")), "torus");
  EXPECT_EQ(name_of_surface(asset_mesh("two_quads.obj")), "disc");
  EXPECT_EQ(name_of_surface(asset_mesh("moebius.off")), "Möbius strip");
  EXPECT_EQ(name_of_surface(asset_mesh("klein_bottle.off")), "Klein bottle");
  EXPECT_EQ(name_of_surface(asset_mesh("projective_plane.off")), "projective plane");
  EXPECT_EQ(name_of_surface(asset_mesh("stanford_bunny.obj")), "sphere with 0 handles and 5 holes");
  EXPECT_EQ(name_of_surface(make_mesh({{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}})), "cylinder");
}

TEST(surface_name, of_faces_with_rings_counts_what_their_holes_leave) {
  EXPECT_EQ(name_of_surface(mesh_of_exercise("cube_with_hole")), "torus");
  EXPECT_EQ(name_of_surface(mesh_of_exercise("cube_with_two_holes")), "sphere with 2 handles");
}

TEST(surface_name, none_where_it_is_not_one_manifold) {
  EXPECT_EQ(name_of_surface(asset_mesh("fin.obj")), "");
  EXPECT_EQ(name_of_surface(asset_mesh("bow_tie.obj")), "");
  EXPECT_EQ(name_of_surface(make_mesh({{0, 1, 2}, {3, 4, 5}})), "");
  EXPECT_EQ(name_of_surface(Mesh()), "");
}

// Cuts one face out, so that there is a hole more, and the name changes with it.
TEST(surface_name, a_hole_in_a_projective_plane_makes_a_moebius_strip) {
  Mesh mesh = asset_mesh("projective_plane.off");
  Edit edit(mesh, nullptr);
  Delete{Face(0)}.apply(edit);
  edit.commit();
  EXPECT_EQ(name_of_surface(mesh), "Möbius strip");
}

// Every edge without a seam at it can be asked and edited, the seam itself refuses and says why.
TEST(one_sided_surfaces, orient_up_to_a_seam_and_are_edited_away_from_it) {
  for (const char* asset : {"moebius.off", "klein_bottle.off", "projective_plane.off"}) {
    SCOPED_TRACE(asset);
    Mesh mesh = asset_mesh(asset);
    const std::string name = name_of_surface(mesh);
    if (Orient{}.check(mesh).legal()) {
      Edit edit(mesh, nullptr);
      Orient{}.apply(edit);
      edit.commit();
    }
    EXPECT_TRUE(Orient{}.check(mesh).has(Rule::oriented));
    EXPECT_GT(compute_figures(mesh)[ProblemKind::misoriented_edge], 0u);
    EXPECT_EQ(name_of_surface(mesh), name);
    std::size_t split = 0, refused = 0;
    for (std::uint32_t i = 0, end = mesh.edge_slots(); i < end; ++i) {
      const Halfedge h = halfedge(Edge(i));
      if (!mesh.is_alive(h)) continue;
      if (point_edge(mesh, h).is_misoriented()) {
        EXPECT_TRUE(CollapseEdge{h}.check(mesh).has(Rule::copies) || !CollapseEdge{h}.check(mesh).legal());
        ++refused;
      } else if (SplitEdge{h}.check(mesh).legal()) {
        Edit edit(mesh, nullptr);
        SplitEdge{h}.apply(edit);
        edit.commit();
        ++split;
      }
    }
    EXPECT_GT(refused, 0u);
    EXPECT_GT(split, 5u);
    std::size_t collapsed = 0;
    for (std::uint32_t i = 0; i < mesh.edge_slots() && collapsed < 10; ++i) {
      const CollapseEdge op{halfedge(Edge(i))};
      if (!op.is_legal(mesh)) continue;
      Edit edit(mesh, nullptr);
      op.apply(edit);
      edit.commit();
      ++collapsed;
    }
    EXPECT_EQ(collapsed, 10u);
    EXPECT_FALSE(check_invariants(mesh));
    EXPECT_EQ(name_of_surface(mesh), name);
  }
}

}  // namespace
}  // namespace ryosen
