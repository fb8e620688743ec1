#include "ryosen/algo/repair/side_effects.h"

#include <gtest/gtest.h>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/report.h"
#include "tests/support/core/boxes.h"
#include "tests/support/core/recipe_checks.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

std::vector<std::uint32_t> loose_behind(const Mesh& mesh, const std::string& kinds) {
  const RecipeResult result = *run_recipe(mesh, recipe_of(kinds).steps, {});
  std::vector<std::uint32_t> faces;
  for (const AlgorithmResult& step : result.steps)
    for (const LeftForReason& left : step.left_for)
      if (tells_of_loose_pieces(left))
        for (const Element& face : left.elements) faces.push_back(face.index);
  return faces;
}

// The corners at one place are one point.
Mesh merged(IndexedMesh list) {
  for (std::uint32_t& corner : list.corners)
    for (std::uint32_t i = 0; i < corner; ++i)
      if (list.positions[i] == list.positions[corner]) corner = i;
  return from_indexed(std::move(list));
}

TEST(loose_pieces, of_three_sheets_at_an_edge_the_one_set_free_comes_off) {
  EXPECT_EQ(loose_behind(make_mesh(fin()), "detach_nonmanifold"), (std::vector<std::uint32_t>{0}));
}

TEST(loose_pieces, a_fin_at_a_solid_comes_off_however_many_faces_it_has) {
  IndexedMesh list = Boxes().cube(0, 1).source();
  // A strip of triangles from the edge between its first two points.
  std::vector<std::uint32_t> points{0, 1};
  for (std::uint32_t i = 0; i < 9; ++i) {
    points.push_back(static_cast<std::uint32_t>(list.positions.size()));
    list.positions.emplace_back(i % 2, -1.0 - i, -1.0 - i);
    list.corners.insert(list.corners.end(), points.end() - 3, points.end());
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  const std::vector<std::uint32_t> loose = loose_behind(from_indexed(list), "orient,detach_nonmanifold");
  EXPECT_EQ(loose, std::vector<std::uint32_t>{6}) << "one piece of nine faces, more than the box has";
}

TEST(loose_pieces, solids_that_come_apart_are_none) {
  const Mesh two = merged(Boxes().add({0, 0, 0}, {1, 1, 1}).add({1, 1, 0}, {2, 2, 1}).source());
  EXPECT_EQ(loose_behind(two, "detach_nonmanifold"), std::vector<std::uint32_t>());
}

TEST(loose_pieces, what_was_apart_before_is_none) {
  EXPECT_EQ(loose_behind(make_mesh({{0, 1, 2}, {3, 4, 5}, {3, 4, 5}}), "remove_duplicates"),
            std::vector<std::uint32_t>());
  EXPECT_EQ(loose_behind(make_mesh(bow_tie()), "detach_nonmanifold").size(), 0u) << "it had two components";
}

TEST(loose_pieces, are_named_in_the_report_and_counted_as_no_other_element) {
  RepairCall call{{}, true};
  for (const std::string_view id : {"orient", "detach_nonmanifold"}) {
    const AlgorithmRow& row = *find_algorithm(id);
    call.steps.push_back({&row, ParameterValues(row.parameters)});
  }
  const Mesh mesh = make_mesh(fin());
  const RepairReport report = try_repair(mesh, call, {}, {}).value();
  EXPECT_EQ(report.others, 0u);
  EXPECT_NE(told(report, mesh).en.find("one face (f0): loose pieces that came off"), std::string::npos)
      << told(report, mesh).en;
}

}  // namespace
}  // namespace ryosen::test
