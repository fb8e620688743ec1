#include "ryosen/textbook/forms/split_3ij.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ryosen/mesh/invariants.h"
#include "ryosen/textbook/forms/opposite_array.h"
#include "ryosen/textbook/forms/opposite_map.h"
#include "tests/support/core/shapes.h"

namespace ryosen::forms {
namespace {

// Six triangles around vertex 0, each from its outer side.
Mesh hexagon() {
  IndexedMesh list;
  list.positions.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < 6; ++i) {
    const double angle = i * std::acos(-1.0) / 3;
    list.positions.push_back({std::cos(angle), std::sin(angle), 0});
    for (const std::uint32_t corner : {1 + i, 1 + (i + 1) % 6, 0u}) list.corners.push_back(corner);
    list.face_offsets.push_back(3 * i + 3);
  }
  return from_indexed(std::move(list));
}

// The opposites again, from the corners alone.
template <class Structure>
std::vector<std::uint32_t> opposites_by_search(const Structure& mesh) {
  const std::uint32_t count = 3 * mesh.face_count();
  std::vector<std::uint32_t> opposites(count, no_index);
  for (std::uint32_t h = 0; h < count; ++h)
    for (std::uint32_t g = 0; g < count; ++g)
      if (mesh.from(h) == mesh.from(mesh.next(g)) && mesh.from(g) == mesh.from(mesh.next(h))) opposites[h] = g;
  return opposites;
}

template <class Structure>
void expect_right_opposites(const Structure& mesh) {
  const std::vector<std::uint32_t> expected = opposites_by_search(mesh);
  for (std::uint32_t h = 0; h < expected.size(); ++h) EXPECT_EQ(mesh.opposite(h), expected[h]) << h;
  EXPECT_FALSE(check_invariants(mesh.to_mesh()));
}

template <class Structure>
double total_area(const Structure& mesh) {
  double area = 0;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) area += area_3ij(mesh, f);
  return area;
}

template <class Structure>
class Split3ijTest : public testing::Test {};
using Structures = testing::Types<OppositeMap, OppositeArray>;
TYPED_TEST_SUITE(Split3ijTest, Structures);

// The numbers that the text reports of its hexagon.
TYPED_TEST(Split3ijTest, hexagon_of_the_text) {
  TypeParam mesh(hexagon());
  const std::uint32_t before_2 = mesh.opposite(2), before_8 = mesh.opposite(8);
  for (std::uint32_t h = 0; h < 18; ++h) EXPECT_EQ(mesh.opposite(h) == no_index, h % 3 == 0) << h;

  split_edge_3ij(mesh, 1);
  EXPECT_EQ(mesh.face_count(), 8u);
  EXPECT_NE(mesh.opposite(2), before_2);
  EXPECT_NE(mesh.opposite(8), before_8);
  EXPECT_EQ(mesh.opposite(1), 5u);
  expect_right_opposites(mesh);

  split_edge_3ij(mesh, 4);
  EXPECT_EQ(mesh.face_count(), 10u);
  EXPECT_EQ(mesh.opposite(1), 3u);
  EXPECT_EQ(mesh.opposite(24), no_index);
  expect_right_opposites(mesh);
}

TYPED_TEST(Split3ijTest, interior_edge) {
  TypeParam mesh(test::make_mesh({{3, 0, 1}, {0, 3, 2}}));  // the halfedge 0 runs 3 -> 0
  const Split3ij split = split_3ij(mesh, 0, {7, 8, 9});
  EXPECT_EQ(split.vertex, 4u);
  EXPECT_EQ(split.face, 2u);
  EXPECT_EQ(mesh.position(4), glm::dvec3(7, 8, 9));
  const std::uint32_t corners[] = {0, 1, 4, 2, 0, 4, 1, 3, 4, 3, 2, 4};
  for (std::uint32_t h = 0; h < 12; ++h) EXPECT_EQ(mesh.corner(h), corners[h]) << h;
  expect_right_opposites(mesh);
}

TYPED_TEST(Split3ijTest, boundary_edge) {
  TypeParam mesh(test::make_mesh({{2, 0, 1}, {1, 0, 3}}));  // the halfedge 0 runs 2 -> 0
  split_3ij(mesh, 0, {0, 0, 5});
  const std::uint32_t corners[] = {0, 1, 4, 1, 0, 3, 1, 2, 4};
  ASSERT_EQ(mesh.face_count(), 3u);
  for (std::uint32_t h = 0; h < 9; ++h) EXPECT_EQ(mesh.corner(h), corners[h]) << h;
  EXPECT_EQ(mesh.opposite(0), 3u);
  EXPECT_EQ(mesh.opposite(2), no_index);
  EXPECT_EQ(mesh.opposite(7), no_index);
  expect_right_opposites(mesh);
}

TYPED_TEST(Split3ijTest, every_edge_of_closed_and_open_meshes) {
  for (const test::Polygons& faces :
       {test::tetrahedron(), test::torus_grid(3, 4), test::closed_fan(5), test::Polygons{{0, 1, 2}}})
    for (std::uint32_t h = 0; h < 3 * faces.size(); ++h) {
      TypeParam mesh(test::make_mesh(faces));
      const bool inside = mesh.opposite(h) != no_index;
      split_edge_3ij(mesh, h);
      EXPECT_EQ(mesh.face_count(), faces.size() + (inside ? 2 : 1));
      expect_right_opposites(mesh);
    }
}

TYPED_TEST(Split3ijTest, largest_face_again_and_again) {
  TypeParam mesh(hexagon());
  const double area = total_area(mesh);
  for (int round = 0; round < 10; ++round) {
    split_largest_3ij(mesh, 10);
    expect_right_opposites(mesh);
    EXPECT_NEAR(total_area(mesh), area, 1e-12);
  }
  // Halving the largest keeps all of them within a factor: 100 splits leave at least 106 faces of similar size.
  double largest = 0;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) largest = std::max(largest, area_3ij(mesh, f));
  EXPECT_GE(mesh.face_count(), 106u);
  EXPECT_LT(largest, 4 * area / mesh.face_count());
}

TEST(opposite_map, codes_the_boundary_by_its_own_number) {
  OppositeMap mesh(hexagon());
  for (int round = 0; round < 20; ++round) {
    for (std::uint32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      const auto coded = mesh.coded_opposite(h);
      if (mesh.opposite(h) == no_index)
        EXPECT_EQ(coded, -(static_cast<std::int32_t>(h) + 1));
      else
        EXPECT_EQ(mesh.coded_opposite(static_cast<std::uint32_t>(coded)), static_cast<std::int32_t>(h));
    }
    EXPECT_EQ(mesh.map_size(), 3u * mesh.face_count()) << "sides that are gone must leave the map";
    split_largest_3ij(mesh, 1);
  }
}

}  // namespace
}  // namespace ryosen::forms
