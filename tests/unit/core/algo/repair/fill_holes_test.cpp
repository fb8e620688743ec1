#include "ryosen/algo/repair/fill_holes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/find_holes.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/geometry/single_precision.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "tests/support/core/algorithm_input.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/open_shapes.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

AlgorithmResult run_on(Mesh& mesh, std::string_view id) {
  Edit edit(mesh, nullptr);
  Progress unheard;
  const AlgorithmResult result = find_algorithm(id)->run(edit, input_of(*find_algorithm(id), {}), unheard);
  edit.commit();
  return result;
}
AlgorithmResult fill(Mesh& mesh) { return run_on(mesh, "fill_holes"); }

// Points at one place taken for one: where a surface touches itself there, so may a patch.
std::size_t crossings(const Mesh& mesh) {
  IndexedMesh list = to_indexed(mesh).mesh;
  std::map<std::array<double, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> number;
  for (const glm::dvec3& p : list.positions)
    number.push_back(first.emplace(std::array{p.x, p.y, p.z}, static_cast<std::uint32_t>(number.size())).first->second);
  for (std::uint32_t& corner : list.corners) corner = number[corner];
  return find_self_intersections(from_indexed(std::move(list)), 100000).pairs.size();
}

std::size_t told(const AlgorithmResult& result) {
  std::size_t sum = 0;
  for (const LeftForReason& left : result.left_for) sum += left.elements.size();
  return sum;
}

// That filling makes nothing worse and is done when it is done.
void expect_sound(Mesh mesh) {
  const Figures before = compute_figures(mesh);
  const std::size_t crossings_before = crossings(mesh);
  const AlgorithmResult result = fill(mesh);
  const Figures after = compute_figures(mesh);
  EXPECT_EQ(told(result), result.left);
  for (ProblemKind kind : {ProblemKind::nonmanifold_edge, ProblemKind::nonmanifold_vertex,
                           ProblemKind::misoriented_edge, ProblemKind::degenerate_area, ProblemKind::duplicate_face,
                           ProblemKind::hanging_pair, ProblemKind::isolated_vertex})
    EXPECT_LE(after[kind], before[kind]) << row_of(kind).id;
  EXPECT_EQ(crossings(mesh), crossings_before);
  EXPECT_EQ(fill(mesh).changed, 0u) << "twice does more than once";
}

using Place = glm::dvec3;

IndexedMesh list_of(const Polygons& faces, std::vector<Place> places) {
  IndexedMesh list = indexed(faces);
  list.positions = std::move(places);
  return list;
}

TEST(fill_holes, a_flat_hole_of_many_corners_gets_vertices_in_proportion) {
  std::size_t last = 0;
  for (const std::uint32_t corners : {500u, 1000u, 2000u}) {
    Mesh mesh = from_indexed(tube(corners, 1 + 2 * M_PI / corners, 0));
    const AlgorithmResult result = fill(mesh);
    EXPECT_EQ(result.changed, 1u) << "the outer border crosses the sheet";
    EXPECT_EQ(result.left, 1u);
    const std::size_t made = mesh.vertex_slots() - 2 * corners;
    EXPECT_GT(made, corners / 2);
    EXPECT_LT(made, 4 * corners);
    if (last > 0) {
      EXPECT_LT(made, 3 * last);
    }
    last = made;
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) ASSERT_EQ(mesh.position(Vertex(i)).z, 0.0);
    EXPECT_EQ(compute_figures(mesh)[ProblemKind::degenerate_area], 0u);
  }
}

TEST(fill_holes, a_border_that_only_its_own_sheet_could_close_stays_open) {
  Mesh mesh = from_indexed(list_of({{0, 1, 2}, {0, 2, 3}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  const AlgorithmResult result = fill(mesh);
  EXPECT_EQ(result.changed, 0u);
  EXPECT_EQ(
      result.text.en,
      "0 holes were filled; 1 could not be: it is the outer border of a flat sheet, which a patch would only double "
      "(0-1).");
  EXPECT_EQ(result.text.ja,
            "穴を 0 個ふさぎました。ふさげない穴 1：平らなシートの外周で、ふさいでもシートに重なるだけのため (0-1)。");
}

TEST(fill_holes, each_reason_is_told) {
  const double nan = std::nan("");
  const std::pair<WhyOpen, IndexedMesh> cases[] = {
      {WhyOpen::not_finite, list_of({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}})},
      {WhyOpen::cut_edge, list_of({{0, 1, 2}, {0, 1, 3}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})},
      {WhyOpen::face_exists, list_of({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
      // All corners of the loop 0-1-2-3 on a line.
      {WhyOpen::without_area,
       list_of({{1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}})},
      // A slit: the loop 0-1-4-2 has corners 1 and 2 at one place.
      {WhyOpen::coincides,
       list_of({{0, 1, 3}, {1, 4, 3}, {2, 0, 3}, {4, 2, 3}}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 1}, {2, 0, 0}})},
      {WhyOpen::flat_sheet, list_of({{0, 1, 2}, {0, 2, 3}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})},
      // A pyramid without its base, through which a tetrahedron stands.
      {WhyOpen::crosses,
       list_of({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {5, 7, 6}, {5, 6, 8}, {6, 7, 8}, {7, 5, 8}},
               {{0, 0, 0},
                {1, 0, 0},
                {1, 1, 0},
                {0, 1, 0},
                {0.5, 0.5, 1},
                {0.4, 0.4, -0.1},
                {0.6, 0.4, -0.1},
                {0.5, 0.6, -0.1},
                {0.5, 0.45, 0.2}})},
  };
  for (const auto& [cause, list] : cases) {
    Mesh mesh = from_indexed(list);
    const AlgorithmResult result = fill(mesh);
    EXPECT_EQ(result.changed, 0u);
    EXPECT_EQ(told(result), result.left);
    for (const WhyOpenRow& row : reasons_to_stay_open()) {
      if (row.cause != cause) continue;
      const Text reason = row.text();
      ASSERT_EQ(result.left_for.size(), 1u) << reason.en;
      EXPECT_TRUE(result.left_for[0].reason.en.starts_with(reason.en));
      EXPECT_TRUE(result.left_for[0].reason.ja.starts_with(reason.ja));
      EXPECT_NE(result.text.en.find(reason.en), std::string::npos);
      EXPECT_NE(result.text.ja.find(reason.ja), std::string::npos);
    }
  }
}

TEST(fill_holes, a_wall_through_a_hole_keeps_it_open) {
  // A tetrahedron without its lid, and a triangle that stands across the opening.
  const IndexedMesh list =
      list_of({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 5, 6}},
              {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -4}, {1, 1, -0.5}, {1, 1.2, 2}, {1.2, 1, 2}});
  Mesh mesh = from_indexed(list);
  const AlgorithmResult result = fill(mesh);
  EXPECT_EQ(result.changed, 0u);
  ASSERT_EQ(result.left_for.size(), 2u) << "the hole and the border of the wall";
  EXPECT_EQ(crossings(mesh), 0u);
}

TEST(fill_holes, corners_in_a_row_make_no_flat_faces) {
  // A pit with a square opening, each side of which has five corners in a row.
  std::vector<Place> places;
  constexpr std::uint32_t row = 5;
  const Place corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (std::uint32_t side = 0; side < 4; ++side)
    for (std::uint32_t i = 0; i < row; ++i)
      places.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * (i / double{row}));
  Polygons faces;
  const auto bottom = static_cast<std::uint32_t>(places.size());
  for (std::uint32_t i = 0; i < bottom; ++i) faces.push_back({(i + 1) % bottom, i, bottom});
  places.push_back({0.5, 0.5, -1});
  Mesh mesh = from_indexed(list_of(faces, places));
  expect_sound(mesh);
  EXPECT_EQ(fill(mesh).changed, 1u);
  EXPECT_TRUE(compute_figures(mesh).closed);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::degenerate_area], 0u);
}

TEST(fill_holes, in_a_mesh_of_floats_new_places_are_floats) {
  IndexedMesh list = tube(40, 1.2, 0.3);
  for (Place& p : list.positions) p = to_single(p);
  Mesh mesh = from_indexed(list);
  EXPECT_EQ(fill(mesh).changed, 2u);
  EXPECT_GT(mesh.vertex_slots(), 100u);
  for (const Place& p : mesh.positions()) EXPECT_EQ(p, to_single(p));
}

TEST(fill_holes, two_holes_that_want_the_same_edge_do_not_both_get_it) {
  // A tube of four sides that is open at both ends: each lid is a quad whose diagonal the other might use.
  Mesh mesh = from_indexed(list_of({{0, 1, 2}, {0, 3, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  expect_sound(mesh);
}

void expect_sound_files(const std::string& folder, std::size_t most_faces) {
  if (!std::filesystem::exists(folder)) return;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && format_of_extension(entry.path())) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const std::filesystem::path& path : paths) {
    const Result<MeshFile> file = read_mesh_file(path);
    if (!file || file.value().mesh.face_offsets.size() > most_faces) continue;
    SCOPED_TRACE(path.string());
    expect_sound(from_indexed(file.value().mesh));
  }
}

TEST(fill_holes, makes_no_asset_worse) { expect_sound_files(RYOSEN_SOURCE_DIR "/assets", 20000); }

TEST(fill_holes, makes_no_shared_mesh_worse) {
  expect_sound_files(RYOSEN_SHARED_DIR "/meshes", is_long_run() ? 10000000 : 800);
}

}  // namespace
}  // namespace ryosen::test
