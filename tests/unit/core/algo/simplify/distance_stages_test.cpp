// All that simplification does after collapses stays within the distance as well: moves, swaps, mended faces, closed
// handles and joined parts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/base/parallel.h"
#include "tests/support/core/holed_shapes.h"
#include "tests/support/core/kept_distance.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

struct Stages {
  Mesh mesh;
  std::size_t moves = 0, swaps = 0, turned = 0, still_turned = 0, closed = 0, joined = 0;
};

Stages kept_by_simplifier(const Mesh& input, const SimplifyGoal& goal, const std::string& name) {
  Stages stages{input};
  Progress unheard;
  Simplifier simplifier(stages.mesh, {}, goal, nullptr, &input);
  EXPECT_TRUE(simplifier.run(unheard)) << name;
  const auto broken = check_invariants(stages.mesh);
  EXPECT_FALSE(broken) << name;
  if (!simplifier.is_at_goal()) {
    const auto left = count_remaining(stages.mesh, find_remaining(stages.mesh, simplifier, unheard));
    EXPECT_EQ(left[static_cast<std::size_t>(EdgeRule::free)], 0u) << name;
  }
  expect_kept_within(input, stages.mesh, goal.most_distance, name);
  stages.moves = simplifier.moves(), stages.swaps = simplifier.swaps(), stages.turned = simplifier.turned();
  stages.still_turned = simplifier.still_turned(), stages.closed = simplifier.closed_handles();
  stages.joined = simplifier.joined_parts();
  return stages;
}

TEST(distance_stages, keep_every_mesh_within_the_distance_both_ways) {
  const std::vector<NamedMesh> meshes = meshes_to_keep();
  ASSERT_EQ(meshes.size(), 30u);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (const std::size_t k : {i % 3, (i + 1) % 3}) {
      constexpr std::array shares{0.001, 0.01, 0.05};
      const Mesh& before = meshes[i].mesh;
      const auto effort = static_cast<unsigned>((i / 3 + k) % 3);
      const std::string name =
          meshes[i].name + " within " + std::to_string(shares[k]) + ", effort " + std::to_string(effort);
      const SimplifyGoal goal{.effort = effort, .most_distance = shares[k] * size_of_surface(before)};
      const Stages after = kept_by_simplifier(before, goal, name);
      EXPECT_TRUE(k == 0 || after.mesh.live().faces < before.live().faces) << name;
      const Figures was = compute_figures(before), is = compute_figures(after.mesh);
      EXPECT_EQ(is.components, was.components) << name;
      EXPECT_EQ(is.euler_characteristic, was.euler_characteristic) << name;
      EXPECT_EQ(is.boundary_loops, was.boundary_loops) << name;
    }
}

double rms_from(const Mesh& input, const Mesh& mesh) {
  Progress unheard;
  return surface_distance(input, mesh, {.gap = 1, .samples = 5000}, unheard)->rms;
}

TEST(distance_stages, moves_and_swaps_stay_within_the_distance_and_bring_nearer) {
  const Mesh inputs[] = {from_indexed(torus_at_places(16, 8, 2, 0.7)),
                         cut_in_triangles(made_by("sphere segments=14 bands=8")),
                         sheet(10, [](std::uint32_t x, std::uint32_t y) { return std::sin(0.5 * x) + 0.1 * y * y; }),
                         stretched(from_indexed(torus_at_places(16, 8, 2, 0.7)), {1, 3, 0.5}),
                         shaken(from_indexed(torus_at_places(16, 8, 2, 0.7)), 0.03, 2)};
  std::size_t moves = 0, swaps = 0, nearer = 0;
  for (const Mesh& input : inputs) {
    const double most = 0.02 * size_of_surface(input);
    const std::string name = std::to_string(&input - inputs);
    const Stages none = kept_by_simplifier(input, {.effort = 0, .most_distance = most}, name),
                 one = kept_by_simplifier(input, {.effort = 1, .most_distance = most}, name),
                 two = kept_by_simplifier(input, {.effort = 2, .most_distance = most}, name);
    EXPECT_EQ(none.moves + none.swaps + one.swaps, 0u) << name;
    moves += one.moves + two.moves;
    swaps += two.swaps;
    EXPECT_LE(one.mesh.live().faces, none.mesh.live().faces) << name;
    nearer += rms_from(input, one.mesh) < rms_from(input, none.mesh);
  }
  EXPECT_GT(moves, 100u);
  EXPECT_GT(swaps, 3u);
  EXPECT_GE(nearer, 4u);
}

double farthest_from(const Mesh& input, const Mesh& mesh) {
  Progress unheard;
  return surface_distance(input, mesh, {.samples = 500}, unheard)->hausdorff;
}

Mesh simplified_to(const Mesh& input, std::size_t faces, unsigned effort) {
  Mesh mesh = input;
  Progress unheard;
  Simplifier(mesh, {}, {.faces = faces, .effort = effort}, nullptr, &input).run(unheard);
  return mesh;
}

// The distance is little more than what collapses alone use, so that mending goes beyond it where nothing hinders it.
TEST(distance_stages, mended_faces_stay_within_the_distance) {
  std::size_t turned = 0, mended = 0, beyond = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const Mesh input = shaken(sheet(14, wave), 0.6, seed);
    const std::size_t faces = input.live().faces / 3;
    const double most = 1.02 * farthest_from(input, simplified_to(input, faces, 0));
    beyond += farthest_from(input, simplified_to(input, faces, 1)) > most;
    const Stages stages = kept_by_simplifier(input, {.faces = faces, .most_distance = most}, std::to_string(seed));
    turned += stages.turned;
    mended += stages.turned - stages.still_turned;
  }
  EXPECT_GT(turned, 40u) << "else there was nothing to mend";
  EXPECT_GT(mended, 30u);
  EXPECT_GE(beyond, 2u) << "else the distance hindered nothing";
}

TEST(distance_stages, handles_are_closed_within_the_distance_alone) {
  for (const std::uint32_t holes : {1u, 2u, 3u}) {
    const Mesh input = from_indexed(plate_with_holes(holes));
    const std::string name = std::to_string(holes) + " holes";
    EXPECT_GT(kept_by_simplifier(input, {.faces = 8, .changes_topology = true, .most_distance = 1.5}, name).closed, 0u);
    EXPECT_EQ(kept_by_simplifier(input, {.faces = 8, .changes_topology = true, .most_distance = 0.1}, name).closed, 0u);
  }
}

TEST(distance_stages, parts_are_joined_within_the_distance_alone) {
  for (const std::uint32_t count : {2u, 3u, 4u}) {
    const Mesh input = from_indexed(rows_of_spheres(count, 2.2));
    const std::string name = std::to_string(count) + " spheres";
    const SimplifyGoal wide{.faces = 2 * count, .changes_topology = true, .most_distance = 1.5},
        narrow{.faces = 2 * count, .changes_topology = true, .most_distance = 0.05};
    EXPECT_GT(kept_by_simplifier(input, wide, name).joined, 0u) << name;
    EXPECT_EQ(kept_by_simplifier(input, narrow, name).joined, 0u) << name;
  }
}

TEST(distance_stages, are_the_same_for_any_number_of_threads_and_undone_to_the_byte) {
  const Mesh inputs[] = {from_indexed(torus_at_places(14, 7, 2, 0.7)), from_indexed(rows_of_spheres(2, 2.2)),
                         shaken(sheet(9, wave), 0.3, 9)};
  for (const Mesh& input : inputs)
    for (const char* const further : {" effort=2", " topology=change faces=20"}) {
      std::optional<MeshColumns> first;
      for (const unsigned threads : {1u, 3u}) {
        const ThreadCount count(threads);
        Mesh mesh = input;
        Journal journal;
        run_algorithm(mesh, journal, std::string("simplify max_distance=2%") + further);
        if (!first) first = mesh.columns();
        EXPECT_EQ(mesh.columns(), *first) << threads;
        ASSERT_TRUE(journal.can_undo());
        journal.undo(mesh);
        EXPECT_EQ(mesh.columns(), input.columns());
        journal.redo(mesh);
        EXPECT_EQ(mesh.columns(), *first);
      }
    }
}

TEST(distance_stages, leave_the_mesh_as_it_is_wherever_they_are_cancelled) {
  const AlgorithmRow& row = *find_algorithm("simplify");
  const Mesh inputs[] = {from_indexed(torus_at_places(20, 10, 2, 0.7)), from_indexed(rows_of_spheres(2, 2.2)),
                         from_indexed(torn_torus(20, 3)), shaken(sheet(16, wave), 0.3, 9), sheet(16, wave)};
  std::size_t cancelled = 0;
  Dice dice(4);
  for (const Mesh& input : inputs)
    for (int i = 0; i < 6; ++i) {
      Mesh mesh = input;
      Journal journal;
      int left = i < 2 ? i : dice.below(40);
      Progress cancelling([&](double) { return left-- > 0; }, Progress::Clock::duration::zero());
      const auto read = read_values(row.parameters, split_words("max_distance=2% topology=change effort=2"));
      const ParameterValues values = *read.values->on(mesh).values;
      Edit edit(mesh, &journal);
      const AlgorithmResult result = row.run(edit, {values}, cancelling);
      if (result.goal_report && result.goal_report->stopped != Stop::cancelled) continue;
      ++cancelled;
      EXPECT_EQ(result.changed, 0u);
      EXPECT_EQ(mesh.columns(), input.columns());
    }
  EXPECT_GT(cancelled, 15u);
}

}  // namespace
}  // namespace ryosen::test
