#include "ryosen/algo/repair/rims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "ryosen/geometry/single_precision.h"
#include "tests/support/core/open_shapes.h"

namespace ryosen::test {
namespace {

using Places = std::vector<glm::dvec3>;

// The upper rim of a tube.
Places rim_of(const IndexedMesh& list) {
  return {list.positions.begin() + static_cast<std::ptrdiff_t>(list.positions.size() / 2), list.positions.end()};
}

double largest(const Places& places) {
  double most = 0;
  for (const glm::dvec3& p : places) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most;
}

std::optional<RimPlane> plane_of(const Places& rim) { return RimPlane::of(rim, largest(rim)); }

Places moved(Places places, const glm::dvec3& by, double scale) {
  for (glm::dvec3& p : places) p = p * scale + by;
  return places;
}

TEST(rim_plane, is_found_for_rims_that_were_turned_and_rounded) {
  for (std::uint32_t corners = 3; corners <= 48; ++corners)
    for (const double radius : {0.3, 1.0, 2.5}) {
      SCOPED_TRACE(std::to_string(corners) + " corners, radius " + std::to_string(radius));
      const IndexedMesh list = turned(tube(corners, radius, 1));
      EXPECT_TRUE(plane_of(rim_of(list)));
      EXPECT_TRUE(plane_of(rim_of(as_floats(list))));
      const Places far = moved(rim_of(list), {1000, -3e4, 70}, 1);
      EXPECT_TRUE(plane_of(far));
      Places far_floats = far;
      for (glm::dvec3& p : far_floats) p = to_single(p);
      EXPECT_TRUE(plane_of(far_floats));
    }
}

TEST(rim_plane, is_found_where_the_mean_of_many_equal_coordinates_is_rounded) {
  for (const std::uint32_t corners : {310u, 5000u}) EXPECT_TRUE(plane_of(moved(rim_of(tube(corners, 1, 0.7)), {}, 3)));
}

TEST(rim_plane, is_found_at_any_scale) {
  for (const double scale : {1e-300, 1e-20, 1e20, 1e300})
    EXPECT_TRUE(plane_of(moved(rim_of(turned(tube(9, 1, 1))), glm::dvec3(0.0), scale))) << scale;
}

// Every other corner is lifted and lowered by so many units in the last place of 1.
Places zigzag(double units, double unit) {
  Places rim;
  for (const auto& [x, y] : {std::pair(1.0, 0.0), {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}})
    rim.push_back({x, y, (rim.size() % 2 == 0 ? units : -units) * unit});
  return rim;
}

TEST(rim_plane, allows_four_units_in_the_last_place) {
  EXPECT_TRUE(plane_of(zigzag(4, 0x1p-23)));
  EXPECT_FALSE(plane_of(zigzag(5, 0x1p-23)));
  const auto in_doubles = [](double units) {
    Places rim = zigzag(units, 0x1p-52);
    rim.push_back({0.9, -0.1, 0});  // no float
    return rim;
  };
  EXPECT_TRUE(plane_of(in_doubles(3)));
  EXPECT_FALSE(plane_of(in_doubles(6)));
  EXPECT_TRUE(RimPlane::of(in_doubles(6), 2)) << "the largest coordinate of the mesh counts";
}

// Floats as a text holds them, with so many digits.
Places printed(Places places, int digits) {
  for (glm::dvec3& p : places)
    for (int axis = 0; axis < 3; ++axis) {
      char text[40];
      std::snprintf(text, sizeof text, "%.*g", digits, to_single(p[axis]));
      p[axis] = std::strtod(text, nullptr);
    }
  return places;
}

TEST(rim_plane, is_that_of_floats_where_they_were_printed) {
  for (std::uint32_t corners = 5; corners <= 48; ++corners)
    for (const int digits : {8, 9, 12, 17}) {
      const Places rim = printed(rim_of(turned(tube(corners, 1.3, 1))), digits);
      EXPECT_TRUE(plane_of(rim)) << corners << " corners, " << digits << " digits";
    }
}

TEST(rim_plane, of_a_few_decimals_is_that_of_doubles) {
  Places rim{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  EXPECT_TRUE(plane_of(rim));
  rim[2].z = 1.0000001;
  EXPECT_FALSE(plane_of(rim)) << "a decimal of a float, but the rest are whole numbers";
}

TEST(rim_plane, does_not_exist_for_rims_without_area) {
  EXPECT_FALSE(plane_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));
  EXPECT_FALSE(plane_of({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
  EXPECT_FALSE(plane_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
}

TEST(rim_plane, keeps_a_coordinate_that_all_corners_share_to_the_bit) {
  for (int axis = 0; axis < 3; ++axis) {
    Places rim = rim_of(tube(7, 1.7, 0));
    for (glm::dvec3& p : rim) {
      std::swap(p.z, p[axis]);
      p[axis] = 0.1;
    }
    const auto plane = plane_of(rim);
    ASSERT_TRUE(plane);
    for (const double x : {-0.3, 0.0, 0.4}) EXPECT_EQ(plane->nearest({x, 0.1 - x, x * x})[axis], 0.1);
  }
}

TEST(rim_plane, gives_places_within_its_tolerance) {
  for (const bool is_single : {false, true}) {
    const IndexedMesh list = turned(tube(24, 1.3, 2));
    const Places rim = rim_of(is_single ? as_floats(list) : list);
    const auto plane = plane_of(rim);
    ASSERT_TRUE(plane);
    const double unit = std::ldexp(is_single ? 0x1p-23 : 0x1p-52, std::ilogb(largest(rim)));
    for (std::size_t i = 0; i + 12 < rim.size(); ++i) {
      const glm::dvec3 p = plane->nearest(0.3 * rim[i] + 0.2 * rim[i + 7] + 0.5 * rim[i + 12] + glm::dvec3(1e-3));
      const glm::dvec3 normal = glm::normalize(glm::cross(rim[8] - rim[0], rim[16] - rim[0]));
      EXPECT_LE(std::abs(glm::dot(normal, p - rim[0])), 5 * unit) << "of the plane through three rounded corners";
      if (is_single) {
        EXPECT_EQ(p, to_single(p));
      }
    }
  }
}

}  // namespace
}  // namespace ryosen::test
