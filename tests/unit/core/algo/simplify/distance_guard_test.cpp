// Simplification within a distance: what it promises, judged by dense samples, slow distances and surface_distance().
#include "ryosen/algo/simplify/distance_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/base/number_text.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/holed_shapes.h"
#include "tests/support/core/kept_distance.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

Mesh bumpy_torus() {
  return shaken(cut_in_triangles(made_by("torus radius=1 tube=0.4 segments=16 tube_segments=8")), 0.01, 11);
}

double rolling_hills(std::uint32_t x, std::uint32_t y) { return std::sin(0.7 * x) + std::cos(0.5 * y); }

std::string within_distance(double most) { return "max_distance=" + std::to_string(most); }

TEST(distance_guard, leaves_few_faces) {
  const auto faces_within = [](Mesh mesh, const std::string& values) {
    simplified(mesh, values);
    return mesh.live().faces;
  };
  Mesh box = cut_in_triangles(made_by("cube size=2"));
  Journal journal;
  run_algorithm(box, journal, "subdivide scheme=midpoint steps=3");
  EXPECT_LE(faces_within(box, "max_distance=0.00001"), 20u) << "flat sides are 12 faces";
  EXPECT_LE(faces_within(sheet(16, [](std::uint32_t, std::uint32_t) { return 1.0; }), "max_distance=0.00001"), 8u);
  EXPECT_LE(faces_within(cut_in_triangles(made_by("sphere radius=1")), "max_distance=5%"), 60u);
  EXPECT_LE(faces_within(bumpy_torus(), "max_distance=2%"), 120u);
  EXPECT_LE(faces_within(doubled(sheet(12, rolling_hills), {0, 0, 0.15}), "max_distance=5"), 16u);
}

TEST(distance_guard, keeps_random_meshes_within_the_distance) {
  std::size_t changed = 0;
  for (std::uint64_t seed = 1; seed <= 60 && !testing::Test::HasFailure(); ++seed) {
    const SeededMesh seeded = seeded_mesh(seed);
    const Mesh before = cut_in_triangles(make_mesh(seeded.faces, seeded.points));
    if (!has_surface(before)) continue;
    const double most = (seed % 3 == 0 ? 0.3 : 0.05) * size_of_surface(before);
    if (!(most > 0)) continue;
    Mesh mesh = before;
    const AlgorithmResult result = simplified(mesh, within_distance(most));
    if (result.refused || result.changed == 0) continue;
    ++changed;
    expect_kept_within(before, mesh, most, "seed " + std::to_string(seed));
  }
  EXPECT_GT(changed, 10u);
}

TEST(distance_guard, stops_at_what_comes_first) {
  const Mesh before = sheet(16, rolling_hills);
  Mesh by_number = before, by_distance = before, by_both = before, by_error = before;
  const AlgorithmResult number = simplified(by_number, "faces=300 max_distance=1"),
                        alone = simplified(by_distance, "max_distance=0.05"),
                        both = simplified(by_both, "faces=4 max_distance=0.05"),
                        error = simplified(by_error, "error=0.0001 max_distance=5");
  EXPECT_EQ(number.goal_report->stopped, Stop::goal);
  EXPECT_LE(by_number.live().faces, 300u);
  EXPECT_EQ(alone.goal_report->stopped, Stop::distance);
  EXPECT_TRUE(alone.goal_report->is_reached) << "it is the only goal";
  EXPECT_NE(alone.text.en.find("; more would go beyond the distance."), std::string::npos) << alone.text.en;
  EXPECT_GT(count_of(alone, EdgeRule::distance), 0u);
  EXPECT_EQ(both.goal_report->stopped, Stop::distance);
  EXPECT_FALSE(both.goal_report->is_reached);
  EXPECT_EQ(by_both.columns(), by_distance.columns());
  EXPECT_EQ(error.goal_report->stopped, Stop::error);
}

TEST(distance_guard, takes_shares_of_the_diagonal) {
  const Mesh before = sheet(16, rolling_hills);
  Mesh percent = before, share = before, units = before;
  simplified(percent, "max_distance=0.5%");
  simplified(share, "max_distance=0.005 relative=on");
  simplified(units, "max_distance=0.005");
  EXPECT_EQ(percent.columns(), share.columns());
  EXPECT_LT(percent.live().faces, units.live().faces);
}

TEST(distance_guard, does_nothing_within_no_distance) {
  Mesh mesh = sheet(8, rolling_hills);
  const AlgorithmResult result = simplified(mesh, "max_distance=0");
  EXPECT_EQ(result.changed, 0u);
  EXPECT_EQ(result.goal_report->stopped, Stop::distance);
}

TEST(distance_guard, is_kept_by_every_effort_and_beside_other_limits) {
  const Mesh before = bumpy_torus();
  const double most = 0.06;
  for (const char* const further : {" effort=0", " effort=2", " no_self_intersections=on", " remove_small=on",
                                    " boundary=free max_turn=40", " seams=drop min_angle=5"}) {
    Mesh mesh = before;
    const AlgorithmResult result = simplified(mesh, within_distance(most) + further);
    ASSERT_FALSE(result.refused) << further;
    EXPECT_LT(mesh.live().faces, before.live().faces / 2) << further;
    expect_kept_within(before, mesh, most, further);
  }
}

TEST(distance_guard, is_measured_from_polygons_as_they_are_drawn) {
  Mesh squares = made_by("torus radius=1 tube=0.4 segments=24 tube_segments=12"), refused = squares;
  const Mesh before = squares;
  const AlgorithmResult without = simplified(refused, "max_distance=2%");
  ASSERT_TRUE(without.refused);
  EXPECT_NE(without.refused->en.find("triangulate"), std::string::npos) << without.refused->en;
  EXPECT_EQ(refused.columns(), before.columns());
  ASSERT_FALSE(simplified(squares, "max_distance=0.05 triangulate=on").refused);
  EXPECT_LT(squares.live().faces, 300u);
  expect_kept_within(before, squares, 0.05, "squares");
}

// A saddle is cut along its other diagonal where an edge is on the first one, and then lies elsewhere.
TEST(distance_guard, is_refused_where_cutting_polygons_alone_exceeds_it) {
  std::size_t refused = 0;
  for (const std::vector<std::uint32_t>& on_diagonal : {std::vector<std::uint32_t>{0, 2, 4}, {1, 3, 4}}) {
    IndexedMesh source = indexed({{0, 1, 2, 3}, on_diagonal}, 5);
    source.positions = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}, {0.5, 0.5, 5}};
    const Mesh before = from_indexed(source);
    for (const double most : {1e-9, 0.01, 0.1, 2.0, 5.0}) {
      Mesh mesh = before;
      const AlgorithmResult result = simplified(mesh, "triangulate=on max_distance=" + format_double(most));
      if (!result.refused) {
        expect_kept_within(before, mesh, most, format_double(most));
        continue;
      }
      ++refused;
      EXPECT_LT(most, 1);
      EXPECT_NE(result.refused->en.find("give a max_distance above that"), std::string::npos) << result.refused->en;
      EXPECT_EQ(mesh.columns(), before.columns());
    }
  }
  EXPECT_EQ(refused, 3u);
}

// A polygon with a corner at no place is not measured, but triangles that it is cut into may be.
TEST(distance_guard, is_refused_where_polygons_are_measured_only_when_they_are_cut) {
  for (const std::uint32_t n : {5u, 6u, 7u, 8u, 9u}) {
    IndexedMesh source = indexed({{}}, n);
    source.corners.resize(n);
    std::iota(source.corners.begin(), source.corners.end(), 0u);
    source.face_offsets = {0, n};
    for (std::uint32_t i = 0; i < n; ++i) source.positions[i] = {std::cos(6.283 * i / n), std::sin(6.283 * i / n), 0.0};
    Mesh mesh = from_indexed(source);
    Edit edit(mesh, nullptr);
    edit.set_position(Vertex(2), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    edit.commit();
    const Mesh before = mesh;
    const AlgorithmResult result = simplified(mesh, "triangulate=on max_distance=5");
    ASSERT_TRUE(result.refused) << n;
    EXPECT_EQ(result.refused->en.substr(0, 3), "v2 ") << result.refused->en;
    EXPECT_NE(result.refused->en.find("give_places"), std::string::npos) << result.refused->en;
    EXPECT_EQ(mesh.columns(), before.columns());
  }
}

TEST(distance_guard, keeps_small_parts) {
  for (const double size : {0.0001, 0.001, 0.003, 0.01, 0.03}) {
    IndexedMesh source = rows_of_spheres(1, 2.2);
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
      source.positions.push_back(glm::dvec3(5, 0, 0) + size * p);
    for (const std::array<std::uint32_t, 3>& face :
         {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {1u, 2u, 3u}, {2u, 0u, 3u}}) {
      for (const std::uint32_t corner : face) source.corners.push_back(first + corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
    const Mesh before = from_indexed(source);
    Mesh removed = before, kept = before;
    simplified(removed, "faces=4 error=0.1 remove_small=on");
    simplified(kept, "faces=4 error=0.1 max_distance=0.1 remove_small=on");
    EXPECT_EQ(compute_figures(removed).components, 1u) << size;
    EXPECT_EQ(compute_figures(kept).components, 2u) << size;
    expect_kept_within(before, kept, 0.1, std::to_string(size));
  }
}

TEST(distance_guard, leaves_out_what_has_no_place) {
  Mesh before = sheet(12, wave);
  Edit edit(before, nullptr);
  edit.set_position(Vertex(40), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  edit.commit();
  Mesh mesh = before;
  simplified(mesh, "max_distance=0.3");
  EXPECT_LT(mesh.live().faces, before.live().faces / 2);
  expect_kept_within(before, mesh, 0.3, "without a place");
}

TEST(distance_guard, holds_on_every_level_of_detail) {
  const Mesh before = sheet(12, rolling_hills);
  const ParameterValues values =
      *read_values(find_algorithm("simplify")->parameters, split_words("max_distance=0.2")).values->on(before).values;
  Progress unheard;
  const BuiltLevels built = build_levels(before, {values}, unheard);
  ASSERT_TRUE(built.levels);
  ASSERT_GT(built.levels->last(), 50u);
  for (std::size_t level = 0; level <= built.levels->last(); level += 40) {
    built.levels->go_to(level);
    expect_kept_within(before, built.levels->mesh(), 0.2, std::to_string(level));
  }
}

TEST(distance_guard, costs_about_the_same_for_each_face_of_larger_meshes) {
  const auto looks = [](std::uint32_t side) {
    Mesh mesh = sheet(side, [&](std::uint32_t x, std::uint32_t y) {
      return 0.05 * side * (std::sin(6.0 * x / side) + std::cos(5.0 * y / side));
    });
    SimplifyGoal goal;
    goal.most_distance = 0.01 * side;
    Simplifier simplifier(mesh, {}, goal);
    Progress unheard;
    simplifier.run(unheard);
    return static_cast<double>(simplifier.looked_at()) / (2.0 * side * side);
  };
  const double small = looks(8), middle = looks(16), large = looks(32);
  EXPECT_LT(middle, 1.5 * small);
  EXPECT_LT(large, 1.5 * middle);
}

// Pairs that are proved otherwise by now are dropped, also from faces that did not change since.
TEST(distance_guard, lists_few_faces_for_each_triangle_after_many_collapses) {
  struct Listed {
    Mesh input;
    double most_for_each;
  };
  const Listed all[] = {{sheet(16, [](std::uint32_t, std::uint32_t) { return 1.0; }), 1.1},
                        {sheet(16, rolling_hills), 1.45},
                        {shaken(sheet(16, rolling_hills), 0.1, 3), 1.4},
                        {bumpy_torus(), 1.65},
                        {cut_in_triangles(made_by("sphere radius=1")), 1.6}};
  for (const Listed& listed : all) {
    const Mesh& input = listed.input;
    Mesh mesh = input;
    const ScaledPlaces scale(input.positions());
    DistanceGuard guard(mesh, scale, 0.02 * size_of_surface(input));
    const std::size_t faces = input.live().faces;
    EXPECT_EQ(guard.entries(), faces) << "each at itself";
    std::size_t collapsed = 0;
    for (int round = 0; round < 4; ++round)
      for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
        const CollapseEdge collapse{halfedge(Edge(e))};
        if (!mesh.is_alive(Edge(e)) || !collapse.is_legal(mesh)) continue;
        const glm::dvec3 place = mesh.position(mesh.to(halfedge(Edge(e))));
        if (guard.collapse_may_exceed(halfedge(Edge(e)), place)) continue;
        guard.follow();
        Edit edit(mesh, nullptr);
        collapse.apply(edit);
        edit.commit();
        ++collapsed;
      }
    EXPECT_GT(collapsed, faces / 10);
    EXPECT_GE(guard.entries(), faces) << "each is near something";
    EXPECT_LT(static_cast<double>(guard.entries()), listed.most_for_each * static_cast<double>(faces));
  }
}

TEST(distance_guard, keeps_meshes_of_others_within_the_distance) {
  const std::filesystem::path folder = std::filesystem::path(RYOSEN_SHARED_DIR) / "meshes/cgal/data/meshes";
  for (const char* const name : {"anchor.off", "eight.off"}) {
    const auto file = read_mesh_file(folder / name);
    if (!file) continue;
    const Mesh before = cut_in_triangles(from_indexed(file->mesh));
    Mesh mesh = before;
    const double most = 0.02 * size_of_surface(before);
    if (simplified(mesh, within_distance(most)).refused) continue;
    EXPECT_LT(mesh.live().faces, before.live().faces) << name;
    expect_kept_within(before, mesh, most, name);
  }
}

}  // namespace
}  // namespace ryosen::test
