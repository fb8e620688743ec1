// Every primitive over several values, by oracles on the polygon list alone.
#include "ryosen/algo/algorithm_rows.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>

#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/analysis/problem_sets.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/number_text.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

constexpr double pi = std::numbers::pi;

struct Counts {
  std::size_t vertices, edges, faces;
  friend bool operator==(const Counts&, const Counts&) = default;
};

// Of a polygon list, by its directed sides.
struct Sides {
  explicit Sides(const IndexedMesh& list) {
    for (std::size_t f = 0; f < list.face_count(); ++f) {
      const auto corners = list.face(f);
      for (std::size_t i = 0; i < corners.size(); ++i) ++uses[{corners[i], corners[(i + 1) % corners.size()]}];
    }
    for (const auto& [side, count] : uses) {
      is_oriented = is_oriented && count == 1;
      if (uses.contains({side.second, side.first}))
        ++paired;
      else
        ++open;
    }
  }
  std::size_t edges() const { return paired / 2 + open; }

  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  std::size_t paired = 0, open = 0;
  bool is_oriented = true;  // no two faces traverse a side in the same direction
};

double volume_of(const IndexedMesh& list, const glm::dvec3& from = {}) {
  double six_fold = 0;
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    const auto corners = list.face(f);
    const auto place = [&](std::size_t i) { return list.positions[corners[i]] - from; };
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      six_fold += glm::dot(place(0), glm::cross(place(i), place(i + 1)));
  }
  return six_fold / 6;
}

// The area of a regular polygon, by the radius of the circle through its corners.
double area_of_polygon(double corners, double radius) {
  return corners / 2 * std::sin(2 * pi / corners) * radius * radius;
}

struct MadeShape {
  std::string line;
  Counts counts;
  std::size_t open_edges;
  int characteristic;
  double volume;  // of a closed one
};

std::vector<MadeShape> grids() {
  std::vector<MadeShape> all;
  for (const auto& [c, r] : {std::pair<std::size_t, std::size_t>{1, 1}, {1, 4}, {10, 10}, {7, 3}, {1000, 1}})
    all.push_back({"grid width=3 depth=0.5 columns=" + std::to_string(c) + " rows=" + std::to_string(r),
                   {(c + 1) * (r + 1), c * (r + 1) + r * (c + 1), c * r},
                   2 * (c + r),
                   1,
                   0});
  return all;
}

std::vector<MadeShape> solids() {
  std::vector<MadeShape> all{{"cube", {8, 12, 6}, 0, 2, 8}, {"cube size=3", {8, 12, 6}, 0, 2, 27}};
  for (const double r : {1.0, 0.125, 7.5}) {
    const std::string radius = " radius=" + format_double(r);
    const double phi = std::numbers::phi, edge = r / std::sqrt(phi * phi + 1) * 2, cube = r * r * r;
    const double pentagon_edge = r * 2 / phi / std::numbers::sqrt3;
    all.push_back({"tetrahedron" + radius, {4, 6, 4}, 0, 2, 8 * std::numbers::sqrt3 / 27 * cube});
    all.push_back({"octahedron" + radius, {6, 12, 8}, 0, 2, 4 * cube / 3});
    all.push_back(
        {"dodecahedron" + radius, {20, 30, 12}, 0, 2, (15 + 7 * std::sqrt(5)) / 4 * std::pow(pentagon_edge, 3)});
    all.push_back({"icosahedron" + radius, {12, 30, 20}, 0, 2, 5 * (3 + std::sqrt(5)) / 12 * std::pow(edge, 3)});
  }
  return all;
}

std::vector<MadeShape> spheres() {
  std::vector<MadeShape> all;
  for (const auto& [s, b] : {std::pair<std::size_t, std::size_t>{3, 2}, {4, 2}, {3, 3}, {32, 16}, {5, 40}, {64, 3}}) {
    double volume = 0;  // of slices between two circles
    for (std::size_t i = 0; i < b; ++i) {
      const double upper = pi * static_cast<double>(i) / static_cast<double>(b),
                   lower = upper + pi / static_cast<double>(b);
      volume += (std::cos(upper) - std::cos(lower)) / 3 *
                (std::pow(std::sin(upper), 2) + std::sin(upper) * std::sin(lower) + std::pow(std::sin(lower), 2));
    }
    all.push_back({"sphere radius=2 segments=" + std::to_string(s) + " bands=" + std::to_string(b),
                   {s * (b - 1) + 2, s * (b - 1) + s * b, s * b},
                   0,
                   2,
                   8 * volume * area_of_polygon(static_cast<double>(s), 1)});
  }
  return all;
}

std::vector<MadeShape> with_caps() {
  std::vector<MadeShape> all;
  for (const std::size_t s : {3u, 4u, 5u, 32u, 1000u}) {
    const std::string values = " radius=0.5 height=3 segments=" + std::to_string(s) + " caps=";
    const double cylinder = 3 * area_of_polygon(static_cast<double>(s), 0.5);
    all.push_back({"cylinder" + values + "polygon", {2 * s, 3 * s, s + 2}, 0, 2, cylinder});
    all.push_back({"cylinder" + values + "fan", {2 * s + 2, 5 * s, 3 * s}, 0, 2, cylinder});
    all.push_back({"cylinder" + values + "none", {2 * s, 3 * s, s}, 2 * s, 0, 0});
    all.push_back({"cone" + values + "polygon", {s + 1, 2 * s, s + 1}, 0, 2, cylinder / 3});
    all.push_back({"cone" + values + "fan", {s + 2, 3 * s, 2 * s}, 0, 2, cylinder / 3});
    all.push_back({"cone" + values + "none", {s + 1, 2 * s, s}, s, 1, 0});
  }
  return all;
}

std::vector<MadeShape> tori() {
  std::vector<MadeShape> all;
  for (const auto& [s, t] : {std::pair<std::size_t, std::size_t>{3, 3}, {3, 8}, {32, 16}, {17, 4}})
    for (const double tube : {0.01, 0.25, 1.9})
      all.push_back(
          {"torus radius=2 tube=" + format_double(tube) + " segments=" + std::to_string(s) +
               " tube_segments=" + std::to_string(t),
           {s * t, 2 * s * t, s * t},
           0,
           0,
           // Each slice across the axis is a polygon with a hole, so Pappus holds with the polygon's area.
           2 * area_of_polygon(static_cast<double>(s), 1) * 2 * area_of_polygon(static_cast<double>(t), tube)});
  return all;
}

std::vector<MadeShape> all_primitives() {
  std::vector<MadeShape> all;
  for (const auto& some : {grids(), solids(), spheres(), with_caps(), tori()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

TEST(primitives, have_the_counts_and_the_surface_that_their_values_say) {
  std::map<std::string_view, int> tried;
  const std::vector<MadeShape> all = all_primitives();
  for (const MadeShape& p : all) {
    SCOPED_TRACE(p.line);
    ++tried[split_words(p.line)[0]];
    const IndexedMesh list = to_indexed(made_by(p.line)).mesh;
    const Sides sides(list);
    const Counts counts{list.positions.size(), sides.edges(), list.face_count()};
    EXPECT_EQ(counts, p.counts);
    EXPECT_EQ(static_cast<int>(counts.vertices + counts.faces) - static_cast<int>(counts.edges), p.characteristic);
    EXPECT_TRUE(sides.is_oriented);
    EXPECT_EQ(sides.open, p.open_edges);
    if (p.open_edges == 0) {
      EXPECT_GT(volume_of(list), 0) << "its faces look outwards";
      EXPECT_NEAR(volume_of(list), p.volume, 1e-12 * p.volume + 1e-13);
    }
  }
  for (const AlgorithmRow& row : primitive_rows()) EXPECT_GT(tried[row.id], 1) << row.id;
}

TEST(primitives, have_no_problem_and_nothing_that_meets) {
  for (const MadeShape& p : all_primitives()) {
    SCOPED_TRACE(p.line);
    const Mesh mesh = made_by(p.line);
    const auto broken = check_invariants(mesh);
    EXPECT_FALSE(broken) << broken->sentence;
    EXPECT_FALSE(mesh.has_copies());
    const ProblemSets sets(mesh);
    for (const ProblemRow& row : problem_table())
      if (row.severity == ProblemSeverity::problem) {
        EXPECT_EQ(sets.count(row.kind), 0u) << row.id;
      }
    EXPECT_TRUE(find_self_intersections(mesh).faces.empty());
    EXPECT_EQ(euler_poincare(mesh).parts, 1);
  }
}

TEST(primitives, of_the_cube_have_exact_corners) {
  for (const double size : {1.0, 0.1, 3.0, 1e-200, 1e200}) {
    const Mesh cube = made_by("cube size=" + format_double(size));
    ASSERT_EQ(cube.live().vertices, 8u);
    for (const glm::dvec3& p : cube.positions())
      for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(std::abs(p[axis]), size / 2);
  }
  EXPECT_EQ(volume_of(to_indexed(made_by("cube size=4")).mesh), 64);
}

TEST(primitives, of_regular_solids_have_vertices_at_the_radius_and_edges_of_one_length) {
  for (const char* id : {"tetrahedron", "octahedron", "dodecahedron", "icosahedron"}) {
    const Mesh solid = made_by(std::string(id) + " radius=3 at=1,-2,5");
    const auto edge_length = [&](std::uint32_t e) {
      const Halfedge h = halfedge(Edge(e));
      return glm::distance(solid.position(solid.from(h)), solid.position(solid.to(h)));
    };
    for (const glm::dvec3& p : solid.positions()) EXPECT_NEAR(glm::distance(p, {1, -2, 5}), 3, 1e-14) << id;
    for (std::uint32_t e = 0; e < solid.edge_slots(); ++e) EXPECT_NEAR(edge_length(e), edge_length(0), 1e-14) << id;
  }
}

TEST(primitives, that_are_round_lie_on_their_surface) {
  double before = 0;
  for (int bands = 2; bands <= 128; bands *= 2) {
    const Mesh sphere = made_by("sphere segments=" + std::to_string(2 * bands) + " bands=" + std::to_string(bands));
    for (const glm::dvec3& p : sphere.positions()) EXPECT_NEAR(glm::length(p), 1, 1e-15);
    const double volume = volume_of(to_indexed(sphere).mesh);
    EXPECT_GT(volume, before);
    EXPECT_LT(volume, 4 * pi / 3);
    before = volume;
  }
  EXPECT_NEAR(before, 4 * pi / 3, 2e-3);
  const Mesh cylinder = made_by("cylinder radius=2 height=3 segments=9"), torus = made_by("torus radius=2 tube=0.5");
  for (const glm::dvec3& p : cylinder.positions()) {
    EXPECT_NEAR(std::hypot(p.x, p.z), 2, 1e-15);
    EXPECT_EQ(std::abs(p.y), 1.5);
  }
  for (const glm::dvec3& p : torus.positions()) EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 2, p.y), 0.5, 1e-15);
  const Mesh cone = made_by("cone height=3");
  EXPECT_EQ(cone.position(Vertex(32)), glm::dvec3(0, 1.5, 0));
}

TEST(primitives, of_quarter_turns_are_exact) {
  for (const char* line : {"cylinder segments=4 radius=0.3", "cylinder segments=1000 radius=0.3"}) {
    const Mesh mesh = made_by(line);
    std::set<std::pair<double, double>> places;
    for (const glm::dvec3& p : mesh.positions()) places.insert({p.x, p.z});
    for (const auto& [x, z] : places) EXPECT_TRUE(places.contains({-x, z}) && places.contains({z, -x})) << line;
    EXPECT_TRUE(places.contains({0.3, 0})) << line;
  }
}

TEST(primitives, of_the_grid_lie_as_a_floor_that_faces_up) {
  const Mesh mesh = made_by("grid width=3 depth=5 columns=7 rows=11 at=0,2,0");
  glm::dvec3 low(9), high(-9);
  for (const glm::dvec3& p : mesh.positions()) low = glm::min(low, p), high = glm::max(high, p);
  EXPECT_EQ(low, glm::dvec3(-1.5, 2, -2.5));
  EXPECT_EQ(high, glm::dvec3(1.5, 2, 2.5));
  const IndexedMesh list = to_indexed(mesh).mesh;
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    const auto c = list.face(f);
    ASSERT_EQ(c.size(), 4u);
    const auto side = [&](std::size_t i) { return list.positions[c[i + 1]] - list.positions[c[i]]; };
    EXPECT_GT(glm::cross(side(0), side(1)).y, 0);
  }
}

}  // namespace
}  // namespace ryosen::test
