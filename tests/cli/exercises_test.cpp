// The exercises of the source texts: replayed by `edit --new`, confirmed by `check`.
#include <gtest/gtest.h>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

struct Exercise {
  std::string name;
  int vertices, edges, faces, rings, genus, exit_code;
};

class ExerciseScriptTest : public testing::TestWithParam<Exercise> {};

TEST_P(ExerciseScriptTest, is_replayed_and_confirmed) {
  const Exercise& expected = GetParam();
  const TemporaryFolder folder;
  const std::string out = folder.at(expected.name + ".obj");
  const std::string script = std::string(RYOSEN_SOURCE_DIR "/assets/exercises/") + expected.name + ".ryosen";
  const ProgramRun edit = run_program({"edit", "--new", "--script", script, "-o", out});
  ASSERT_EQ(edit.exit_code, 0) << edit.err;
  const ProgramRun check = run_program({"check", out, "--json"});
  EXPECT_EQ(check.exit_code, 0) << check.out;
  const Json json = check.line();
  EXPECT_EQ(json["vertices"], expected.vertices);
  EXPECT_EQ(json["edges"], expected.edges);
  EXPECT_EQ(json["faces"], expected.faces);
  EXPECT_EQ(json["rings"], expected.rings);
  EXPECT_EQ(json["genus"], expected.genus);
}

TEST(exercises, the_triangle_stands_where_the_sample_program_puts_it) {
  const TemporaryFolder folder;
  const std::string out = folder.at("triangle.off");
  ASSERT_EQ(run_program({"edit", "--new", "--script", RYOSEN_SOURCE_DIR "/assets/exercises/triangle.ryosen", "-o", out})
                .exit_code,
            0);
  EXPECT_EQ(read_file(out), "OFF\n3 1 0\n0 10 0\n-10 -10 0\n10 -10 0\n3 0 1 2\n");
}

INSTANTIATE_TEST_SUITE_P(texts, ExerciseScriptTest,
                         testing::Values(Exercise{"triangle", 3, 3, 1, 0, 0, 0}, Exercise{"square", 4, 4, 1, 0, 0, 0},
                                         Exercise{"triangular_pyramid", 4, 6, 4, 0, 0, 0},
                                         Exercise{"cube", 8, 12, 6, 0, 0, 0},
                                         Exercise{"cube_with_hole", 16, 24, 10, 2, 1, 0},
                                         Exercise{"cube_with_two_holes", 24, 36, 14, 4, 2, 0}),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace ryosen::test
