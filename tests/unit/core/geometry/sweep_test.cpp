#include "ryosen/geometry/sweep.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <set>

#include "tests/support/core/long_run.h"
#include "tests/unit/core/geometry/polygon_shapes.h"

namespace ryosen {
namespace {

using glm::dvec3;
using test_shapes::Polygon;
using Loops = std::vector<Polygon>;

std::optional<std::vector<CornerTriangle>> sweep(const Loops& loops) {
  std::vector<glm::dvec2> points;
  std::vector<std::uint32_t> ends;
  for (const Polygon& loop : loops) {
    for (const dvec3& p : loop) points.emplace_back(p.x, p.y);
    ends.push_back(static_cast<std::uint32_t>(points.size()));
  }
  std::vector<CornerTriangle> triangles;
  if (!sweep_triangles({points, ends}, SweepMode::strict, triangles)) return std::nullopt;
  return triangles;
}

Loops quarter_turned(Loops loops) {
  for (Polygon& loop : loops) {
    for (dvec3& p : loop) p = {-p.y, p.x, 0.0};
  }
  return loops;
}

// Complete, no triangle flat or turned over, and the area right (exact: coordinates are small integers).
void expect_right(Loops loops) {
  for (int turn = 0; turn < 4; ++turn) {
    const auto triangles = sweep(loops);
    ASSERT_TRUE(triangles.has_value());
    Polygon corners;
    double expected = 0.0;
    for (const Polygon& loop : loops) {
      corners.insert(corners.end(), loop.begin(), loop.end());
      expected += test_shapes::signed_area(loop);
    }
    double area = 0.0;
    for (const CornerTriangle& t : *triangles) {
      ASSERT_GT(test_shapes::turn(corners[t[0]], corners[t[1]], corners[t[2]]), 0);
      area += test_shapes::signed_area({corners[t[0]], corners[t[1]], corners[t[2]]});
    }
    EXPECT_EQ(area, expected);
    EXPECT_EQ(triangles->size() + 4, corners.size() + 2 * loops.size());
    loops = quarter_turned(loops);
  }
}

bool is_inside(const Polygon& polygon, const dvec3& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && (test_shapes::turn(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

// Whether the open segment a-b keeps clear of all sides, apart from those that end at a or b.
bool sees(const Loops& loops, const dvec3& a, const dvec3& b) {
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const dvec3 &c = loop[i], &d = loop[(i + 1) % loop.size()];
      if (c == a || c == b || d == a || d == b) {
        const dvec3& other = c == a || c == b ? d : c;
        if (test_shapes::turn(a, b, other) == 0) return false;
      } else if (test_shapes::segments_meet(a, b, c, d)) {
        return false;
      }
    }
  }
  return true;
}

// A random simple polygon with small diamonds cut out where they have room.
Loops random_with_holes(unsigned seed) {
  Polygon outer = test_shapes::random_simple(5 + seed % 12, 5, seed);
  if (outer.empty()) return {};
  for (dvec3& p : outer) p *= 6.0;
  Loops loops = {outer};
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(1, 29);
  for (int attempt = 0; attempt < 60 && loops.size() < 6; ++attempt) {
    const dvec3 c(coordinate(random), coordinate(random), 0.0);
    const Polygon hole = {c + dvec3(0, -1, 0), c + dvec3(-1, 0, 0), c + dvec3(0, 1, 0), c + dvec3(1, 0, 0)};
    bool free = is_inside(outer, c);
    for (const Polygon& loop : loops) {
      for (std::size_t i = 0; i < loop.size() && free; ++i) {
        for (std::size_t j = 0; j < 4 && free; ++j) {
          free = !test_shapes::segments_meet(loop[i], loop[(i + 1) % loop.size()], hole[j], hole[(j + 1) % 4]);
        }
      }
    }
    for (std::size_t k = 1; k < loops.size() && free; ++k)
      free = !is_inside(loops[k], c) && !is_inside(hole, loops[k][0]);
    if (free) loops.push_back(hole);
  }
  return loops;
}

// Ties each hole to a corner that it sees and that no other bridge uses, as files write faces with holes.
std::optional<Polygon> bridged(const Loops& loops, unsigned seed) {
  std::mt19937 random(seed);
  Polygon joined = loops[0];
  for (std::size_t k = 1; k < loops.size(); ++k) {
    std::vector<std::pair<std::size_t, std::size_t>> choices;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      if (std::count(joined.begin(), joined.end(), joined[i]) != 1) continue;
      for (std::size_t j = 0; j < 4; ++j) {
        Loops sides(loops);
        sides.push_back(joined);
        if (sees(sides, joined[i], loops[k][j]) && is_inside(loops[0], (joined[i] + loops[k][j]) * 0.5)) {
          choices.emplace_back(i, j);
        }
      }
    }
    if (choices.empty()) return std::nullopt;
    const auto [at, from] = choices[random() % choices.size()];
    Polygon detour = {joined[at]};
    for (std::size_t j = 0; j <= 4; ++j) detour.push_back(loops[k][(from + j) % 4]);
    joined.insert(joined.begin() + static_cast<std::ptrdiff_t>(at), detour.begin(), detour.end());
  }
  return joined;
}

TEST(sweep, random_simple_polygons_need_no_fallback) {
  unsigned made = 0;
  const unsigned seeds = test::is_long_run() ? 1000 : 150;
  for (unsigned seed = 10000; seed < 10000 + seeds; ++seed) {
    const Polygon polygon = test_shapes::random_simple(4 + seed % 19, 6, seed);
    if (polygon.empty()) continue;
    ++made;
    expect_right({polygon});
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(made, seeds / 5);
}

TEST(sweep, random_polygons_with_holes) {
  std::size_t holes = 0;
  const unsigned seeds = test::is_long_run() ? 1500 : 200;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const Loops loops = random_with_holes(seed);
    if (loops.empty()) continue;
    holes += loops.size() - 1;
    expect_right(loops);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(holes, 250u);
}

TEST(sweep, random_polygons_with_bridges_to_their_holes) {
  unsigned made = 0;
  const unsigned seeds = test::is_long_run() ? 1500 : 200;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const Loops loops = random_with_holes(seed);
    if (loops.size() < 2) continue;
    const auto polygon = bridged(loops, seed);
    if (!polygon) continue;
    ++made;
    expect_right({*polygon});
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(made, seeds / 4);
}

// The boundary walk of triangles of a grid that hang together like a tree: sides walked both ways, corners met many
// times, slits, all turns in multiples of 45 degrees; one triangulation is known.
Polygon walk_around_tree(std::size_t count, int grid, unsigned seed) {
  std::mt19937 random(seed);
  using Place = std::pair<int, int>;
  std::set<std::array<Place, 3>> used;
  const auto is_free = [&](std::array<Place, 3> t) {
    std::sort(t.begin(), t.end());
    for (const auto& [x, y] : t) {
      if (x < 0 || y < 0 || x > grid || y > grid) return false;
    }
    return used.insert(t).second;
  };
  std::vector<Place> walk = {{grid / 2, grid / 2}, {grid / 2 + 1, grid / 2}, {grid / 2 + 1, grid / 2 + 1}};
  is_free({walk[0], walk[1], walk[2]});
  for (std::size_t attempt = 0; attempt < 20 * count && walk.size() < count + 2; ++attempt) {
    // The triangle beyond side a-b has its third corner where the square's diagonals run from low to high.
    const std::size_t i = random() % walk.size();
    const Place a = walk[i], b = walk[(i + 1) % walk.size()];
    const int dx = b.first - a.first, dy = b.second - a.second;
    const Place apex = dx != 0 && dy != 0 ? (dx > 0 ? Place(a.first + 1, a.second) : Place(a.first - 1, a.second))
                       : dx == 1          ? Place(a.first, a.second - 1)
                       : dx == -1         ? Place(a.first, a.second + 1)
                       : dy == 1          ? Place(a.first + 1, a.second + 1)
                                          : Place(a.first - 1, a.second - 1);
    if (!is_free({a, b, apex})) continue;
    walk.insert(walk.begin() + static_cast<std::ptrdiff_t>(i) + 1, apex);
  }
  Polygon polygon;
  for (const auto& [x, y] : walk) polygon.emplace_back(x, y, 0.0);
  return polygon;
}

TEST(sweep, polygons_that_touch_themselves_everywhere) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    const std::size_t count = 2 + seed % 60;
    const Polygon polygon = walk_around_tree(count, 3 + static_cast<int>(seed % 5), seed);
    const double triangles = static_cast<double>(polygon.size()) - 2.0;
    ASSERT_EQ(test_shapes::signed_area(polygon), triangles / 2.0);
    expect_right({polygon});
    if (HasFailure()) FAIL() << "seed " << seed;
  }
}

TEST(sweep, large_shapes_need_no_fallback) {
  for (const Polygon& polygon : {test_shapes::star(3000, 5), test_shapes::spiral(3000, 20), test_shapes::comb(500, 6),
                                 test_shapes::saw(700), test_shapes::square_with_many_corners(700)}) {
    const auto triangles = sweep({polygon});
    ASSERT_TRUE(triangles.has_value());
    EXPECT_EQ(triangles->size(), polygon.size() - 2);
  }
}

TEST(sweep, a_polygon_run_clockwise_or_across_itself_is_refused) {
  Polygon clockwise = test_shapes::comb(5, 1);
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_FALSE(sweep({clockwise}));
  EXPECT_FALSE(sweep({{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}}));
  EXPECT_FALSE(sweep({{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}));
}

}  // namespace
}  // namespace ryosen
