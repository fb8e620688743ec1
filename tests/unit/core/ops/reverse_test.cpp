#include "ryosen/ops/reverse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(reverse, turns_the_component_and_no_other) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}, {4, 5, 6}}, 8);
  EXPECT_EQ(apply_and_prove(mesh, "reverse f1"), Change());
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 2, 1}, {1, 3, 0}, {4, 5, 6}})) << "first corners stay";
  apply_and_prove(mesh, "reverse f0");
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 2}, {1, 0, 3}, {4, 5, 6}}));
}

TEST(reverse, cut_edges_stay_cut_and_join_components) {
  Mesh mesh = make_mesh(fin());
  const Figures before = compute_figures(mesh);
  apply_and_prove(mesh, "reverse f2");
  EXPECT_EQ(polygons_of(mesh)[0].size(), 3u);
  EXPECT_EQ(compute_figures(mesh), before);
  for (const auto& face : point_polygons(mesh)) {
    const auto old = point_polygons(make_mesh(fin()));
    EXPECT_EQ(std::count(old.begin(), old.end(), face), 0);
  }
}

TEST(reverse, fans_at_one_vertex_part_where_one_turns) {
  Mesh mesh = make_mesh({{0, 1, 2}}, 5);
  apply_and_prove(mesh, "make_face 0 3 4");
  ASSERT_FALSE(has_copies(mesh, Vertex(0)));
  apply_and_prove(mesh, "reverse f1");
  EXPECT_EQ(point_polygons(mesh), (Polygons{{0, 1, 2}, {0, 4, 3}}));
}

TEST(reverse, wires_and_isolated_vertices_stay) {
  Mesh mesh = make_mesh({{0, 1, 2, 3}}, 8);
  for (const char* line : {"make_edge 0 4", "make_edge 4 2", "make_edge 5 6"}) apply_and_prove(mesh, line);
  const KernelSum before = kernel_sum(mesh);
  EXPECT_EQ(apply_and_prove(mesh, "reverse f0"), Change());
  EXPECT_EQ(kernel_sum(mesh), before);
  for (const char* name : {"0-4", "4-2", "5-6"}) EXPECT_TRUE(find_edge(mesh, name).ok()) << name;
  EXPECT_TRUE(mesh.is_isolated(Vertex(7)));
}

TEST(reverse, rings_turn_with_their_faces) {
  for (const char* name : {"cube_with_hole", "cube_with_two_holes"}) {
    Mesh mesh = mesh_of_exercise(name);
    const MeshColumns columns = mesh.columns();
    const Figures before = compute_figures(mesh);
    EXPECT_EQ(apply_and_prove(mesh, "reverse f0"), Change());
    Figures after = compute_figures(mesh);
    EXPECT_NEAR(after.volume.value(), -before.volume.value(), 1e-12);
    after.volume = before.volume;
    EXPECT_EQ(after, before);
    apply_and_prove(mesh, "reverse f0");
    EXPECT_EQ(mesh.hash(), Mesh(columns).hash());
  }
}

TEST(reverse, bridges_turn_with_their_face) {
  Mesh mesh = mesh_of_exercise("cube_with_hole");
  const ParsedOp bridge = parse_line(mesh, "unite_ring 0 8");
  ASSERT_TRUE(bridge.op) << bridge.sentence.en;
  apply_and_prove(mesh, *bridge.op);
  EXPECT_EQ(apply_and_prove(mesh, "reverse f0"), Change());
  EXPECT_EQ(rules_against(mesh, "make_ring 0-8"), "");
}

TEST(reverse, corner_values_stay_with_their_corners) {
  IndexedMesh source = indexed({{0, 1, 2}, {2, 1, 3}});
  source.texcoords.pool = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 5, 0}};
  source.texcoords.index = {0, 1, 2, 4, 1, 3};
  source.materials.names = {"a", "b"};
  source.materials.index = {0, 1};
  Mesh mesh = from_indexed(std::move(source));
  const auto values = [&] {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> found;
    const CornerAttribute attribute = corner_attributes(mesh)[0];
    for (std::uint32_t f = 0; f < 2; ++f)
      for (Halfedge h : halfedges_around(mesh, Face(f)))
        found[{f, mesh.from(h).index}] = mesh.attributes()[attribute.index_column].data[h.index];
    return found;
  };
  const auto before = values();
  const std::vector<std::uint32_t> materials =
      mesh.attributes()[static_cast<std::size_t>(mesh.find_attribute(attribute_names::material))].data;
  apply_and_prove(mesh, "reverse f0");
  EXPECT_EQ(values(), before);
  EXPECT_EQ(mesh.attributes()[static_cast<std::size_t>(mesh.find_attribute(attribute_names::material))].data,
            materials);
}

TEST(reverse, turns_each_component_once_whichever_of_its_faces_are_named) {
  const Polygons parts{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  Mesh mesh = make_mesh(parts);
  const Mesh before = make_mesh(parts);
  apply_and_prove(mesh, "reverse f0 f1 f3");
  Mesh apart = make_mesh(parts);
  apply_and_prove(apart, "reverse f0");
  apply_and_prove(apart, "reverse f3");
  EXPECT_EQ(mesh.hash(), apart.hash());
  EXPECT_NE(mesh.hash(), before.hash());
}

TEST(reverse, parse_errors) {
  Mesh mesh = make_mesh(bow_tie());
  EXPECT_EQ(parse_error(mesh, "reverse"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "reverse 0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "reverse f0 v1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "reverse f7"), NameError::never_existed);
  apply_and_prove(mesh, "delete f0");
  EXPECT_EQ(parse_error(mesh, "reverse f0"), NameError::deleted);
  EXPECT_TRUE((Reverse{{Face(0)}}.check(mesh).has(Rule::deleted)));
}

}  // namespace
}  // namespace ryosen
