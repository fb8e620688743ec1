#include "ryosen/geometry/trees/primitive.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>
#include <vector>

namespace ryosen {
namespace {

using glm::dvec3;

TEST(nearest, face_side_and_corner_of_a_triangle) {
  const std::vector<dvec3> p = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const Primitive triangle = Primitive::triangle(0, 1, 2, 0);
  EXPECT_EQ(nearest_place(p, triangle, {0.5, 0.5, 3}).place, dvec3(0.5, 0.5, 0));
  EXPECT_EQ(nearest_place(p, triangle, {0.5, 0.5, 3}).distance, 3.0);
  EXPECT_EQ(nearest_place(p, triangle, {1, -2, 0}).place, dvec3(1, 0, 0));
  EXPECT_EQ(nearest_place(p, triangle, {1, -2, 0}).barycentric, dvec3(0.5, 0.5, 0));
  EXPECT_EQ(nearest_place(p, triangle, {5, -1, 1}).place, dvec3(2, 0, 0));
  EXPECT_EQ(nearest_place(p, triangle, {-1, 1, 0}).barycentric, dvec3(0.5, 0, 0.5));
}

TEST(nearest, segments_points_and_flat_triangles) {
  const std::vector<dvec3> p = {{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(nearest_place(p, Primitive::segment(0, 1, 0), {3, 4, 0}).place, dvec3(3, 0, 0));
  EXPECT_EQ(nearest_place(p, Primitive::segment(0, 1, 0), {9, 0, 0}).place, dvec3(4, 0, 0));
  EXPECT_EQ(nearest_place(p, Primitive::segment(0, 0, 0), {3, 4, 0}).distance, 5.0);
  EXPECT_EQ(nearest_place(p, Primitive::point(1), {4, 2, 0}).distance, 2.0);
  EXPECT_EQ(nearest_place(p, Primitive::triangle(0, 2, 1, 0), {3, 4, 0}).place, dvec3(3, 0, 0));
}

TEST(nearest, no_place_of_a_random_triangle_is_nearer) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  for (int round = 0; round < 500; ++round) {
    const std::vector<dvec3> p = {vector(), vector(), vector()};
    const dvec3 point = vector() * 2.0;
    const NearestPlace found = nearest_place(p, Primitive::triangle(0, 1, 2, 0), point);
    const dvec3 w = found.barycentric;
    EXPECT_NEAR(glm::distance(w.x * p[0] + w.y * p[1] + w.z * p[2], found.place), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(found.place, point), found.distance, 1e-12);
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; i + j <= 20; ++j) {
        const dvec3 other = (p[0] * (1.0 * i) + p[1] * (1.0 * j) + p[2] * (20.0 - i - j)) / 20.0;
        EXPECT_GE(glm::distance(other, point), found.distance - 1e-12);
      }
    }
  }
}

// Needles from a tenth to a 1e-17th as high as long, in five turns: points off, over and along them.
TEST(nearest, no_place_of_a_needle_is_nearer) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto direction = [&] { return glm::normalize(dvec3(unit(random), unit(random), unit(random))); };
  for (int turn = 0; turn < 5; ++turn) {
    const dvec3 along = direction(), across = glm::normalize(glm::cross(along, direction())), from = direction();
    for (double height = 0.1; height > 1e-17; height /= 3)
      for (const double at : {0.0, 0.3, 0.5, 1.0, 1.2}) {
        const std::vector<dvec3> p = {from, from + along, from + at * along + height * across};
        for (int i = 0; i < 20; ++i) {
          const dvec3 point = from + 1.5 * unit(random) * along + (i % 4 == 0 ? 0.0 : 0.1 * height) * direction();
          const NearestPlace found = nearest_place(p, Primitive::triangle(0, 1, 2, 0), point);
          for (int k = 0; k <= 1000; ++k) {
            const dvec3 other = p[0] + k / 1000.0 * (p[1] - p[0]);
            ASSERT_GE(glm::distance(other, point), found.distance - 1e-12) << height << " " << at << " " << i;
          }
          EXPECT_NEAR(glm::distance(found.place, point), found.distance, 1e-12);
        }
      }
  }
}

}  // namespace
}  // namespace ryosen
