#include "ryosen/geometry/polygon_normal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace ryosen {
namespace {

using glm::dvec3;
using Polygon = std::vector<dvec3>;

void expect_near(const dvec3& actual, const dvec3& expected, double tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

TEST(polygon_normal, unit_square) {
  const Polygon square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(vector_area(square), dvec3(0, 0, 1));
  EXPECT_EQ(polygon_area(square), 1.0);
  EXPECT_EQ(polygon_normal(square), dvec3(0, 0, 1));
}

TEST(polygon_normal, concave_polygon_in_a_slanted_plane_far_away) {
  const dvec3 u = glm::normalize(dvec3(1, 2, 2)), v = glm::normalize(dvec3(2, -2, 1));
  const double shape[][2] = {{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};
  Polygon polygon;
  for (const auto& [x, y] : shape) polygon.push_back(dvec3(1e6, -2e6, 3e6) + u * x + v * y);
  EXPECT_NEAR(polygon_area(polygon), 8.0, 1e-7);
  expect_near(polygon_normal(polygon), glm::cross(u, v), 1e-8);
}

TEST(polygon_normal, sizes_whose_squares_leave_the_double_range) {
  for (const double size : {1e-320, 1e-300, 1e-170, 1e170, 1e307, 1.7e308}) {
    const Polygon triangle = {{0, 0, 0}, {0, size, 0}, {0, 0, size}};
    expect_near(polygon_normal(triangle), {1, 0, 0}, 1e-12);
  }
  const double huge = 1.7e308;
  const Polygon square = {{-huge, -huge, 0}, {huge, -huge, 0}, {huge, huge, 0}, {-huge, huge, 0}};
  expect_near(polygon_normal(square), {0, 0, 1}, 1e-12);
  EXPECT_EQ(polygon_area(square), std::numeric_limits<double>::infinity());
  const Polygon thin = {{1, 0, 0}, {1, 1e-200, 0}, {1, 0, 1e-200}};
  expect_near(polygon_normal(thin), {1, 0, 0}, 1e-12);
}

TEST(polygon_normal, flat_and_short_polygons_have_none) {
  EXPECT_EQ(polygon_normal(Polygon{}), dvec3(0));
  EXPECT_EQ(polygon_normal(Polygon{{1, 2, 3}, {4, 5, 6}}), dvec3(0));
  EXPECT_EQ(polygon_normal(Polygon{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), dvec3(0));
  EXPECT_EQ(polygon_area(Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), 0.0);
}

TEST(polygon_normal, volume_of_a_box_with_bent_faces_does_not_depend_on_the_apex) {
  // A cube with one corner pulled out: three of its quads are not planar.
  const Polygon p = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1.5, 1.5, 1.5}, {0, 1, 1}};
  const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const auto volume = [&](const dvec3& apex) {
    double sum = 0.0;
    for (const auto& face : faces) sum += polygon_volume(Polygon{p[face[0]], p[face[1]], p[face[2]], p[face[3]]}, apex);
    return sum;
  };
  EXPECT_NEAR(volume({0, 0, 0}), volume({3, -2, 5}), 1e-12);
  EXPECT_GT(volume({0, 0, 0}), 1.0);
  Polygon cube = p;
  cube[6] = {1, 1, 1};
  double sum = 0.0;
  for (const auto& face : faces) {
    sum += polygon_volume(Polygon{cube[face[0]], cube[face[1]], cube[face[2]], cube[face[3]]}, dvec3(0.3, 0.1, 7));
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

}  // namespace
}  // namespace ryosen
