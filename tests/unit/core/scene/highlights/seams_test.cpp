#include "ryosen/scene/highlights/feature_edges.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/circulate.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// One value for each corner, as listed.
Mesh with_texcoords(const Polygons& faces, std::vector<std::uint32_t> index, bool as_normals = false) {
  IndexedMesh source = indexed(faces);
  CornerValues& values = as_normals ? source.normals : source.texcoords;
  values.pool = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  values.index = std::move(index);
  return from_indexed(std::move(source));
}

std::vector<std::string> seams_of(const Mesh& mesh) {
  std::vector<std::string> names;
  Neighbourhood around(mesh);
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i)) || !is_seam_edge(around, Edge(i))) continue;
    const auto [a, b] = ends(mesh, Edge(i));
    const Vertex p = around.point(a), q = around.point(b);
    names.push_back(std::to_string(std::min(p, q).index) + "-" + std::to_string(std::max(p, q).index));
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(seams, are_edges_at_which_values_differ_at_an_end) {
  const Polygons faces{{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(seams_of(make_mesh(faces)), Names{}) << "no values";
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, 1, 0, 2})), Names{});
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, 1, 3, 2})), Names{}) << "equal, though twice in the pool";
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, 1, 2, 2})), Names{"0-1"}) << "at 0";
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, 2, 0, 2})), Names{"0-1"}) << "at 1";
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, no_index, 0, 2})), Names{"0-1"}) << "none at 1";
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, 1, 2, 2}, true)), Names{"0-1"}) << "normals";
}

TEST(seams, of_faces_turned_against_each_other_go_by_their_ends) {
  const Polygons faces{{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, 0, 1, 2})), Names{});
  EXPECT_EQ(seams_of(with_texcoords(faces, {0, 1, 2, 1, 0, 2})), Names{"0-1"});
}

TEST(seams, are_neither_boundary_nor_nonmanifold) {
  EXPECT_EQ(seams_of(with_texcoords({{0, 1, 2}}, {0, 1, 2})), Names{});
  EXPECT_EQ(seams_of(with_texcoords(fin(), {0, 1, 2, 1, 2, 0, 2, 2, 1})), Names{});
}

}  // namespace
}  // namespace ryosen
