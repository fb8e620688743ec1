#include "ryosen/analysis/self_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "ryosen/analysis/numbered_surface.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/pairs_by_asking_all.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

// The oracle: whole numbers alone, every pair of triangles, and nothing of the kernel. The points that two triangles
// have in common are a convex set, so they are known by its corners; each is a corner of a triangle or lies on one's
// side.
namespace slow {

using Number = __int128;
using Place = std::array<Number, 3>;

// A point (x, y, z) / w with w > 0.
struct Rational {
  Place x;
  Number w = 1;
};

struct Triangle {
  std::array<int, 3> names;
  std::array<Place, 3> places;
};

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Number dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place normal(const Triangle& t) { return cross(minus(t.places[1], t.places[0]), minus(t.places[2], t.places[0])); }
bool is_zero(const Place& p) { return p == Place{0, 0, 0}; }

// w (r - a)
Place from_to(const Place& a, const Rational& r) {
  return {r.x[0] - r.w * a[0], r.x[1] - r.w * a[1], r.x[2] - r.w * a[2]};
}

bool holds(const Triangle& t, const Rational& r) {
  const Place n = normal(t);
  if (dot(n, from_to(t.places[0], r)) != 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place side = minus(t.places[(k + 1) % 3], t.places[k]);
    if (dot(n, cross(side, from_to(t.places[k], r))) < 0) return false;
  }
  return true;
}

bool on_segment(const Place& a, const Place& b, const Rational& r) {
  const Place side = minus(b, a), to = from_to(a, r);
  return is_zero(cross(side, to)) && dot(side, to) >= 0 && dot(side, to) <= r.w * dot(side, side);
}

Rational between(const Place& p, const Place& q, Number weight_p, Number weight_q) {
  if (weight_p + weight_q < 0) weight_p = -weight_p, weight_q = -weight_q;
  Rational r;
  for (std::size_t i = 0; i < 3; ++i) r.x[i] = weight_p * p[i] + weight_q * q[i];
  r.w = weight_p + weight_q;
  return r;
}

// Where the sides of `a` cross the plane or, within it, the sides of `b`; corners; all that both triangles hold.
void add_corners(const Triangle& a, const Triangle& b, std::vector<Rational>& points) {
  const auto add = [&](const Rational& r) {
    if (holds(a, r) && holds(b, r)) points.push_back(r);
  };
  const Place n = normal(b);
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &p = a.places[k], &q = a.places[(k + 1) % 3];
    add({p, 1});
    const Number over_p = dot(n, minus(p, b.places[0])), over_q = dot(n, minus(q, b.places[0]));
    if (over_p != over_q) {
      add(between(p, q, -over_q, over_p));
    } else if (over_p == 0) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Place side = cross(n, minus(b.places[(j + 1) % 3], b.places[j]));
        const Number left = dot(side, minus(p, b.places[j])), right = dot(side, minus(q, b.places[j]));
        if (left != right) add(between(p, q, -right, left));
      }
    }
  }
}

bool is_shared(const Triangle& a, const Triangle& b, const Rational& r) {
  std::vector<Place> common;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a.names[i] == b.names[j]) common.push_back(a.places[i]);
  for (const Place& p : common)
    for (const Place& q : common)
      if (p == q ? is_zero(from_to(p, r)) : on_segment(p, q, r)) return true;
  return false;
}

Rational middle(const Rational& p, const Rational& q, const Rational& r) {
  Rational sum;
  for (std::size_t i = 0; i < 3; ++i) sum.x[i] = p.x[i] * q.w * r.w + q.x[i] * p.w * r.w + r.x[i] * p.w * q.w;
  sum.w = 3 * p.w * q.w * r.w;
  return sum;
}

bool meet_elsewhere(const Triangle& a, const Triangle& b) {
  std::vector<Rational> points;
  add_corners(a, b, points);
  add_corners(b, a, points);
  // All of the set is shared if and only if its corners are, and what lies between any two and any three of them.
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i; j < points.size(); ++j)
      for (std::size_t k = j; k < points.size(); ++k)
        if (!is_shared(a, b, middle(points[i], points[j], points[k]))) return true;
  return false;
}

}  // namespace slow

std::vector<FacePair> pairs_in(const Mesh& mesh, unsigned threads = 0) {
  const SelfIntersections found = find_self_intersections(mesh, std::numeric_limits<std::size_t>::max(), threads);
  EXPECT_TRUE(found.is_all());
  return found.pairs;
}

struct GridMesh {
  std::vector<std::array<int, 3>> points;
  std::vector<std::array<int, 3>> faces;

  slow::Triangle triangle(std::size_t f) const {
    slow::Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      t.names[k] = faces[f][k];
      for (std::size_t i = 0; i < 3; ++i) t.places[k][i] = points[static_cast<std::size_t>(faces[f][k])][i];
    }
    return t;
  }

  // The grid at unit one and at the origin, or elsewhere and as fine as floats cannot tell.
  IndexedMesh indexed(double unit = 1.0, double shift = 0.0) const {
    IndexedMesh mesh;
    for (const auto& p : points) mesh.positions.push_back(glm::dvec3(p[0], p[1], p[2]) * unit + glm::dvec3(shift));
    for (const auto& f : faces) {
      for (int corner : f) mesh.corners.push_back(static_cast<std::uint32_t>(corner));
      mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    return mesh;
  }
};

GridMesh random_grid_mesh(std::uint64_t seed) {
  Dice dice(seed);
  GridMesh mesh;
  const int size = 2 + dice.below(4), depth = dice.one_in(3) ? 1 : size;
  const int points = 5 + dice.below(8), faces = 2 + dice.below(9);
  for (int i = 0; i < points; ++i) mesh.points.push_back({dice.below(size), dice.below(size), dice.below(depth)});
  while (static_cast<int>(mesh.faces.size()) < faces) {
    const std::array<int, 3> f{dice.below(points), dice.below(points), dice.below(points)};
    if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0]) mesh.faces.push_back(f);
  }
  return mesh;
}

std::vector<FacePair> slow_pairs(const GridMesh& mesh) {
  std::vector<FacePair> pairs;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t g = f + 1; g < mesh.faces.size(); ++g) {
      const slow::Triangle a = mesh.triangle(f), b = mesh.triangle(g);
      if (slow::is_zero(slow::normal(a)) || slow::is_zero(slow::normal(b))) continue;
      if (slow::meet_elsewhere(a, b)) pairs.push_back({Face(f), Face(g)});
    }
  return pairs;
}

TEST(self_intersections, are_those_of_whole_numbers_on_grids) {
  std::size_t found = 0, possible = 0;
  for (std::uint64_t seed = 1; seed <= (is_long_run() ? 6000u : 150u); ++seed) {
    const GridMesh grid = random_grid_mesh(seed);
    const std::vector<FacePair> expected = slow_pairs(grid);
    ASSERT_EQ(pairs_in(from_indexed(grid.indexed())), expected) << "seed " << seed;
    ASSERT_EQ(pairs_in(from_indexed(grid.indexed(0x1p-40, 0x1p+10))), expected) << "seed " << seed;
    ASSERT_EQ(pairs_in(from_indexed(grid.indexed(0x1p+1019))), expected) << "seed " << seed;
    found += expected.size();
    possible += grid.faces.size() * (grid.faces.size() - 1) / 2;
  }
  EXPECT_GT(found, possible / 5);
  EXPECT_LT(found, possible * 4 / 5);
}

TEST(self_intersections, do_not_depend_on_the_order_of_faces_and_corners_or_on_threads) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const GridMesh grid = random_grid_mesh(seed);
    const std::vector<FacePair> pairs = pairs_in(from_indexed(grid.indexed()));
    Dice dice(seed);
    std::vector<std::size_t> order(grid.faces.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
    GridMesh shuffled{grid.points, {}};
    for (std::size_t f : order) {
      shuffled.faces.push_back(grid.faces[f]);
      std::rotate(shuffled.faces.back().begin(), shuffled.faces.back().begin() + dice.below(3),
                  shuffled.faces.back().end());
      if (dice.one_in(2)) std::swap(shuffled.faces.back()[0], shuffled.faces.back()[1]);
    }
    std::vector<FacePair> back;
    for (const FacePair& pair : pairs_in(from_indexed(shuffled.indexed()), 2)) {
      const Face f(order[pair.first.index]), g(order[pair.second.index]);
      back.push_back({std::min(f, g), std::max(f, g)});
    }
    std::sort(back.begin(), back.end());
    ASSERT_EQ(back, pairs) << "seed " << seed;
    ASSERT_EQ(pairs_in(from_indexed(grid.indexed()), 3), pairs);
  }
}

TEST(self_intersections, none_on_plain_solids) {
  IndexedMesh box = indexed(cube());
  for (std::uint32_t i = 0; i < 8; ++i) box.positions[i] = {i & 1u, i >> 1 & 1u, i >> 2};
  EXPECT_TRUE(pairs_in(from_indexed(box)).empty());
  EXPECT_TRUE(pairs_in(Mesh()).empty());
  IndexedMesh flat = indexed({{0, 1, 2}, {1, 0, 3}});
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -1, 0}};
  EXPECT_TRUE(pairs_in(from_indexed(flat)).empty());
}

TEST(self_intersections, a_fold_over_the_common_edge_counts) {
  IndexedMesh fold = indexed({{0, 1, 2}, {1, 0, 3}});
  fold.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0.25, 0}};
  EXPECT_EQ(pairs_in(from_indexed(fold)), (std::vector<FacePair>{{Face(0), Face(1)}}));
  fold.positions[3].z = 1e-300;
  EXPECT_TRUE(pairs_in(from_indexed(fold)).empty());
}

TEST(self_intersections, copies_of_a_point_are_one_and_points_at_one_place_are_two) {
  IndexedMesh bow = indexed(bow_tie());
  bow.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  EXPECT_TRUE(pairs_in(from_indexed(bow)).empty());
  IndexedMesh apart = indexed({{0, 1, 2}, {3, 4, 5}});
  apart.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {-1, -1, 0}};
  EXPECT_EQ(pairs_in(from_indexed(apart)).size(), 1u);
}

TEST(self_intersections, a_diagonal_within_a_face_is_not_a_side) {
  // A quad and a triangle that stands on its diagonal, whichever it is drawn with.
  for (const std::vector<std::uint32_t>& quad : {std::vector<std::uint32_t>{0, 1, 2, 3}, {1, 2, 3, 0}}) {
    for (const std::vector<std::uint32_t>& triangle : {std::vector<std::uint32_t>{0, 2, 4}, {1, 3, 4}}) {
      IndexedMesh mesh = indexed({quad, triangle});
      mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
      EXPECT_EQ(pairs_in(from_indexed(mesh)).size(), 1u);
    }
    IndexedMesh roof = indexed({quad, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}});
    roof.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    EXPECT_TRUE(pairs_in(from_indexed(roof)).empty());
  }
}

TEST(self_intersections, flat_and_unbounded_faces_meet_nothing) {
  IndexedMesh mesh = indexed({{0, 1, 2}, {3, 4, 5}, {3, 4, 6}});
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {1, 1, 2}, {INFINITY, 1, 1}};
  EXPECT_TRUE(pairs_in(from_indexed(mesh)).empty());
  mesh.positions[5] = {1, 2, 2};
  EXPECT_EQ(pairs_in(from_indexed(mesh)).size(), 1u);
}

// A sheet of triangles waved into another one: the pairs must be those of asking every pair.
TEST(self_intersections, of_two_large_sheets_are_those_of_all_pairs) {
  const std::uint32_t n = is_long_run() ? 20 : 14;
  IndexedMesh mesh;
  for (std::uint32_t sheet = 0; sheet < 2; ++sheet) {
    const std::uint32_t base = sheet * (n + 1) * (n + 1);
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j) {
        const double x = i, y = j;
        mesh.positions.push_back({x + 0.3 * sheet, y, sheet == 0 ? 0.2 : std::sin(0.7 * x) + std::cos(0.5 * y)});
      }
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t a = base + i * (n + 1) + j, b = a + n + 1;
        for (std::uint32_t corner : {a, b, b + 1, a, b + 1, a + 1}) {
          mesh.corners.push_back(corner);
          if (mesh.corners.size() % 3 == 0)
            mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        }
      }
  }
  const std::vector<FacePair> expected = pairs_by_asking_all(mesh);
  EXPECT_GT(expected.size(), 100u);
  const Mesh sheets = from_indexed(std::move(mesh));
  EXPECT_EQ(pairs_in(sheets), expected);
  EXPECT_EQ(pairs_in(sheets, 2), expected);
  const std::vector<Face> faces = faces_of(expected);
  EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
  for (const FacePair& pair : expected)
    for (Face f : {pair.first, pair.second}) EXPECT_TRUE(std::binary_search(faces.begin(), faces.end(), f));
}

// Each of two combs lies across the other: a pair of faces, but many pairs of their triangles.
TEST(self_intersections, a_pair_of_faces_counts_once_however_many_triangles_meet) {
  constexpr std::uint32_t teeth = 40;
  IndexedMesh combs;
  for (int comb = 0; comb < 2; ++comb) {
    const auto add = [&](double along, double across) {
      combs.corners.push_back(static_cast<std::uint32_t>(combs.positions.size()));
      combs.positions.push_back(comb == 0 ? glm::dvec3(along, across, 0) : glm::dvec3(across, along, 0));
    };
    for (std::uint32_t i = 0; i < teeth; ++i) {
      add(i, 0);
      add(i + 0.25, teeth);
      add(i + 0.5, teeth);
      add(i + 0.75, 0);
    }
    add(teeth, -1);
    add(0, -1);
    combs.face_offsets.push_back(static_cast<std::uint32_t>(combs.corners.size()));
  }
  const SelfIntersections found = find_self_intersections(from_indexed(std::move(combs)), 1);
  EXPECT_TRUE(found.is_all());
  EXPECT_EQ(found.pairs, (std::vector<FacePair>{{Face(0), Face(1)}}));
}

// Regular polygons of 3 to 40 corners, in planes of all kinds: pairs with few and with many pairs of triangles.
IndexedMesh random_polygons(std::uint64_t seed, int count) {
  Dice dice(seed);
  IndexedMesh mesh;
  for (int f = 0; f < count; ++f) {
    const int corners = dice.one_in(2) ? 3 + dice.below(4) : 9 + dice.below(32), axis = dice.below(3);
    const auto number = [&] { return 0.25 * dice.below(20); };
    const glm::dvec3 middle(number(), number(), number());
    const double size = 0.5 + 0.25 * dice.below(8);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      glm::dvec3 p = middle;
      p[axis] += size * std::cos(angle);
      p[(axis + 1) % 3] += size * std::sin(angle);
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(p);
    }
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

TEST(self_intersections, of_faces_of_all_sizes_are_those_of_all_pairs_of_their_triangles) {
  for (std::uint64_t seed = 0; seed < (is_long_run() ? 50u : 2u); ++seed) {
    const Mesh mesh = from_indexed(random_polygons(seed, 60));
    const NumberedSurface surface(mesh);
    std::vector<FacePair> expected;
    for (std::uint32_t a = 0; a < surface.slots(); ++a)
      for (std::uint32_t b = a + 1; b < surface.slots(); ++b) {
        const Face f = surface.face(a), g = surface.face(b);
        if (f == g || surface.is_flat(a) || surface.is_flat(b)) continue;
        if (!expected.empty() && expected.back() == FacePair{f, g}) continue;
        if (meet_elsewhere(surface.triangle(a), surface.triangle(b))) expected.push_back({f, g});
      }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(pairs_in(mesh, 1), expected) << seed;
    for (const std::size_t most : {expected.size() - 1, std::size_t{20}, std::size_t{0}}) {
      const SelfIntersections some = find_self_intersections(mesh, most, 2);
      EXPECT_EQ(some.pairs.size(), most);
      EXPECT_EQ(some.count, expected.size());
      EXPECT_EQ(some.faces, faces_of(expected));
      EXPECT_EQ(some.pairs, find_self_intersections(mesh, most, 1).pairs);
    }
  }
}

TEST(self_intersections, a_search_may_end_early_with_some_pairs) {
  IndexedMesh stack;
  for (std::uint32_t i = 0; i < 300; ++i) {
    for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
      stack.corners.push_back(static_cast<std::uint32_t>(stack.positions.size()));
      stack.positions.push_back(p);
    }
    stack.face_offsets.push_back(static_cast<std::uint32_t>(stack.corners.size()));
  }
  const Mesh mesh = from_indexed(std::move(stack));
  const std::vector<FacePair> all = pairs_in(mesh);
  EXPECT_EQ(all.size(), 300u * 299u / 2u);
  EXPECT_TRUE(find_self_intersections(mesh, all.size()).is_all());
  for (const std::size_t most : {all.size() - 1, std::size_t{1000}, std::size_t{1}, std::size_t{0}}) {
    const SelfIntersections some = find_self_intersections(mesh, most, 2);
    EXPECT_FALSE(some.is_all());
    EXPECT_EQ(some.pairs.size(), most);
    EXPECT_EQ(some.count, all.size());
    EXPECT_EQ(some.faces, faces_of(all));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.pairs.begin(), some.pairs.end()));
    EXPECT_EQ(some.pairs, find_self_intersections(mesh, most, 1).pairs);
  }
}

TEST(self_intersections, a_search_that_is_cancelled_finds_nothing) {
  const Mesh mesh = test::make_mesh(test::torus_grid(8, 8));
  Progress cancelled([](double) { return false; });
  EXPECT_FALSE(find_self_intersections(mesh, 10, 1, cancelled));
  std::vector<double> shares;
  Progress told([&](double share) {
    shares.push_back(share);
    return true;
  });
  const auto found = find_self_intersections(mesh, 10, 1, told);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count, find_self_intersections(mesh, 10, 1).count);
  ASSERT_FALSE(shares.empty());
  for (const double share : shares) {
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
  }
}

}  // namespace
}  // namespace ryosen::test
