#include "ryosen/algo/simplify/simplify.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/invariants.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/triangulate.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

void expect_same_whichever_way(const Mesh& input, std::uint64_t seed) {
  DetailLevels levels(input);
  Progress unheard;
  ASSERT_TRUE(levels.build({}, {}, unheard));
  EXPECT_EQ(levels.level(), 0u);
  EXPECT_EQ(levels.mesh().columns(), input.columns());
  std::vector<MeshColumns> on_the_way{input.columns()};
  for (std::size_t i = 1; i <= levels.last(); ++i) {
    levels.go_to(i);
    on_the_way.push_back(levels.mesh().columns());
    EXPECT_EQ(levels.faces(i), levels.mesh().live().faces);
    EXPECT_LE(levels.faces(i), levels.faces(i - 1));
    EXPECT_FALSE(check_invariants(levels.mesh()));
  }
  Dice dice(seed);
  for (int i = 0; i < 40; ++i) {
    const auto level = static_cast<std::size_t>(dice.below(static_cast<int>(levels.last()) + 1));
    levels.go_to(level);
    ASSERT_EQ(levels.mesh().columns(), on_the_way[level]);
  }
  // The last one is what is simplified without a journal.
  Mesh at_once = input;
  Simplifier(at_once, {}, {}).run(unheard);
  levels.go_to(levels.last());
  EXPECT_EQ(levels.mesh().columns(), at_once.columns());
}

TEST(detail_levels, are_the_same_to_the_byte_whichever_way_they_are_reached) {
  expect_same_whichever_way(make_mesh(torus_grid(9, 11)), 1);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const SeededMesh seeded = seeded_mesh(seed);
    expect_same_whichever_way(make_mesh(seeded.faces, seeded.points), seed);
  }
}

TEST(detail_levels, are_found_by_their_faces) {
  DetailLevels levels(make_mesh(torus_grid(9, 11)));
  Progress unheard;
  ASSERT_TRUE(levels.build({}, {}, unheard));
  ASSERT_GT(levels.last(), 50u);
  EXPECT_EQ(levels.level_of(1000), 0u);
  EXPECT_EQ(levels.level_of(0), levels.last());
  for (std::size_t faces = levels.faces(levels.last()); faces <= levels.faces(0); ++faces) {
    const std::size_t level = levels.level_of(faces);
    EXPECT_LE(levels.faces(level), faces);
    EXPECT_TRUE(level == 0 || levels.faces(level - 1) > faces);
  }
}

// Small parts go as a whole, in a step of their own.
TEST(detail_levels, leave_small_parts_out) {
  Mesh input;
  Journal journal;
  run_algorithm(input, journal, "sphere radius=1");
  run_algorithm(input, journal, "sphere radius=0.001 at=3,0,0 segments=6 bands=4");
  Edit edit(input, nullptr);
  Triangulate{}.apply(edit);
  edit.commit();
  DetailLevels levels(input);
  Progress unheard;
  SimplifyGoal goal;
  goal.removes_small_parts = true;
  ASSERT_TRUE(levels.build({}, goal, unheard));
  levels.go_to(levels.last());
  for (const Vertex v : live_vertices(levels.mesh())) EXPECT_LT(levels.mesh().position(v).x, 2);
  levels.go_to(0);
  EXPECT_EQ(levels.mesh().columns(), input.columns());
}

TEST(detail_levels, are_none_where_it_was_cancelled) {
  const Mesh input = make_mesh(torus_grid(9, 11));
  DetailLevels levels(input);
  Progress cancelling([](double) { return false; }, Progress::Clock::duration::zero());
  EXPECT_FALSE(levels.build({}, {}, cancelling));
  EXPECT_EQ(levels.last(), 0u);
  EXPECT_EQ(levels.mesh().columns(), input.columns());
}

}  // namespace
}  // namespace ryosen::test
