#include "ryosen/geometry/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "ryosen/geometry/polygon_normal.h"
#include "tests/support/core/long_run.h"
#include "tests/unit/core/geometry/polygon_shapes.h"

namespace ryosen {
namespace {

using glm::dvec3;
using test_shapes::Polygon;
using Triangles = std::vector<CornerTriangle>;
using Loops = std::vector<Polygon>;

Triangles triangles_of(const Polygon& polygon) {
  Triangles result = {{7, 7, 7}};  // must be replaced
  triangulate(polygon, result);
  return result;
}

Triangles triangles_of(const Loops& loops) {
  std::vector<std::span<const dvec3>> spans(loops.begin(), loops.end());
  Triangles result;
  triangulate_loops(spans, result);
  return result;
}

Polygon all_corners(const Loops& loops) {
  Polygon result;
  for (const Polygon& loop : loops) result.insert(result.end(), loop.begin(), loop.end());
  return result;
}

// Every side of the loops belongs to exactly one triangle, every other triangle side to two in opposite directions.
void expect_sides_matched(const Loops& loops, const Triangles& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const CornerTriangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  std::uint32_t first = 0;
  for (const Polygon& loop : loops) {
    const auto count = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::pair side(first + i, first + (i + 1) % count);
      ASSERT_EQ(sides[side], 1) << side.first << '-' << side.second;
      sides.erase(side);
    }
    first += count;
  }
  for (const auto& [side, uses] : sides) {
    ASSERT_EQ(uses, 1);
    ASSERT_TRUE(sides.count({side.second, side.first})) << side.first << '-' << side.second;
  }
}

enum class Flat { never, allowed };

// In the xy plane: number, orientation, sides and area of a triangulation.
void expect_right(const Loops& loops, const Triangles& triangles, Flat flat) {
  const Polygon p = all_corners(loops);
  ASSERT_EQ(triangles.size() + 4, p.size() + 2 * loops.size());
  double area = 0.0;
  for (const CornerTriangle& t : triangles) {
    ASSERT_GE(test_shapes::turn(p[t[0]], p[t[1]], p[t[2]]), flat == Flat::never ? 1 : 0);
    area += test_shapes::signed_area({p[t[0]], p[t[1]], p[t[2]]});
  }
  double expected = 0.0;
  for (const Polygon& loop : loops) expected += test_shapes::signed_area(loop);
  EXPECT_NEAR(area, expected, 1e-9 * (1.0 + std::abs(expected)));
  expect_sides_matched(loops, triangles);
}

void expect_right(const Polygon& polygon, Flat flat = Flat::never) {
  expect_right({polygon}, triangles_of(polygon), flat);
}

// The xy plane put into another plane by exchanging and mirroring coordinates, which keeps them exact.
Polygon turned_by(const Polygon& polygon, int way) {
  Polygon result = polygon;
  for (dvec3& p : result) {
    if (way % 3 == 1) p = {p.y, 5.0, p.x};
    if (way % 3 == 2) p = {-7.0, p.y, p.x};
    if (way >= 3) p.x = p.x * 0.5 + 3.0;
  }
  return result;
}

TEST(triangulate, small_polygons) {
  EXPECT_TRUE(triangles_of(Polygon{}).empty());
  EXPECT_TRUE(triangles_of(Polygon{{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_EQ(triangles_of(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}}));
  expect_right(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  expect_right(test_shapes::convex(5));
  expect_right(test_shapes::convex(100));
}

TEST(triangulate, quads_take_the_shorter_or_the_inner_diagonal) {
  const Triangles across_0_2 = {{0, 1, 2}, {0, 2, 3}};
  const Triangles across_1_3 = {{0, 1, 3}, {1, 2, 3}};
  EXPECT_EQ(triangles_of(Polygon{{0, 0, 0}, {3, -1, 0}, {1, 1, 0}, {-1, 3, 0}}), across_0_2);
  EXPECT_EQ(triangles_of(Polygon{{0, 0, 0}, {2, 0, 0}, {4, 4, 0}, {0, 2, 0}}), across_1_3);
  for (std::size_t reflex = 0; reflex < 4; ++reflex) {
    Polygon dart = {{0, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}};
    std::rotate(dart.begin(), dart.begin() + static_cast<std::ptrdiff_t>(reflex), dart.end());
    expect_right(dart);
    Polygon other_side = dart;
    std::reverse(other_side.begin(), other_side.end());
    const auto inner = std::find(other_side.begin(), other_side.end(), dvec3(1, 1, 0)) - other_side.begin();
    EXPECT_EQ(triangles_of(other_side), inner % 2 == 0 ? across_0_2 : across_1_3);
    for (const CornerTriangle& t : triangles_of(other_side)) {
      EXPECT_LT(test_shapes::turn(other_side[t[0]], other_side[t[1]], other_side[t[2]]), 0);
    }
  }
  // A corner on the straight line between its neighbours must not become a flat triangle.
  expect_right(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  expect_right(Polygon{{1, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}});
}

TEST(triangulate, every_axis_and_both_sides) {
  const Polygon shape = test_shapes::comb(5, 3);
  for (int way = 0; way < 6; ++way) {
    for (const bool reversed : {false, true}) {
      Polygon polygon = turned_by(shape, way);
      if (reversed) std::reverse(polygon.begin(), polygon.end());
      const Triangles triangles = triangles_of(polygon);
      ASSERT_EQ(triangles.size(), polygon.size() - 2);
      expect_sides_matched({polygon}, triangles);
      const dvec3 normal = polygon_normal(polygon);
      double area = 0.0;
      for (const CornerTriangle& t : triangles) {
        const Polygon corners = {polygon[t[0]], polygon[t[1]], polygon[t[2]]};
        EXPECT_EQ(polygon_normal(corners), normal);
        area += polygon_area(corners);
      }
      EXPECT_NEAR(area, polygon_area(polygon), 1e-9);
    }
  }
}

TEST(triangulate, random_simple_polygons_on_a_small_grid) {
  unsigned made = 0;
  const unsigned seeds = test::is_long_run() ? 2000 : 250;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const std::size_t count = 4 + seed % 17;
    const Polygon polygon = test_shapes::random_simple(count, 4 + static_cast<int>(seed % 5), seed);
    if (polygon.empty()) continue;
    ++made;
    expect_right(polygon);
    if (::testing::Test::HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(made, seeds / 4);
}

TEST(triangulate, nasty_simple_polygons) {
  expect_right(test_shapes::star(501, 1));
  expect_right(test_shapes::spiral(1000, 7));
  expect_right(test_shapes::comb(200, 2));
  expect_right(test_shapes::saw(300));
  expect_right(test_shapes::square_with_many_corners(100));
  for (unsigned seed = 0; seed < 200; ++seed) expect_right(test_shapes::star(5 + seed, seed));
}

TEST(triangulate, corners_one_rounding_step_off_a_line) {
  // Collinear up to rounding: a filter alone takes some of these turns for the opposite ones.
  Polygon polygon;
  for (int i = 0; i <= 60; ++i) polygon.emplace_back(0.1 * i, 0.3 * i, 0.0);
  for (int i = 59; i > 0; --i) polygon.emplace_back(0.1 * i - 1e-15 * (i % 3 + 1), 0.3 * i + 1e-15, 0.0);
  if (!test_shapes::is_simple(polygon)) GTEST_SKIP() << "rounding made the strip touch itself";
  if (test_shapes::signed_area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  expect_right(polygon);
}

TEST(triangulate, repeated_corners_add_flat_triangles) {
  const Polygon l_shape = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (std::size_t i = 0; i < l_shape.size(); ++i) {
    Polygon polygon = l_shape;
    polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(i), 3, l_shape[i]);
    expect_right(polygon, Flat::allowed);
  }
}

TEST(triangulate, holes_joined_by_bridges) {
  // A square ring as one corner list, from every start and with the bridge in every direction.
  const Polygon outer = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
  const Polygon hole = {{3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}};
  const std::size_t pairs[][2] = {{0, 0}, {0, 1}, {0, 3}, {1, 3}, {1, 0}, {1, 2},
                                  {2, 2}, {2, 1}, {2, 3}, {3, 1}, {3, 0}, {3, 2}};
  for (const auto& [o, h] : pairs) {
    Polygon polygon;
    for (std::size_t i = 0; i <= 4; ++i) polygon.push_back(outer[(o + i) % 4]);
    for (std::size_t i = 0; i <= 4; ++i) polygon.push_back(hole[(h + i) % 4]);
    for (std::size_t start = 0; start < polygon.size(); ++start) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      expect_right(polygon, Flat::allowed);
    }
  }
}

TEST(triangulate, level_and_upright_bridges) {
  const Polygon outer = {{0, 0, 0}, {9, 0, 0}, {9, 4, 0}, {9, 9, 0}, {4, 9, 0}, {0, 9, 0}, {0, 4, 0}, {4, 0, 0}};
  const dvec3 ends[][2] = {
      {{9, 4, 0}, {6, 4, 0}}, {{4, 9, 0}, {4, 6, 0}}, {{0, 4, 0}, {3, 4, 0}}, {{4, 0, 0}, {4, 3, 0}}};
  const Polygon frame = {{0, 0, 0}, {4, 0, 0}, {9, 0, 0}, {9, 4, 0}, {9, 9, 0}, {4, 9, 0}, {0, 9, 0}, {0, 4, 0}};
  const Polygon diamond = {{4, 3, 0}, {3, 4, 0}, {4, 6, 0}, {6, 4, 0}};
  ASSERT_EQ(outer.size(), frame.size());
  for (const auto& [from, to] : ends) {
    const auto o = static_cast<std::size_t>(std::find(frame.begin(), frame.end(), from) - frame.begin());
    const auto h = static_cast<std::size_t>(std::find(diamond.begin(), diamond.end(), to) - diamond.begin());
    Polygon polygon;
    for (std::size_t i = 0; i <= 8; ++i) polygon.push_back(frame[(o + i) % 8]);
    for (std::size_t i = 0; i <= 4; ++i) polygon.push_back(diamond[(h + i) % 4]);
    expect_right(polygon, Flat::allowed);
    const Triangles triangles = triangles_of(polygon);
    for (const CornerTriangle& t : triangles) {
      EXPECT_GT(test_shapes::turn(polygon[t[0]], polygon[t[1]], polygon[t[2]]), 0);
    }
  }
}

TEST(triangulate, loops_with_holes) {
  for (const int side : {1, 2, 5}) {
    Loops loops(1);
    const double size = 4.0 * side + 1.0;
    loops[0] = {{-1, -1, 0}, {size, -1, 0}, {size, size, 0}, {-1, size, 0}};
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const double x = 4 * i, y = 4 * j;
        if ((i + j) % 2 == 0) {
          loops.push_back({{x, y, 0}, {x, y + 2, 0}, {x + 2, y + 2, 0}, {x + 2, y, 0}});
        } else {
          loops.push_back({{x + 1, y, 0}, {x, y + 1, 0}, {x + 1, y + 2, 0}, {x + 2, y + 1, 0}});
        }
      }
    }
    expect_right(loops, triangles_of(loops), Flat::never);
  }
}

TEST(triangulate, holes_that_touch_at_corners) {
  // Diamonds in a row, tip to tip, and touching the frame.
  Loops loops = {{{0, 0, 0}, {8, 0, 0}, {8, 2, 0}, {0, 2, 0}}};
  for (int i = 0; i < 3; ++i) {
    const double x = 2.0 * i;
    loops.push_back({{x + 1, 1, 0}, {x + 2, 1.5, 0}, {x + 3, 1, 0}, {x + 2, 0.5, 0}});
  }
  expect_right(loops, triangles_of(loops), Flat::allowed);
}

TEST(triangulate, slits_as_holes) {
  const Loops loops = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {3, 2, 0}}};
  expect_right(loops, triangles_of(loops), Flat::allowed);
}

// Polygons that have no right triangulation still get the right number of triangles with every side used once.
void expect_complete(const Polygon& polygon) {
  const Triangles triangles = triangles_of(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  expect_sides_matched({polygon}, triangles);
  EXPECT_EQ(triangles, triangles_of(polygon));
}

TEST(triangulate, degenerate_polygons_get_as_many_triangles) {
  expect_complete(Polygon(4, dvec3(1, 2, 3)));
  expect_complete(Polygon(40, dvec3(1, 2, 3)));
  Polygon line;
  for (int i = 0; i < 50; ++i) line.emplace_back(i * i % 17, 2 * (i * i % 17), 0.0);
  expect_complete(line);
  expect_complete(Polygon{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  expect_complete(Polygon{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  Polygon pentagram = test_shapes::convex(5);
  pentagram = {pentagram[0], pentagram[2], pentagram[4], pentagram[1], pentagram[3]};
  expect_complete(pentagram);
  Polygon broken = test_shapes::convex(9);
  broken[3].y = std::numeric_limits<double>::quiet_NaN();
  broken[5].x = std::numeric_limits<double>::infinity();
  expect_complete(broken);
  broken.resize(4);
  expect_complete(broken);
}

TEST(triangulate, random_polygons_with_crossings_get_as_many_triangles) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> coarse(0, 3);
  std::uniform_real_distribution<double> fine(0.0, 1.0);
  for (int round = 0; round < 4000; ++round) {
    Polygon polygon;
    const int count = 4 + round % 30;
    for (int i = 0; i < count; ++i) {
      if (round % 2 == 0) {
        polygon.emplace_back(coarse(random), coarse(random), coarse(random) / 2);
      } else {
        polygon.emplace_back(fine(random), fine(random), fine(random));
      }
    }
    expect_complete(polygon);
    if (::testing::Test::HasFailure()) FAIL() << "round " << round;
  }
}

TEST(triangulate, holes_in_bad_places_still_give_all_triangles) {
  const Polygon outer = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Loops outside = {outer, {{5, 5, 0}, {5, 6, 0}, {6, 6, 0}}};
  const Loops single = {outer, {{0.5, 0.5, 0}}};
  const Loops wrong_way = {outer, {{0.2, 0.2, 0}, {0.8, 0.2, 0}, {0.5, 0.8, 0}}};
  for (const Loops& loops : {outside, single, wrong_way}) {
    const Triangles triangles = triangles_of(loops);
    EXPECT_EQ(triangles.size() + 4, all_corners(loops).size() + 2 * loops.size());
  }
  EXPECT_TRUE(triangles_of(Loops{}).empty());
  EXPECT_TRUE(triangles_of(Loops{{}, {}}).empty());
}

TEST(triangulate, coordinates_of_any_magnitude) {
  for (const double scale : {1e-310, 1e-160, 1e150, 1e300}) {
    Polygon polygon = test_shapes::comb(8, 1);
    for (dvec3& p : polygon) p *= scale;
    const Triangles triangles = triangles_of(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    expect_sides_matched({polygon}, triangles);
    for (const CornerTriangle& t : triangles) {
      EXPECT_GT(test_shapes::turn(polygon[t[0]], polygon[t[1]], polygon[t[2]]), 0);
    }
  }
}

TEST(triangulate, twenty_thousand_corners) {
  const std::pair<const char*, Polygon> shapes[] = {{"star", test_shapes::star(20000, 1)},
                                                    {"spiral", test_shapes::spiral(20000, 40)},
                                                    {"comb", test_shapes::comb(3333, 1)},
                                                    {"saw", test_shapes::saw(5000)},
                                                    {"square", test_shapes::square_with_many_corners(5000)},
                                                    {"convex", test_shapes::convex(20000)}};
  for (const auto& [name, polygon] : shapes) {
    Triangles triangles;
    const auto start = std::chrono::steady_clock::now();
    triangulate(polygon, triangles);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    std::cout << "  " << name << " of " << polygon.size() << " corners: " << time.count() << " ms\n";
    expect_right({polygon}, triangles, Flat::never);
  }
}

TEST(triangulate, twenty_thousand_corners_with_crossings) {
  Polygon crossing = test_shapes::star(20000, 1);
  std::swap(crossing[100], crossing[101]);
  std::swap(crossing[15000], crossing[15003]);
  Polygon tangle = test_shapes::star(20000, 2);
  std::shuffle(tangle.begin(), tangle.end(), std::mt19937(3));
  for (const Polygon& polygon : {crossing, tangle}) {
    Triangles triangles;
    const auto start = std::chrono::steady_clock::now();
    triangulate(polygon, triangles);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    std::cout << "  with crossings: " << time.count() << " ms\n";
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    expect_sides_matched({polygon}, triangles);
  }
}

}  // namespace
}  // namespace ryosen
