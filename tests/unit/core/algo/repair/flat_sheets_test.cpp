// The outer borders of flat sheets, which fill_holes leaves open, and borders that look like these.
#include "ryosen/algo/repair/rims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/open_shapes.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

using Polygons = std::vector<std::vector<std::uint32_t>>;

IndexedMesh sheet_of(std::vector<glm::dvec3> positions, const Polygons& faces) {
  IndexedMesh list;
  list.positions = std::move(positions);
  for (const auto& face : faces) {
    list.corners.insert(list.corners.end(), face.begin(), face.end());
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return list;
}

// n by n quads with `lift` of the corner in the middle.
IndexedMesh grid_sheet(std::uint32_t n, double lift = 0) {
  std::vector<glm::dvec3> positions;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      positions.emplace_back(x / 3.0, y / 7.0, 2 * x == n && 2 * y == n ? lift : 0.0);
  Polygons faces;
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      faces.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return sheet_of(std::move(positions), faces);
}

// With a dent on its border, so that a triangulation of it needs care.
IndexedMesh arrow_sheet() {
  return sheet_of({{0, 0, 0}, {4, -3, 0}, {1, 0, 0}, {4, 3, 0}, {0.5, 0, 0}},
                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

constexpr double width = 1.7;
IndexedMesh ring_sheet() { return tube(24, width, 0); }

std::vector<std::pair<std::string, std::function<IndexedMesh(IndexedMesh)>>> changed_sheets() {
  return {
      {"as it is", [](IndexedMesh list) { return list; }},
      {"mirrored",
       [](IndexedMesh list) {
         for (glm::dvec3& p : list.positions) p.x = -p.x;
         return list;
       }},
      {"far away and small",
       [](IndexedMesh list) {
         for (glm::dvec3& p : list.positions) p = p * 0x1p-30 + glm::dvec3(0, 0, 1);
         return list;
       }},
      {"turned", [](IndexedMesh list) { return turned(std::move(list)); }},
      {"turned and rounded", [](IndexedMesh list) { return as_floats(turned(std::move(list))); }},
  };
}

AlgorithmResult fill_sheet(Mesh& mesh, const std::string& values) {
  Journal journal;
  return run_algorithm(mesh, journal, "fill_holes " + values);
}

TEST(flat_sheets, are_not_doubled_even_where_crossing_is_allowed) {
  for (const auto& [name, change] : changed_sheets())
    for (const IndexedMesh& sheet : {grid_sheet(1), grid_sheet(4), arrow_sheet()})
      for (const char* values : {"", "crossing=allow", "crossing=allow shape=flat", "crossing=allow shape=fair"}) {
        SCOPED_TRACE(name + " " + values);
        Mesh mesh = from_indexed(change(sheet));
        const std::uint64_t hash = mesh.hash();
        const AlgorithmResult result = fill_sheet(mesh, values);
        EXPECT_EQ(result.changed, 0u) << result.text.en;
        EXPECT_EQ(result.left, 1u);
        EXPECT_NE(result.text.en.find("it is the outer border of a flat sheet, which a patch would only double"),
                  std::string::npos)
            << result.text.en;
        EXPECT_EQ(result.text.en.find("crossing=allow"), std::string::npos);
        EXPECT_EQ(mesh.hash(), hash);
      }
}

TEST(flat_sheets, holes_within_them_are_filled) {
  for (const auto& [name, change] : changed_sheets())
    for (const char* values : {"", "crossing=allow", "shape=fair crossing=allow"}) {
      SCOPED_TRACE(name + " " + values);
      Mesh mesh = from_indexed(change(ring_sheet()));
      const AlgorithmResult result = fill_sheet(mesh, values);
      EXPECT_EQ(result.changed, 1u) << result.text.en;
      EXPECT_EQ(result.left, 1u);
      EXPECT_EQ(compute_figures(mesh)[ProblemKind::boundary_loop], 24u) << "edges of the outer border";
      const double scale = name.starts_with("far") ? 0x1p-60 : 1;
      const double area = 12 * std::sin(M_PI / 12) * width * width;
      EXPECT_NEAR(compute_figures(mesh).area / scale, area, 1e-5 * area);
    }
}

// What is not flat, or encloses something, is filled where that is allowed.
TEST(flat_sheets, other_borders_are_filled) {
  for (const auto& [name, change] : changed_sheets()) {
    SCOPED_TRACE(name);
    if (name.starts_with("far")) continue;
    Mesh bent = from_indexed(change(grid_sheet(4, 1e-3)));
    EXPECT_EQ(fill_sheet(bent, "crossing=allow").changed, 1u);
    EXPECT_TRUE(compute_figures(bent).closed);
    // A cup with a flange around its opening: a lid lies on the flange and closes the cup.
    IndexedMesh list = cup(16, 1, 1);
    for (std::uint32_t i = 0; i < 16; ++i) list.positions.push_back(glm::dvec3(2, 2, 1) * list.positions[16 + i]);
    for (std::uint32_t i = 0; i < 16; ++i) {
      for (const std::uint32_t corner : {16 + i, 16 + (i + 1) % 16, 32 + (i + 1) % 16, 32 + i})
        list.corners.push_back(corner);
      list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
    }
    Mesh flanged = from_indexed(change(list));
    EXPECT_EQ(fill_sheet(flanged, "").changed, 0u);
    EXPECT_EQ(fill_sheet(flanged, "crossing=allow").changed, 1u);
    EXPECT_TRUE(compute_figures(flanged).closed);
  }
}

}  // namespace
}  // namespace ryosen::test
