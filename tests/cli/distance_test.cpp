// `distance`: two files, both directions, what is left out, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const std::string shifted = "v 0 0 0.25\nv 1 0 0.25\nv 1 1 0.25\nv 0 1 0.25\nf 1 2 3\nf 1 3 4\n";

TEST(distance_command, says_both_directions_and_shares_of_the_diagonal) {
  const TemporaryFolder folder;
  const std::string a = folder.write("a.obj", square), b = folder.write("b.obj", shifted);
  const ProgramRun run = run_program({"distance", a, b, "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json line = run.line();
  EXPECT_EQ(line["status"], "ok");
  EXPECT_EQ(line["file"], a);
  EXPECT_EQ(line["other"], b);
  EXPECT_NEAR(double(line["diagonal"]), std::sqrt(2), 1e-15);
  for (const Json& figures : {line, line["forward"], line["backward"]})
    for (const char* const key : {"rms", "mean", "hausdorff"}) {
      EXPECT_NEAR(double(figures[key]), 0.25, 1e-12) << key;
      EXPECT_NEAR(double(figures[std::string(key) + "_rel"]), 0.25 / std::sqrt(2), 1e-12) << key;
    }
  EXPECT_EQ(line["hausdorff_gap"], 0.0);
  EXPECT_EQ(line["forward"]["faces"], 1);
  EXPECT_EQ(line["backward"]["faces"], 2);
  EXPECT_EQ(line["forward"]["face"], "f0");
  EXPECT_EQ(line["forward"]["area"], 1.0);
  const std::string text = run_program({"distance", a, b, "--lang", "en"}).out;
  EXPECT_NE(text.find("0.25"), std::string::npos) << text;
  EXPECT_NE(text.find("17.6777"), std::string::npos) << text;
}

TEST(distance_command, of_a_file_from_itself_is_nothing) {
  const Json line =
      run_program({"distance", asset("stanford_bunny.obj"), asset("stanford_bunny.obj"), "--json"}).line();
  for (const char* const key : {"rms", "mean", "hausdorff", "hausdorff_gap"}) EXPECT_EQ(line[key], 0.0) << key;
  EXPECT_EQ(line["forward"]["left_out"], 0);
}

TEST(distance_command, says_what_it_leaves_out) {
  const TemporaryFolder folder;
  const std::string a = folder.write("a.obj", square + "v 1e999 0 0\nf 1 2 5\nf 1 1 2\n");
  const ProgramRun run = run_program({"distance", a, folder.write("b.obj", shifted), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json line = run.line();
  EXPECT_EQ(line["status"], "warnings");
  EXPECT_EQ(line["forward"]["faces"], 1);
  EXPECT_EQ(line["forward"]["left_out"], 2);
  EXPECT_EQ(line["backward"]["left_out"], 0);
  EXPECT_NEAR(double(line["hausdorff"]), 0.25, 1e-12);
  EXPECT_FALSE(line["messages"].empty());
  const std::string text = run_program({"distance", a, folder.at("b.obj"), "--lang", "en"}).out;
  EXPECT_NE(text.find("2 faces of " + a), std::string::npos) << text;
}

TEST(distance_command, refuses_what_it_cannot_measure) {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.obj", square), empty = folder.write("empty.obj", "v 0 0 0\nv 1 0 0\n");
  const std::string bad = folder.write("bad.obj", "v 0 0 x\n");
  const std::vector<std::pair<std::vector<std::string>, int>> wrong = {
      {{"distance", good}, 2},
      {{"distance", good, good, good}, 2},
      {{"distance", good, empty}, 6},
      {{"distance", empty, good}, 6},
      {{"distance", good, "nosuch.obj"}, 3},
      {{"distance", bad, good}, 4},
      {{"distance", good, good, "--gap", "0"}, 2},
      {{"distance", good, good, "--gap", "nan"}, 2},
      {{"distance", good, good, "--gap", "-1"}, 2},
      {{"distance", good, good, "--gap", "1e300"}, 2},
      {{"distance", good, good, "--samples", "0"}, 2},
      {{"distance", good, good, "--samples", "2.5"}, 2},
      {{"distance", good, good, "--samples", "1e9"}, 2}};
  for (const auto& [line, exit_code] : wrong) {
    const ProgramRun run = run_program(line);
    EXPECT_EQ(run.exit_code, exit_code) << line.back();
    EXPECT_FALSE(run.err.empty()) << line.back();
    EXPECT_TRUE(run.out.empty()) << line.back();
  }
}

TEST(distance_command, has_no_share_of_no_diagonal_and_no_number_that_is_none) {
  const TemporaryFolder folder;
  const std::string point = folder.write("point.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
  const std::string far = folder.write("far.obj", "v 1.7e308 0 0\nv 1.7e308 1 0\nv 1.7e308 1.7e308 1\nf 1 2 3\n");
  const std::string other = folder.write("other.obj", "v -1.7e308 0 0\nv -1.7e308 1 0\nv -1.7e308 1 1\nf 1 2 3\n");
  const Json line = run_program({"distance", point, folder.write("b.obj", shifted), "--json"}).line();
  EXPECT_TRUE(line["rms_rel"].is_null());
  EXPECT_EQ(line["diagonal"], 0.0);
  const ProgramRun run = run_program({"distance", far, other, "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.line()["hausdorff"].is_null());
  EXPECT_EQ(run_program({"distance", far, other}).exit_code, 0);
}

}  // namespace
}  // namespace ryosen::test
