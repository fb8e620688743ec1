#include "ryosen/ops/poke.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/io/formats.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/preview/remedy.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(poke, a_face_becomes_triangles_around_its_mean) {
  Mesh mesh = make_mesh(two_quads());
  const glm::dvec3 mean =
      (mesh.position(Vertex(0)) + mesh.position(Vertex(1)) + mesh.position(Vertex(2)) + mesh.position(Vertex(3))) / 4.0;
  EXPECT_EQ(apply_and_prove(mesh, "poke f0"), (Change{.v = 1, .e = 4, .f = 3}));
  EXPECT_EQ(polygons_of(mesh), (Polygons{{0, 1, 6}, {1, 0, 4, 5}, {1, 2, 6}, {2, 3, 6}, {3, 0, 6}}));
  EXPECT_NEAR(glm::length(mesh.position(Vertex(6)) - mean), 0, 1e-12);
}

TEST(poke, a_place_can_be_chosen) {
  Mesh mesh = make_mesh({{0, 1, 2}});
  EXPECT_EQ(apply_and_prove(mesh, "poke f0 1,2,-3"), (Change{.v = 1, .e = 3, .f = 2}));
  EXPECT_EQ(mesh.position(Vertex(3)), glm::dvec3(1, 2, -3));
}

TEST(poke, closed_open_and_cut_surfaces_keep_their_terms) {
  for (const Polygons& faces :
       {tetrahedron(), cube(), torus_grid(3, 3), bow_tie(), fin(), moebius_strip(), two_tetrahedra_on_an_edge()}) {
    Mesh mesh = make_mesh(faces);
    const auto n = static_cast<std::int64_t>(faces[0].size());
    EXPECT_EQ(apply_and_prove(mesh, "poke f0"), (Change{.v = 1, .e = n, .f = n - 1}));
  }
}

TEST(poke, dissolving_the_centre_takes_it_back) {
  for (const Polygons& faces : {cube(), two_quads(), fin(), torus_grid(3, 3), moebius_strip()}) {
    Mesh mesh = make_mesh(faces);
    const Polygons before = point_polygons(mesh);
    const std::string centre = "v" + std::to_string(mesh.vertex_slots());
    apply_and_prove(mesh, "poke f1");
    apply_and_prove(mesh, "dissolve " + centre);
    EXPECT_EQ(point_polygons(mesh), before);
    EXPECT_TRUE(mesh.is_alive(Face(1)));
  }
}

TEST(poke, corner_values_are_kept_and_their_mean_is_at_the_centre) {
  Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/tests/data/io/everything.obj");
  ASSERT_TRUE(file);
  Mesh mesh = from_indexed(std::move(file->mesh));
  ASSERT_GE(mesh.find_attribute(attribute_names::texcoord), 0);
  const auto values = [&](Face f) {
    std::vector<std::optional<glm::dvec3>> found;
    const CornerAttribute at = corner_attributes(mesh)[0];
    for (Halfedge h : halfedges_around(mesh, f)) {
      const std::uint32_t index = mesh.attributes()[at.index_column].data[h.index];
      found.push_back(index == no_index
                          ? std::nullopt
                          : std::optional(attribute_value<glm::dvec3>(mesh.attributes()[at.pool_column], index)));
    }
    return found;
  };
  const auto face_words = [&](Face f) {
    std::vector<std::uint32_t> words;
    for (const AttributeColumn& column : mesh.attributes())
      if (column.element == ElementKind::face) words.push_back(column.data[f.index * column.words()]);
    return words;
  };
  bool compared = false;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i)) || !check(mesh, Poke{Face(i)}).legal()) continue;
    const auto before = values(Face(i));
    if (!std::all_of(before.begin(), before.end(), [](const auto& v) { return v.has_value(); })) continue;
    glm::dvec3 mean{};
    for (const auto& v : before) mean += *v / static_cast<double>(before.size());
    const std::uint32_t fresh = mesh.face_slots();
    apply_and_prove(mesh, Poke{Face(i)});
    const auto first = values(Face(i)), second = values(Face(fresh));
    EXPECT_EQ(first[0], before[0]);
    EXPECT_EQ(first[1], before[1]);
    EXPECT_EQ(second[0], before[1]);
    EXPECT_NEAR(glm::length(*first[2] - mean), 0, 1e-12);
    EXPECT_EQ(first[2], second[2]);
    EXPECT_EQ(face_words(Face(fresh)), face_words(Face(i)));
    compared = true;
    break;
  }
  EXPECT_TRUE(compared);
}

TEST(poke, a_face_with_a_ring_is_refused_until_it_is_triangulated) {
  IndexedMesh source = indexed({{0, 1, 2, 3, 0, 4, 6, 5, 4}});
  source.positions = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 3, 0}, {5, 3, 0}, {3, 5, 0}};
  Mesh bridged = from_indexed(std::move(source));
  for (const char* line : {"", "make_ring 0-4"}) {
    Mesh mesh = bridged;
    if (*line) apply_and_prove(mesh, line);
    EXPECT_EQ(rules_against(mesh, "poke f0"), "has_rings");
    const MeshColumns before = mesh.columns();
    const std::vector<std::string> remedy = find_remedy(mesh, Poke{Face(0)});
    EXPECT_EQ(mesh.columns(), before);
    ASSERT_FALSE(remedy.empty());
    for (const std::string& step : remedy) apply_and_prove(mesh, step);
    EXPECT_EQ(rules_against(mesh, "poke f0"), "");
  }
}

TEST(poke, one_of_two_faces_on_the_same_points_is_refused) {
  const Mesh mesh = make_mesh({{0, 1, 2}, {0, 2, 1}});
  EXPECT_EQ(rules_against(mesh, "poke f0"), "loses_duplicate");
  EXPECT_EQ(check(mesh, Poke{Face(0)}).reasons[0].witnesses, (std::vector<Element>{Face(0), Face(1)}));
}

TEST(poke, lines_that_say_no_operator) {
  Mesh mesh = make_mesh({{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(parse_error(mesh, "poke"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "poke f0 1,2"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "poke f0 nan,0,0"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "poke f0 0,0,0 1"), NameError::malformed);
  EXPECT_EQ(parse_error(mesh, "poke f9"), NameError::never_existed);
  apply_and_prove(mesh, "delete f1");
  EXPECT_EQ(parse_error(mesh, "poke f1"), NameError::deleted);
  EXPECT_TRUE(check(mesh, Poke{Face(1)}).has(Rule::deleted));
}

TEST(poke, warns_where_a_triangle_would_turn_over_or_lie_flat) {
  IndexedMesh source = indexed({{0, 1, 2}});
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Mesh mesh = from_indexed(std::move(source));
  EXPECT_TRUE(warnings(mesh, op_of(mesh, "poke f0")).empty());
  EXPECT_EQ(warnings(mesh, op_of(mesh, "poke f0 5,5,0"))[0].rule, Rule::normal_turns);
  EXPECT_EQ(warnings(mesh, op_of(mesh, "poke f0 0.5,0,0"))[0].rule, Rule::degenerate);
}

TEST(poke, a_corner_without_a_finite_place_is_left_out_of_the_mean) {
  IndexedMesh source = indexed({{0, 1, 2}});
  source.positions = {{0, 0, 0}, {2, 0, 0}, {0, std::nan(""), 0}};
  Mesh mesh = from_indexed(std::move(source));
  EXPECT_EQ(Poke{Face(0)}.position(mesh), glm::dvec3(1, 0, 0));
}

}  // namespace
}  // namespace ryosen
