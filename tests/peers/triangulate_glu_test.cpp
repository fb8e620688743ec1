// The triangulation held against GLU's tessellator: both must cover the same places once, on polygons with holes.
#include <GL/glu.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "ryosen/geometry/triangulate.h"
#include "tests/unit/core/geometry/polygon_shapes.h"

namespace ryosen {
namespace {

using glm::dvec3;
using test_shapes::Polygon;
using Loops = std::vector<Polygon>;
using Triangle = std::array<dvec3, 3>;

class Tessellator {
 public:
  Tessellator() : tess_(gluNewTess()) {
    using Callback = void (*)();
    gluTessCallback(tess_, GLU_TESS_VERTEX_DATA, reinterpret_cast<Callback>(take_corner));
    gluTessCallback(tess_, GLU_TESS_EDGE_FLAG_DATA, reinterpret_cast<Callback>(ignore_flag));  // only triangles then
    gluTessCallback(tess_, GLU_TESS_ERROR_DATA, reinterpret_cast<Callback>(take_error));
    gluTessNormal(tess_, 0, 0, 1);
  }
  ~Tessellator() { gluDeleteTess(tess_); }
  Tessellator(const Tessellator&) = delete;
  Tessellator& operator=(const Tessellator&) = delete;

  std::vector<Triangle> triangles_of(Loops loops) {
    corners_.clear();
    gluTessBeginPolygon(tess_, this);
    for (Polygon& loop : loops) {
      gluTessBeginContour(tess_);
      for (dvec3& p : loop) gluTessVertex(tess_, &p.x, &p);
      gluTessEndContour(tess_);
    }
    gluTessEndPolygon(tess_);
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i + 2 < corners_.size(); i += 3)
      triangles.push_back({corners_[i], corners_[i + 1], corners_[i + 2]});
    return triangles;
  }

 private:
  static void take_corner(void* corner, void* self) {
    static_cast<Tessellator*>(self)->corners_.push_back(*static_cast<dvec3*>(corner));
  }
  static void ignore_flag(GLboolean, void*) {}
  static void take_error(GLenum error, void*) { ADD_FAILURE() << gluErrorString(error); }

  GLUtesselator* tess_;
  std::vector<dvec3> corners_;
};

std::vector<Triangle> our_triangles(const Loops& loops) {
  std::vector<std::span<const dvec3>> spans(loops.begin(), loops.end());
  std::vector<CornerTriangle> numbers;
  triangulate_loops(spans, numbers);
  Polygon corners;
  for (const Polygon& loop : loops) corners.insert(corners.end(), loop.begin(), loop.end());
  std::vector<Triangle> triangles;
  for (const CornerTriangle& t : numbers) triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  return triangles;
}

double cross(const dvec3& a, const dvec3& b, const dvec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Exact for the whole numbers that the polygons here have as coordinates.
double twice_the_area(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += std::abs(cross(t[0], t[1], t[2]));
  return sum;
}

int count_containing(const std::vector<Triangle>& triangles, const dvec3& p) {
  int count = 0;
  for (const auto& [a, b, c] : triangles) {
    const bool x = cross(a, b, p) > 0, y = cross(b, c, p) > 0, z = cross(c, a, p) > 0;
    count += x == y && y == z;
  }
  return count;
}

bool sides_meet(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  const double abc = cross(a, b, c), abd = cross(a, b, d), cda = cross(c, d, a), cdb = cross(c, d, b);
  return abc * abd <= 0 && cda * cdb <= 0;
}

bool loops_meet(const Polygon& one, const Polygon& other) {
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t k = 0; k < other.size(); ++k)
      if (sides_meet(one[i], one[(i + 1) % one.size()], other[k], other[(k + 1) % other.size()])) return true;
  return false;
}

bool is_inside(const Polygon& polygon, const dvec3& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && (cross(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

// A simple polygon on whole numbers, and diamonds and triangles clear of it and of each other as holes.
Loops random_loops(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  constexpr int grid = 12, step = 24;
  Loops loops{test_shapes::random_simple(5 + random() % 20, grid, seed)};
  for (dvec3& p : loops[0]) p *= step;
  if (test_shapes::signed_area(loops[0]) < 0) std::reverse(loops[0].begin(), loops[0].end());
  for (int i = 0; i < 60; ++i) {
    const double x = below(grid * step), y = below(grid * step), r = 2 + below(30), s = 2 + below(30);
    // Clockwise.
    Polygon hole = i % 2 ? Polygon{{x - r, y, 0}, {x, y + s, 0}, {x + r, y, 0}, {x, y - s, 0}}
                         : Polygon{{x - r, y, 0}, {x, y + s, 0}, {x + r, y - 1, 0}};
    bool is_clear = is_inside(loops[0], hole[0]);
    for (std::size_t k = 0; k < loops.size() && is_clear; ++k)
      is_clear =
          !loops_meet(loops[k], hole) && (k == 0 || (!is_inside(loops[k], hole[0]) && !is_inside(hole, loops[k][0])));
    if (is_clear) loops.push_back(hole);
  }
  return loops;
}

TEST(triangulate_against_glu, random_polygons_with_holes) {
  Tessellator glu;
  std::size_t holes = 0, samples = 0;
  for (unsigned seed = 1; seed <= 1000 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Loops loops = random_loops(seed);
    holes += loops.size() - 1;
    const std::vector<Triangle> ours = our_triangles(loops), theirs = glu.triangles_of(loops);
    ASSERT_EQ(twice_the_area(ours), twice_the_area(theirs));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-10.0, 300.0);
    for (int i = 0; i < 200; ++i) {
      const dvec3 p(coordinate(random), coordinate(random), 0);
      const int count = count_containing(ours, p);
      ASSERT_EQ(count, count_containing(theirs, p)) << p.x << " " << p.y;
      ASSERT_LE(count, 1);
      samples += count > 0;
    }
  }
  EXPECT_GT(holes, 1000u);
  EXPECT_GT(samples, 10000u);
}

TEST(triangulate_against_glu, large_shapes_have_the_same_area) {
  Tessellator glu;
  for (const Polygon& polygon :
       {test_shapes::star(5000, 1), test_shapes::comb(1000, 1), test_shapes::spiral(4000, 12)}) {
    const double area = twice_the_area(glu.triangles_of({polygon}));
    EXPECT_NEAR(twice_the_area(our_triangles({polygon})), area, 1e-9 * area);
  }
}

}  // namespace
}  // namespace ryosen
