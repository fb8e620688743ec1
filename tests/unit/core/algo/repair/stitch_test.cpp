#include "ryosen/algo/repair/stitch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "ryosen/algo/repair/recipe.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/recipe_checks.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

const std::string usual = "remove_duplicates,weld_equal,stitch,orient,detach_nonmanifold";

IndexedMesh list_of(std::vector<glm::dvec3> positions, std::vector<std::uint32_t> corners,
                    std::vector<std::uint32_t> face_offsets) {
  IndexedMesh list;
  list.positions = std::move(positions);
  list.corners = std::move(corners);
  list.face_offsets = std::move(face_offsets);
  return list;
}

AlgorithmResult stitched(Mesh& mesh, const std::string& values = "") {
  Journal journal;
  const MeshColumns before = mesh.columns();
  const AlgorithmResult result = run_algorithm(mesh, journal, values.empty() ? "stitch" : "stitch " + values);
  EXPECT_FALSE(check_invariants(mesh)) << check_invariants(mesh)->sentence;
  Journal again;
  Mesh twice = mesh;
  EXPECT_EQ(run_algorithm(twice, again, values.empty() ? "stitch" : "stitch " + values).changed, 0u);
  if (journal.can_undo()) {
    Mesh undone = mesh;
    journal.undo(undone);
    EXPECT_EQ(undone.columns(), before);
  }
  return result;
}

// A box whose side towards +z has strips across it: their ends lie on edges of the other sides.
IndexedMesh box_with_strips(std::uint32_t strips) {
  IndexedMesh list;
  list.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const auto add = [&](std::initializer_list<std::uint32_t> face) {
    list.corners.insert(list.corners.end(), face);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  };
  add({3, 2, 1, 0});
  add({0, 1, 5, 4});
  add({1, 2, 6, 5});
  add({2, 3, 7, 6});
  add({3, 0, 4, 7});
  std::uint32_t below = 4, above = 7;
  for (std::uint32_t i = 1; i <= strips; ++i) {
    std::uint32_t next = 5, beyond = 6;
    if (i < strips) {
      next = static_cast<std::uint32_t>(list.positions.size());
      beyond = next + 1;
      list.positions.emplace_back(static_cast<double>(i) / strips, 0, 1);
      list.positions.emplace_back(static_cast<double>(i) / strips, 1, 1);
    }
    add({below, next, beyond, above});
    below = next;
    above = beyond;
  }
  return list;
}

// The faces one by one as triangles, those of a shape that cannot be cut otherwise.
IndexedMesh in_triangles(const IndexedMesh& list) {
  IndexedMesh cut;
  cut.positions = list.positions;
  for (std::size_t f = 0; f < list.face_count(); ++f)
    for (std::uint32_t k = list.face_offsets[f] + 1; k + 1 < list.face_offsets[f + 1]; ++k) {
      for (const std::uint32_t i : {list.face_offsets[f], k, k + 1}) cut.corners.push_back(list.corners[i]);
      cut.face_offsets.push_back(static_cast<std::uint32_t>(cut.corners.size()));
    }
  return cut;
}

void expect_closed(const Mesh& mesh, double volume) {
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed && figures.manifold);
  ASSERT_TRUE(figures.volume);
  EXPECT_NEAR(*figures.volume, volume, 1e-12 * std::abs(volume));
}

TEST(stitch, the_reported_box_is_closed_by_the_default_repairs) {
  for (const std::string& kinds : {usual + ",weld_close=0.001,fill_holes", std::string("stitch")}) {
    const RecipeResult result = *run_recipe(from_indexed(report_list("t_junction.off")), recipe_of(kinds).steps, {});
    expect_closed(result.mesh, 2);
    EXPECT_EQ(compute_figures(result.mesh).vertices, 10u) << "no point is added";
    EXPECT_EQ(result.boundary_edges_after, 0u);
  }
}

TEST(stitch, boxes_with_strips_close_as_polygons_and_as_triangles) {
  for (const std::uint32_t strips : {2u, 3u, 8u, 50u})
    for (const bool cuts : {false, true}) {
      const IndexedMesh list = cuts ? in_triangles(box_with_strips(strips)) : box_with_strips(strips);
      Mesh mesh = from_indexed(list);
      const AlgorithmResult result = stitched(mesh);
      EXPECT_EQ(result.changed, 2 * (strips - 1)) << strips << cuts;
      expect_closed(mesh, 1);
      EXPECT_EQ(mesh.live().faces, list.face_count() + (cuts ? 2 * (strips - 1) : 0)) << "triangles stay triangles";
    }
}

TEST(stitch, scaled_mirrored_and_shuffled_boxes_close) {
  for (const glm::dvec3 scale : {glm::dvec3(3, 5, 7), glm::dvec3(-1, 1, 1), glm::dvec3(0x1p-300), glm::dvec3(0x1p300),
                                 glm::dvec3(1, 1024, -4)}) {
    IndexedMesh list = box_with_strips(4);
    for (glm::dvec3& p : list.positions) p *= scale;
    Mesh mesh = from_indexed(list);
    EXPECT_EQ(stitched(mesh).changed, 6u) << scale.x;
    EXPECT_TRUE(compute_figures(mesh).closed) << scale.x;
  }
  Dice dice(3);
  for (int round = 0; round < 20; ++round) {
    const IndexedMesh list = box_with_strips(5);
    std::vector<std::uint32_t> order;
    for (std::uint32_t f = 0; f < list.face_count(); ++f)
      order.insert(order.begin() + dice.below(static_cast<int>(f) + 1), f);
    IndexedMesh shuffled;
    shuffled.positions = list.positions;
    for (const std::uint32_t f : order) {
      for (std::uint32_t i = list.face_offsets[f]; i < list.face_offsets[f + 1]; ++i)
        shuffled.corners.push_back(list.corners[i]);
      shuffled.face_offsets.push_back(static_cast<std::uint32_t>(shuffled.corners.size()));
    }
    Mesh mesh = from_indexed(shuffled);
    EXPECT_EQ(stitched(mesh).changed, 8u);
    expect_closed(mesh, 1);
  }
}

// Both sides of a seam have points that the other has not.
TEST(stitch, points_of_both_sides_of_a_seam_go_into_each_other) {
  IndexedMesh list;
  list.positions = {{0, 0, 0}, {4, 0, 0}, {8, 0, 0},  {8, 1, 0}, {0, 1, 0},
                    {3, 0, 0}, {6, 0, 0}, {0, -1, 0}, {8, -1, 0}};
  list.corners = {0, 1, 2, 3, 4, 0, 7, 8, 2, 6, 5};
  list.face_offsets = {0, 5, 11};
  Mesh mesh = from_indexed(list);
  EXPECT_EQ(stitched(mesh).changed, 3u);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::boundary_loop], 6u);
  EXPECT_EQ(mesh.live(), (ElementCounts{9, 10, 2, 0}));
}

TEST(stitch, faces_that_share_no_point_are_welded_where_they_are_stitched) {
  IndexedMesh list;
  list.positions = {{0, 0, 0},  {2, 0, 0},  {2, 1, 0},  {0, 1, 0},  {0, 0, 0},  {0, -1, 0},
                    {1, -1, 0}, {1, 0, 0},  {1, 0, 0},  {1, -1, 0}, {2, -1, 0}, {2, 0, 0},
                    {9, 9, 9},  {10, 9, 9}, {9, 10, 9}, {9, 9, 9},  {9, 8, 9},  {10, 9, 9}};
  list.corners = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};
  list.face_offsets = {0, 4, 8, 12, 15, 18};
  Mesh mesh = from_indexed(list);
  EXPECT_EQ(stitched(mesh).changed, 1u);
  EXPECT_EQ(compute_figures(mesh).components, 3u) << "those elsewhere are not welded";
}

TEST(stitch, within_a_distance_a_point_beside_the_edge_goes_in) {
  IndexedMesh list = box_with_strips(2);
  for (const std::uint32_t i : {8u, 9u}) list.positions[i] += glm::dvec3(0, i == 8 ? -1e-4 : 1e-4, 2e-4);
  Mesh exact = from_indexed(list);
  EXPECT_EQ(stitched(exact).changed, 0u);
  Mesh near = from_indexed(list);
  EXPECT_EQ(stitched(near, "distance=0.0001").changed, 0u);
  EXPECT_EQ(stitched(near, "distance=0.001").changed, 2u);
  EXPECT_TRUE(compute_figures(near).closed);
  for (std::uint32_t i = 0; i < 10; ++i) EXPECT_EQ(near.position(Vertex(i)), list.positions[i]) << "no point moves";
}

TEST(stitch, within_a_distance_the_ends_may_be_apart) {
  IndexedMesh list;
  list.positions = {{0, 0, 0},  {2, 0, 0},  {2, 1, 0},    {0, 1, 0},  {1e-4, 0, 1e-4},
                    {0, -1, 0}, {1, -1, 0}, {1, 1e-4, 0}, {2, -1, 0}, {2, -1e-4, 0}};
  list.corners = {0, 1, 2, 3, 4, 5, 6, 7, 7, 6, 8, 9};
  list.face_offsets = {0, 4, 8, 12};
  Mesh mesh = from_indexed(list);
  EXPECT_EQ(stitched(mesh, "distance=0.001").changed, 1u);
  EXPECT_EQ(compute_figures(mesh).components, 1u);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::boundary_loop], 7u);
}

TEST(stitch, what_closes_nothing_is_left_alone) {
  // A point on an edge of a face elsewhere: nothing of its own runs along the edge.
  Mesh touching = from_indexed(
      list_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, -1, 0}, {2, -1, 1}}, {0, 1, 2, 3, 4, 5}, {0, 3, 6}));
  const std::uint64_t hash = touching.hash();
  EXPECT_EQ(stitched(touching).changed, 0u);
  EXPECT_EQ(touching.hash(), hash);
  Mesh empty;
  EXPECT_EQ(stitched(empty).changed, 0u);
  // A third face lies along one part of the edge, so that this part could not be joined.
  IndexedMesh three;
  three.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  three.corners = {0, 1, 2, 3, 0, 4, 0, 3, 5};
  three.face_offsets = {0, 3, 6, 9};
  Mesh crowded = from_indexed(three);
  EXPECT_EQ(stitched(crowded).changed, 0u);
}

TEST(stitch, only_points_that_turn_no_triangle_go_in) {
  // The point lies beyond the triangle's third corner, as seen from the edge.
  Mesh mesh = from_indexed(list_of({{0, 0, 0}, {8, 0, 0}, {4, 0.25, 0}, {4, 0.5, 0}, {4, -4, 0}},
                                   {0, 1, 2, 0, 4, 3, 3, 4, 1}, {0, 3, 6, 9}));
  EXPECT_EQ(stitched(mesh, "distance=1").changed, 0u);
}

// A rectangle above the x axis from 0 to 8 and two below it, which meet at x = 3; `bow_ties` further triangles hang at
// the point where they meet, each with that point alone.
IndexedMesh seam_with_bow_ties(std::uint32_t bow_ties) {
  IndexedMesh list =
      list_of({{0, 0, 0}, {8, 0, 0}, {8, 1, 0}, {0, 1, 0}, {3, 0, 0}, {0, -1, 0}, {3, -1, 0}, {8, -1, 0}},
              {0, 1, 2, 3, 0, 5, 6, 4, 4, 6, 7, 1}, {0, 4, 8, 12});
  for (std::uint32_t i = 0; i < bow_ties; ++i) {
    const double angle = 0.3 + 0.2 * i;
    for (const double turn : {0.0, 0.1}) {
      const double at = angle + turn;
      list.positions.emplace_back(3 + 0.1 * std::sin(at), 0.2 * std::sin(7 * at), 2 + std::cos(at));
    }
    const auto last = static_cast<std::uint32_t>(list.positions.size() - 1);
    for (const std::uint32_t corner : {4u, last - 1, last}) list.corners.push_back(corner);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return list;
}

TEST(stitch, a_point_that_is_a_bow_tie_goes_in) {
  for (const std::uint32_t bow_ties : {0u, 1u, 2u, 5u})
    for (const glm::dvec3 scale : {glm::dvec3(1), glm::dvec3(-1, 3, 7), glm::dvec3(0x1p-200)})
      for (const char* values : {"", "distance=0"}) {
        SCOPED_TRACE(bow_ties);
        IndexedMesh list = seam_with_bow_ties(bow_ties);
        for (glm::dvec3& p : list.positions) p *= scale;
        Mesh mesh = from_indexed(list);
        EXPECT_EQ(stitched(mesh, values).changed, 1u);
        const Figures figures = compute_figures(mesh);
        EXPECT_EQ(figures.components, 1 + bow_ties);
        EXPECT_TRUE(figures.manifold);
        EXPECT_EQ(figures[ProblemKind::boundary_loop], 7 + 3 * bow_ties) << "edges";
      }
}

// Many seams that cross at one point, each like the one above with its T-vertex there.
TEST(stitch, many_sides_may_pass_one_point) {
  for (const std::uint32_t seams : {2u, 5u, 9u, 20u, 100u}) {
    IndexedMesh list;
    for (std::uint32_t i = 0; i < seams; ++i) {
      const auto first = static_cast<std::uint32_t>(list.positions.size());
      const double x = 1.0 + i, y = seams;  // a whole multiple of this leads along the seam
      for (const glm::dvec3& p : {glm::dvec3(-3 * x, -3 * y, 0), glm::dvec3(5 * x, 5 * y, 0),
                                  glm::dvec3(5 * x, 5 * y, 1), glm::dvec3(-3 * x, -3 * y, 1), glm::dvec3(0, 0, 0),
                                  glm::dvec3(-3 * x, -3 * y, -1), glm::dvec3(0, 0, -1), glm::dvec3(5 * x, 5 * y, -1)})
        list.positions.push_back(p);
      for (const std::uint32_t corner : {0u, 1u, 2u, 3u, 0u, 5u, 6u, 4u, 4u, 6u, 7u, 1u})
        list.corners.push_back(first + corner);
      for (std::uint32_t k = 1; k <= 3; ++k) list.face_offsets.push_back(12 * i + 4 * k);
    }
    Mesh mesh = from_indexed(list);
    EXPECT_EQ(stitched(mesh).changed, seams);
    EXPECT_EQ(compute_figures(mesh).components, seams) << "each seam is closed";
    EXPECT_EQ(compute_figures(mesh)[ProblemKind::boundary_loop], 7 * seams);
  }
}

// Walls around cells of a grid whose rows are cut at different places: all inner seams close.
TEST(stitch, random_rows_of_bricks_become_one_sheet) {
  Dice dice(17);
  for (int round = 0; round < 40; ++round) {
    IndexedMesh list;
    const int rows = 2 + dice.below(4), columns = 16;
    std::size_t bricks = 0;
    for (int row = 0; row < rows; ++row) {
      std::vector<int> cuts{0};
      while (cuts.back() < columns) cuts.push_back(std::min(columns, cuts.back() + 1 + dice.below(5)));
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i, ++bricks) {
        for (const auto& [x, y] :
             {std::pair{cuts[i], row}, {cuts[i + 1], row}, {cuts[i + 1], row + 1}, {cuts[i], row + 1}}) {
          list.corners.push_back(static_cast<std::uint32_t>(list.positions.size()));
          list.positions.emplace_back(x, y, 0.5 * x - y);
        }
        list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
      }
    }
    const RecipeResult result = *run_recipe(from_indexed(list), recipe_of(usual).steps, {});
    const Figures figures = compute_figures(result.mesh);
    EXPECT_EQ(figures.components, 1u) << round;
    EXPECT_TRUE(figures.manifold) << round;
    EXPECT_EQ(figures.euler_characteristic, 1) << round;
    EXPECT_EQ(figures.faces, bricks) << round;
  }
}

}  // namespace
}  // namespace ryosen::test
