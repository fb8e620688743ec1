#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/transform/moved_points.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

double unit(Dice& dice) { return 2 * dice.unit() - 1; }
glm::dvec3 random_place(Dice& dice) { return {unit(dice), unit(dice), unit(dice)}; }

TEST(point_transform, turns_as_its_definition_says) {
  Dice dice(3);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 axis = *direction_of(random_place(dice)), about = random_place(dice), p = random_place(dice);
    const double angle = 720 * unit(dice);
    const PointTransform turn{.kind = PointTransform::Kind::turn, .angle_deg = angle, .axis = axis, .about = about};
    const glm::dvec3 q = turn(p);
    EXPECT_NEAR(glm::distance(q, about), glm::distance(p, about), 1e-12);
    EXPECT_NEAR(glm::dot(q - p, axis), 0, 1e-12) << "in a plane across the axis";
    const glm::dvec3 a = p - about - glm::dot(p - about, axis) * axis, b = q - about - glm::dot(q - about, axis) * axis;
    EXPECT_NEAR(glm::dot(a, b), glm::dot(a, a) * std::cos(angle * std::numbers::pi / 180), 1e-10);
    EXPECT_NEAR(glm::dot(glm::cross(a, b), axis), glm::dot(a, a) * std::sin(angle * std::numbers::pi / 180), 1e-10);
  }
  const PointTransform quarter{.kind = PointTransform::Kind::turn, .angle_deg = 90, .axis = glm::dvec3(0, 0, 1)};
  EXPECT_EQ(quarter({3, 1, 2}), glm::dvec3(-1, 3, 2)) << "exactly";
  EXPECT_FALSE(direction_of({0, 0, 0}));
}

// A surface that is pressed flat lies in one plane, whatever rounding does elsewhere.
TEST(point_transform, scales_by_nothing_exactly) {
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0}) {
      glm::dvec3 axis(0);
      axis[i] = sign;
      const PointTransform flat{
          .kind = PointTransform::Kind::scale, .factor = 0, .axis = axis, .about = {0.3, 0.123, 0.0077}};
      for (const glm::dvec3 place : {glm::dvec3(0.1, 0.7, 1e-9), glm::dvec3(1e5, -3.3, 1.0 / 3)}) {
        glm::dvec3 wanted = place;
        wanted[i] = flat.about[i];
        EXPECT_EQ(flat(place), wanted) << i;
      }
    }
  const PointTransform point{.kind = PointTransform::Kind::scale, .factor = 0, .axis = {}, .about = {0.3, 0.1, 0.7}};
  EXPECT_EQ(point({1.0 / 3, 2, 1e-7}), point.about);
}

TEST(point_transform, scales_along_an_axis_or_everywhere) {
  const PointTransform all{.kind = PointTransform::Kind::scale, .factor = 3, .axis = {}, .about = {1, 1, 1}};
  EXPECT_EQ(all({2, 1, 0}), glm::dvec3(4, 1, -2));
  const PointTransform along{.kind = PointTransform::Kind::scale, .factor = 3, .axis = glm::dvec3(0, 0, 1)};
  EXPECT_EQ(along({2, 1, 4}), glm::dvec3(2, 1, 12));
  EXPECT_EQ(along({2, 1, 4}, 0.5), glm::dvec3(2, 1, 8));
}

// Against all pairs of points.
TEST(moved_points, falloff_is_by_the_distance_to_the_nearest_point_that_is_moved_whole) {
  Dice dice(7);
  Mesh mesh = make_mesh(torus_grid(6, 9));
  Edit(mesh, nullptr).commit();
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    Edit edit(mesh, nullptr);
    edit.set_position(Vertex(i), random_place(dice));
    edit.commit();
  }
  const std::vector<Vertex> whole{Vertex(4), Vertex(20), Vertex(33)};
  const double radius = 0.8;
  std::map<std::uint32_t, double> shares;
  for (const MovedPoint& each : moved_points(mesh, whole, radius)) shares[each.point.index] = each.share;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    double nearest = 1e9;
    for (const Vertex v : whole) nearest = std::min(nearest, glm::distance(mesh.position(v), mesh.position(Vertex(i))));
    ASSERT_EQ(shares.contains(i), nearest < radius) << i;
    if (nearest >= radius) continue;
    EXPECT_NEAR(shares[i], std::pow(1 - nearest * nearest / (radius * radius), 2), 1e-12);
  }
  EXPECT_EQ(shares[20], 1.0);
  EXPECT_EQ(moved_points(mesh, whole, 0).size(), 3u);
}

TEST(transforms, move_all_copies_of_a_point_and_nothing_else) {
  Mesh mesh = make_mesh(bow_tie());
  const Mesh before = mesh;
  Vertex copied;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (has_copies(mesh, Vertex(i))) copied = point(mesh, Vertex(i));
  ASSERT_TRUE(copied);
  const AlgorithmRow& row = *find_algorithm("translate");
  ParameterValues values(row.parameters);
  ASSERT_FALSE(values.set("by", "1,2,3", "by"));
  ASSERT_FALSE(values.set("elements", "v" + std::to_string(copied.index), "elements"));
  Journal journal;
  {
    Edit edit(mesh, &journal);
    Progress progress;
    const AlgorithmResult result = row.run(edit, {.values = *values.on(mesh).values}, progress);
    EXPECT_EQ(result.changed, 1u);
    edit.commit();
  }
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const bool is_moved = point(mesh, Vertex(i)) == copied;
    EXPECT_EQ(mesh.position(Vertex(i)), before.position(Vertex(i)) + (is_moved ? glm::dvec3(1, 2, 3) : glm::dvec3(0)));
  }
  journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), before.columns());
}

}  // namespace
}  // namespace ryosen
