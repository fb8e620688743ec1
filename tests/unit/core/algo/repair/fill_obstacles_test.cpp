// Obstacles of fill_holes: faces without area at the rim, and faces across the hole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/fill_holes.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/open_shapes.h"

namespace ryosen::test {
namespace {

AlgorithmResult filled_across(Mesh& mesh, std::string_view crossing = "refuse") {
  const AlgorithmRow& row = *find_algorithm("fill_holes");
  AlgorithmInput input{ParameterValues(row.parameters), {}, 0};
  EXPECT_FALSE(input.values.set("crossing", crossing, "crossing"));
  Edit edit(mesh, nullptr);
  Progress unheard;
  const AlgorithmResult result = row.run(edit, input, unheard);
  edit.commit();
  return result;
}

using Change = IndexedMesh (*)(IndexedMesh);

IndexedMesh as_it_is(IndexedMesh list) { return list; }
IndexedMesh in_mirror(IndexedMesh list) {
  for (glm::dvec3& p : list.positions) p.x = -p.x;
  for (std::size_t f = 0; f < list.face_count(); ++f)
    std::reverse(list.corners.begin() + list.face_offsets[f], list.corners.begin() + list.face_offsets[f + 1]);
  return list;
}
IndexedMesh shrunk(IndexedMesh list) {
  for (glm::dvec3& p : list.positions) p = p * 0x1p-30 + glm::dvec3(0, 0, 1);
  return list;
}
IndexedMesh on_its_side(IndexedMesh list) {
  for (glm::dvec3& p : list.positions) p = {p.z, p.x, p.y};
  return list;
}
// Faces and corners in another order.
IndexedMesh shuffled(IndexedMesh list) {
  IndexedMesh other;
  other.positions = std::move(list.positions);
  std::reverse(other.positions.begin(), other.positions.end());
  const auto last = static_cast<std::uint32_t>(other.positions.size() - 1);
  for (std::size_t f = list.face_count(); f-- > 0;) {
    for (const std::uint32_t corner : list.face(f)) other.corners.push_back(last - corner);
    std::rotate(other.corners.begin() + other.face_offsets.back(), other.corners.end() - 1, other.corners.end());
    other.face_offsets.push_back(static_cast<std::uint32_t>(other.corners.size()));
  }
  return other;
}
constexpr Change changes[] = {as_it_is, in_mirror, shrunk, on_its_side, shuffled};

TEST(fill_obstacles, faces_without_area_at_the_rim_are_mended_first) {
  for (const Change change : changes) {
    Mesh mesh = from_indexed(change(report_list("degenerate_rim.off")));
    const double scale = change == shrunk ? 0x1p-90 : 1;
    const AlgorithmResult result = filled_across(mesh);
    EXPECT_EQ(result.left, 0u) << result.text.en;
    EXPECT_NE(result.text.en.find("one face without area at a rim was removed first"), std::string::npos)
        << result.text.en;
    EXPECT_NE(result.text.ja.find("先に縁の面積ゼロの面を 1 個なくしました"), std::string::npos);
    const Figures figures = compute_figures(mesh);
    EXPECT_TRUE(figures.closed && figures.manifold);
    EXPECT_EQ(figures[ProblemKind::degenerate_area], 0u);
    EXPECT_NEAR(std::abs(figures.volume.value_or(0)) / scale, 9, 1e-6);
    EXPECT_TRUE(find_self_intersections(mesh).pairs.empty());
    EXPECT_EQ(filled_across(mesh).changed, 0u);
  }
}

// An open box of 3 with so many flat triangles in a chain along one side of its rim.
IndexedMesh box_with_flat_chain(std::uint32_t flat) {
  IndexedMesh list = report_list("degenerate_rim.off");
  list.positions.resize(8);
  list.corners = {0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0, 7, 6, 5, 4};
  list.face_offsets = {0, 4, 8, 12, 16, 20};
  for (std::uint32_t i = 0; i < flat; ++i) {
    const std::uint32_t from = i == 0 ? 0 : 7 + i;
    list.positions.push_back({3.0 * (i + 1) / (flat + 1), 0, 0});
    for (const std::uint32_t corner : {from, 1u, 8 + i}) list.corners.push_back(corner);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return list;
}

TEST(fill_obstacles, chains_of_faces_without_area_at_the_rim_are_mended) {
  for (const std::uint32_t flat : {1u, 2u, 5u, 30u, 200u}) {
    Mesh mesh = from_indexed(box_with_flat_chain(flat));
    const AlgorithmResult result = filled_across(mesh);
    EXPECT_EQ(result.left, 0u) << result.text.en;
    const Figures figures = compute_figures(mesh);
    EXPECT_TRUE(figures.closed) << flat;
    EXPECT_NEAR(figures.volume.value_or(0), 9, 1e-6);
    EXPECT_EQ(figures[ProblemKind::degenerate_area], 0u);
  }
}

TEST(fill_obstacles, a_face_without_area_elsewhere_stays) {
  IndexedMesh list = report_list("degenerate_rim.off");
  for (const glm::dvec3& p : {glm::dvec3(9, 0, 0), glm::dvec3(10, 0, 0), glm::dvec3(11, 0, 0)})
    list.positions.push_back(p);
  for (const std::uint32_t corner : {9u, 10u, 11u}) list.corners.push_back(corner);
  list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  Mesh mesh = from_indexed(list);
  filled_across(mesh);
  EXPECT_EQ(compute_figures(mesh)[ProblemKind::degenerate_area], 1u);
}

TEST(fill_obstacles, what_crosses_is_named_and_crossing_allow_fills_anyway) {
  for (const Change change : changes) {
    const IndexedMesh list = change(report_list("pierced_hole.off"));
    const bool is_shuffled = change == shuffled;
    Mesh mesh = from_indexed(list);
    const AlgorithmResult refused = filled_across(mesh);
    EXPECT_EQ(refused.changed, 0u);
    const std::string named = is_shuffled ? "f0" : "f3";
    EXPECT_NE(refused.text.en.find("crosses the surface or itself at " + named + ", crossing=allow fills anyway"),
              std::string::npos)
        << refused.text.en;
    EXPECT_NE(refused.text.ja.find("（" + named + "）、crossing=allow でふさげます"), std::string::npos)
        << refused.text.ja;
    const AlgorithmResult allowed = filled_across(mesh, "allow");
    EXPECT_EQ(allowed.changed, 1u) << allowed.text.en;
    EXPECT_EQ(allowed.crossings, std::optional<std::size_t>(1));
    EXPECT_NE(allowed.text.en.find("; one patch crosses something"), std::string::npos) << allowed.text.en;
    const Figures figures = compute_figures(mesh);
    EXPECT_EQ(figures[ProblemKind::boundary_loop], 3u) << "that of the triangle alone";
    EXPECT_EQ(figures[ProblemKind::duplicate_face], 0u);
    EXPECT_EQ(filled_across(mesh, "allow").changed, 0u);
  }
}

// A cup of so many corners with a triangle that stands across its opening.
IndexedMesh pierced_cup(std::uint32_t corners) {
  IndexedMesh list = cup(corners, 1.5, 1);
  const auto first = static_cast<std::uint32_t>(list.positions.size());
  for (const glm::dvec3& p : {glm::dvec3(0.1, 0.2, 0.5), glm::dvec3(0.3, -0.2, 2), glm::dvec3(-0.2, 0.1, 2.5)})
    list.positions.push_back(p);
  for (std::uint32_t k = 0; k < 3; ++k) list.corners.push_back(first + k);
  list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  return list;
}

TEST(fill_obstacles, pierced_cups_of_all_sizes_are_filled_where_that_is_allowed) {
  for (const std::uint32_t corners : {3u, 4u, 7u, 16u, 60u, 310u})
    for (const Change change : {Change(as_it_is), Change(turned), Change(as_floats)}) {
      Mesh mesh = from_indexed(change(pierced_cup(corners)));
      EXPECT_EQ(filled_across(mesh).changed, 0u);
      const AlgorithmResult allowed = filled_across(mesh, "allow");
      EXPECT_EQ(allowed.changed, 1u) << allowed.text.en;
      EXPECT_GT(allowed.crossings.value_or(0), 0u);
      EXPECT_EQ(compute_figures(mesh)[ProblemKind::boundary_loop], 3u);
    }
}

TEST(fill_obstacles, what_need_not_cross_does_not_where_crossing_is_allowed) {
  Mesh plain = from_indexed(cup(16, 1.5, 1)), allowed = plain;
  filled_across(plain);
  EXPECT_EQ(filled_across(allowed, "allow").crossings, std::nullopt);
  EXPECT_EQ(plain.hash(), allowed.hash());
}

}  // namespace
}  // namespace ryosen::test
