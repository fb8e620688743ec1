#include "ryosen/analysis/components.h"

#include <gtest/gtest.h>

#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

FaceComponents components_of(const Mesh& mesh) {
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  return find_face_components(around);
}

bool orientable(const Polygons& faces) {
  const Mesh mesh = make_mesh(faces);
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  return is_orientable(around);
}

TEST(components, are_numbered_by_their_lowest_face) {
  const FaceComponents c = components_of(make_mesh({{0, 1, 2}, {5, 6, 7}, {2, 1, 3}, {7, 6, 8}, {9, 10, 11}}));
  EXPECT_EQ(c.count, 3u);
  EXPECT_EQ(c.of_face, (std::vector<std::uint32_t>{0, 1, 0, 1, 2}));
}

TEST(components, are_joined_by_edges_whatever_their_sheets_and_not_by_points) {
  EXPECT_EQ(components_of(make_mesh(fin())).count, 1u);
  EXPECT_EQ(components_of(make_mesh({{0, 1, 2}, {0, 1, 3}})).count, 1u);
  EXPECT_EQ(components_of(make_mesh(two_tetrahedra_on_an_edge())).count, 1u);
  EXPECT_EQ(components_of(make_mesh(bow_tie())).count, 2u);
}

TEST(components, leave_out_dead_face_numbers) {
  IndexedMesh source = indexed({{0, 1, 2}, {}, {0, 2, 3}});
  source.quarantine.emplace_back();
  source.quarantine[0].face = 1;
  const Mesh mesh = from_indexed(std::move(source));
  EXPECT_EQ(components_of(mesh).of_face, (std::vector<std::uint32_t>{0, no_index, 0}));
  Neighbourhood around(mesh);
  EXPECT_EQ(count_face_components(around), 1u);
}

TEST(components, can_be_oriented_or_not) {
  EXPECT_TRUE(orientable(cube()));
  EXPECT_FALSE(orientable(moebius_strip()));
  EXPECT_TRUE(orientable({{0, 1, 2}, {0, 1, 3}}));
  // A ring of three quads, one of them turned: two misoriented edges, but turning one face makes all agree.
  EXPECT_TRUE(orientable({{0, 1, 4, 3}, {1, 4, 5, 2}, {2, 0, 3, 5}}));
  EXPECT_TRUE(orientable(fin())) << "only edges with two faces ask for agreement";
}

}  // namespace
}  // namespace ryosen
