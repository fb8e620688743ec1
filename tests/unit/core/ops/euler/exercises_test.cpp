// The solids of the source texts, built from nothing by the scripts in assets/exercises; the sum holds after each step.
#include <gtest/gtest.h>

#include <fstream>

#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"

namespace ryosen {
namespace {

struct Exercise {
  std::string name;
  std::int64_t vertices, edges, faces, rings, genus;
};

class Builder {
 public:
  void step(const std::string& line) {
    const ParsedOp parsed = parse_line(mesh, line);
    ASSERT_TRUE(parsed.op) << line << ": " << parsed.sentence.en;
    const Verdict verdict = check(mesh, *parsed.op);
    ASSERT_TRUE(verdict.legal()) << line << ": " << text_of(verdict.reasons[0].rule).en;
    const ParsedOp again = parse_line(mesh, command_of(mesh, *parsed.op));
    ASSERT_TRUE(again.op) << command_of(mesh, *parsed.op) << ": " << again.sentence.en;
    EXPECT_EQ(command_of(mesh, *again.op), command_of(mesh, *parsed.op));
    Edit edit(mesh, &journal);
    apply(edit, *parsed.op);
    edit.commit();
    const auto broken = check_invariants(mesh);
    ASSERT_FALSE(broken) << line << ": " << broken->sentence;
    const EulerPoincare e = euler_poincare(mesh);
    ASSERT_TRUE(e.holds()) << line;
    hashes.push_back(mesh.hash());
  }

  void replay(const std::string& path) {
    std::ifstream in(path);
    ASSERT_TRUE(in) << path;
    hashes.push_back(mesh.hash());
    for (std::string line; std::getline(in, line);) {
      if (line.empty() || line[0] == '#' || line.starts_with("expect")) continue;
      ASSERT_NO_FATAL_FAILURE(step(line));
    }
  }

  Mesh mesh;
  Journal journal;
  std::vector<std::uint64_t> hashes;
};

class ExerciseTest : public testing::TestWithParam<Exercise> {};

TEST_P(ExerciseTest, is_built_and_undone) {
  const Exercise& expected = GetParam();
  Builder b;
  ASSERT_NO_FATAL_FAILURE(b.replay(RYOSEN_SOURCE_DIR "/assets/exercises/" + expected.name + ".ryosen"));
  const EulerPoincare e = euler_poincare(b.mesh);
  EXPECT_EQ(e.vertices, expected.vertices);
  EXPECT_EQ(e.edges, expected.edges);
  EXPECT_EQ(e.faces, expected.faces);
  EXPECT_EQ(e.rings, expected.rings);
  EXPECT_EQ(e.genus, expected.genus);
  EXPECT_EQ(e.parts, 1);
  const bool is_solid = expected.faces > 1;
  EXPECT_EQ(e.boundary_loops, is_solid ? 0 : 1);
  EXPECT_EQ(e.wire_cycles + e.isolated, 0);
  const Figures figures = compute_figures(b.mesh);
  EXPECT_EQ(figures.closed, is_solid);
  EXPECT_TRUE(figures.manifold && figures.orientable);
  EXPECT_EQ(figures.genus, expected.genus);
  EXPECT_EQ(figures.rings, static_cast<std::uint64_t>(expected.rings));
  if (is_solid) {
    EXPECT_GT(figures.volume.value(), 0) << "the faces look outwards";
  }

  for (std::size_t i = b.hashes.size() - 1; b.journal.can_undo(); --i) {
    EXPECT_EQ(b.mesh.hash(), b.hashes[i]);
    b.journal.undo(b.mesh);
  }
  EXPECT_TRUE(b.mesh.columns() == MeshColumns());
  while (b.journal.can_redo()) b.journal.redo(b.mesh);
  EXPECT_EQ(b.mesh.hash(), b.hashes.back());
}

INSTANTIATE_TEST_SUITE_P(texts, ExerciseTest,
                         testing::Values(Exercise{"triangle", 3, 3, 1, 0, 0}, Exercise{"square", 4, 4, 1, 0, 0},
                                         Exercise{"triangular_pyramid", 4, 6, 4, 0, 0},
                                         Exercise{"cube", 8, 12, 6, 0, 0}, Exercise{"cube_with_hole", 16, 24, 10, 2, 1},
                                         Exercise{"cube_with_two_holes", 24, 36, 14, 4, 2}),
                         [](const auto& row) { return row.param.name; });

TEST(exercise, volumes_are_those_of_the_solids_with_their_holes) {
  Builder b;
  ASSERT_NO_FATAL_FAILURE(b.replay(RYOSEN_SOURCE_DIR "/assets/exercises/cube_with_hole.ryosen"));
  const Figures figures = compute_figures(b.mesh);
  EXPECT_NEAR(figures.volume.value(), 27 - 3, 1e-12);
  EXPECT_NEAR(figures.area, 4 * 9 + 4 * 3 + 2 * (9 - 1), 1e-12);
}

}  // namespace
}  // namespace ryosen
