#include "ryosen/ops/separate_fans.h"

#include <gtest/gtest.h>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Mesh three_fans_at_one_vertex() {
  Mesh mesh = make_mesh({{0, 1, 2}}, 9);
  for (const char* line : {"make_face 0 3 4", "make_face 0 5 6", "make_edge 0 7 5-0"}) apply_and_prove(mesh, line);
  return mesh;
}

TEST(separate_fans, one_copy_per_fan_with_equal_figures) {
  Mesh mesh = three_fans_at_one_vertex();
  const Figures before = compute_figures(mesh);
  const ElementCounts points = counts_on_points(mesh);
  EXPECT_EQ(apply_and_prove(mesh, "separate_fans v0"), (Change{.v = 2, .s = 2, .b = 2}));
  EXPECT_EQ(compute_figures(mesh), before);
  EXPECT_EQ(counts_on_points(mesh), points);
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 2}, {9, 3, 4}, {10, 5, 6}})) << "the lowest face keeps the vertex";
  EXPECT_TRUE(mesh.is_alive(find_edge(mesh, "0-7").element));
}

TEST(separate_fans, weld_brings_the_fans_back_to_one_vertex) {
  Mesh mesh = three_fans_at_one_vertex();
  apply_and_prove(mesh, "separate_fans v0");
  EXPECT_EQ(apply_and_prove(mesh, "weld v0@f0 v0@f1"), (Change{.v = -1, .s = -1, .b = -1}));
  EXPECT_EQ(apply_and_prove(mesh, "weld v0@f2 v0@f0"), (Change{.v = -1, .s = -1, .b = -1}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 2}, {0, 3, 4}, {0, 5, 6}}));
  EXPECT_FALSE(has_copies(mesh, Vertex(0)));
}

TEST(separate_fans, colours_go_along) {
  IndexedMesh source = indexed({{0, 1, 2}}, 5);
  for (double red : {0.1, 0.2, 0.3, 0.4, 0.5}) source.vertex_colours.push_back({red, 0, 0, 1});
  Mesh mesh = from_indexed(std::move(source));
  apply_and_prove(mesh, "make_face 0 3 4");
  apply_and_prove(mesh, "separate_fans v0");
  const AttributeColumn& colours = mesh.attributes()[0];
  for (std::uint32_t word = 0; word < colours.words(); ++word)
    EXPECT_EQ(colours.data[word], colours.data[5 * colours.words() + word]);
}

TEST(separate_fans, one_fan_is_refused) {
  EXPECT_EQ(rules_against(make_mesh(closed_fan(4)), "separate_fans v0"), "one_fan");
  EXPECT_EQ(rules_against(make_mesh(bow_tie()), "separate_fans v0"), "one_fan") << "they are copies already";
  Mesh wires = make_mesh({{0, 1, 2}}, 5);
  apply_and_prove(wires, "make_edge 0 3");
  EXPECT_EQ(rules_against(wires, "separate_fans v0"), "one_fan") << "a wire is no fan";
  EXPECT_EQ(rules_against(wires, "separate_fans v4"), "one_fan");
}

TEST(separate_fans, parse_errors) {
  Mesh mesh = make_mesh(closed_fan(4));
  EXPECT_EQ(parse_error(mesh, "separate_fans"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "separate_fans f0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "separate_fans v0 v1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "separate_fans v9"), NameError::never_existed);
  apply_and_prove(mesh, "delete v1");
  EXPECT_EQ(parse_error(mesh, "separate_fans v1"), NameError::deleted);
  EXPECT_TRUE((SeparateFans{Vertex(1)}.check(mesh).has(Rule::deleted)));
}

}  // namespace
}  // namespace ryosen
