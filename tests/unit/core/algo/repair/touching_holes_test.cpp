// Holes that touch in a point are filled one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/fill_holes.h"
#include "ryosen/algo/repair/find_holes.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/rules/sheets.h"
#include "tests/support/core/algorithm_input.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

AlgorithmResult run_alone(Mesh& mesh, const char* id) {
  Edit edit(mesh, nullptr);
  Progress unheard;
  const AlgorithmRow& row = *find_algorithm(id);
  const AlgorithmResult result = row.run(edit, input_of(row, {}), unheard);
  edit.commit();
  EXPECT_FALSE(check_invariants(mesh));
  return result;
}

AlgorithmResult fill_holes_of(Mesh& mesh) { return run_alone(mesh, "fill_holes"); }

// Without these faces, read anew.
Mesh without(const Mesh& mesh, const std::vector<std::uint32_t>& faces) {
  const IndexedMesh all = to_indexed(mesh).mesh;
  IndexedMesh some;
  some.positions = all.positions;
  some.face_offsets.push_back(0);
  for (std::uint32_t f = 0; f + 1 < all.face_offsets.size(); ++f) {
    if (std::find(faces.begin(), faces.end(), f) != faces.end()) continue;
    some.corners.insert(some.corners.end(), all.corners.begin() + all.face_offsets[f],
                        all.corners.begin() + all.face_offsets[f + 1]);
    some.face_offsets.push_back(static_cast<std::uint32_t>(some.corners.size()));
  }
  return from_indexed(std::move(some));
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_alive(Face(f))) continue;
    std::vector<glm::dvec3> at;
    for (const Vertex v : vertices_around(mesh, Face(f))) at.push_back(mesh.position(v));
    for (std::size_t i = 2; i < at.size(); ++i) sum += glm::dot(at[0], glm::cross(at[i - 1], at[i])) / 6;
  }
  return sum;
}

std::size_t boundary_edges(const Mesh& mesh) {
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
    found += mesh.is_alive(Halfedge(i)) && mesh.is_outside(Halfedge(i));
  return found;
}

IndexedMesh placed(const Polygons& faces, std::vector<glm::dvec3> places) {
  IndexedMesh list = indexed(faces);
  list.positions = std::move(places);
  return list;
}

// Squares, n a side.
IndexedMesh squares(std::uint32_t n) {
  Polygons faces;
  std::vector<glm::dvec3> places;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) places.emplace_back(x, y, 0);
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      faces.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return placed(faces, std::move(places));
}

// A part that touches the others in points alone; what lies around it is no hole that touches itself.
bool has_island(const Mesh& mesh) {
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f)
    if (mesh.is_alive(Face(f))) return faces_of_sheet(mesh, Face(f)).size() < mesh.live().faces;
  return true;
}

Mesh triangle_cube() {
  return from_indexed(placed({{0, 2, 1},
                              {4, 5, 6},
                              {4, 6, 7},
                              {0, 5, 4},
                              {1, 2, 6},
                              {1, 6, 5},
                              {2, 3, 7},
                              {2, 7, 6},
                              {3, 0, 4},
                              {3, 4, 7},
                              {0, 1, 5},
                              {0, 3, 2}},
                             {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}));
}

TEST(touching_holes, of_a_cube_give_the_cube_back) {
  const Mesh cube = triangle_cube();
  ASSERT_NEAR(volume(cube), 1, 1e-12);
  int pinched = 0;
  // Each two faces that touch in a point alone, and each three around one.
  for (std::uint32_t a = 0; a < 12; ++a)
    for (std::uint32_t b = a + 1; b < 12; ++b)
      for (std::uint32_t c = b; c < 12; ++c) {
        std::vector<std::uint32_t> gone{a, b};
        if (c != b) gone.push_back(c);
        for (const bool is_detached : {false, true}) {
          Mesh mesh = without(cube, gone);
          if (boundary_edges(mesh) != 3 * gone.size() || has_island(mesh)) continue;  // or an edge in common
          ++pinched;
          if (is_detached) run_alone(mesh, "detach_nonmanifold");
          const AlgorithmResult result = fill_holes_of(mesh);
          EXPECT_EQ(boundary_edges(mesh), 0u) << a << " " << b << " " << c << " " << is_detached;
          EXPECT_EQ(result.left, 0u);
          EXPECT_NEAR(volume(mesh), 1, 1e-12) << a << " " << b << " " << c;
          EXPECT_EQ(mesh.live().vertices, 8u);
          EXPECT_EQ(mesh.live().faces, 12u);
        }
      }
  EXPECT_GT(pinched, 20);
}

TEST(touching_holes, of_a_sheet_are_filled_in_rows_and_where_it_is_bent) {
  for (const double bend : {0.0, 0.1, 0.4}) {
    for (const std::vector<int>& cells :
         std::vector<std::vector<int>>{{5, 10}, {5, 10, 15}, {6, 9}, {5, 8}, {1, 6}, {5, 7, 13, 15}}) {
      IndexedMesh list = squares(4);
      for (glm::dvec3& p : list.positions) p.z = bend * (p.x - 2) * (p.x - 2);
      Mesh mesh = without(from_indexed(list), {cells.begin(), cells.end()});
      const std::size_t outer = 16;
      fill_holes_of(mesh);
      EXPECT_LE(boundary_edges(mesh), outer + 8) << bend;
      const Figures figures = compute_figures(mesh);
      for (const ProblemKind kind : {ProblemKind::nonmanifold_edge, ProblemKind::nonmanifold_vertex,
                                     ProblemKind::coincident_points, ProblemKind::degenerate_area})
        EXPECT_EQ(figures[kind], 0u) << row_of(kind).id << " " << bend << " first cell " << cells[0] << ", then "
                                     << cells[1];
    }
  }
}

TEST(touching_holes, of_random_faces_leave_no_boundary) {
  const int seeds = is_long_run() ? 5000 : 100;
  std::size_t filled = 0;
  for (const char* const name : {"ball.off", "torus.off"}) {
    const Mesh whole = asset_mesh(name);
    const double full = volume(whole);
    for (int seed = 0; seed < seeds; ++seed) {
      std::mt19937 random(static_cast<unsigned>(seed));
      std::vector<std::uint32_t> gone;
      const std::size_t faces = whole.live().faces;
      for (std::size_t i = 0, n = 2 + random() % std::min<std::size_t>(6, faces / 3); i < n; ++i)
        gone.push_back(static_cast<std::uint32_t>(random() % faces));
      Mesh mesh = without(whole, gone);
      if (has_island(mesh)) continue;
      fill_holes_of(mesh);
      EXPECT_EQ(boundary_edges(mesh), 0u) << name << " seed " << seed;
      EXPECT_NEAR(volume(mesh), full, 0.35 * full) << name << " seed " << seed;
      ++filled;
    }
  }
  EXPECT_GT(filled, 1u * static_cast<unsigned>(seeds));
}

std::vector<std::size_t> loop_sizes(const Mesh& mesh) {
  std::vector<std::size_t> sizes;
  std::vector<bool> seen(mesh.halfedge_slots(), false);
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    if (seen[i] || !mesh.is_alive(Halfedge(i)) || !mesh.is_outside(Halfedge(i))) continue;
    sizes.push_back(0);
    for (const Halfedge h : loop(mesh, Halfedge(i))) {
      seen[h.index] = true;
      ++sizes.back();
    }
  }
  return sizes;
}

TEST(touching_holes, loops_are_parted_and_joined_again) {
  for (const bool is_detached : {false, true}) {
    Mesh mesh = without(triangle_cube(), {10, 11});
    if (is_detached) run_alone(mesh, "detach_nonmanifold");
    const std::size_t points = to_indexed(mesh).mesh.positions.size();
    EXPECT_EQ(points, is_detached ? 9u : 8u);
    EXPECT_EQ(loop_sizes(mesh), std::vector<std::size_t>{6});
    Edit edit(mesh, nullptr);
    const std::vector<Vertex> joined = part_loops(edit);
    EXPECT_EQ(joined.size(), is_detached ? 1u : 0u);
    EXPECT_EQ(loop_sizes(mesh), (std::vector<std::size_t>{3, 3}));
    join_loops(edit, joined);
    edit.commit();
    EXPECT_EQ(loop_sizes(mesh), std::vector<std::size_t>{6});
    EXPECT_FALSE(check_invariants(mesh));
    EXPECT_EQ(to_indexed(mesh).mesh.positions.size(), points);
  }
}

}  // namespace
}  // namespace ryosen::test
