// Edits of the bunny: the counts that each operator states, inside and on the boundary, and refusals that leave
// nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <unordered_set>

#include "tests/support/app/contract.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

struct EditCase {
  const char* name;
  const char* command;
  int vertices, edges, faces;  // changes
};

class BunnyEdit : public testing::TestWithParam<EditCase> {};

TEST_P(BunnyEdit, changes_counts_in_the_written_file) {
  const TemporaryFolder folder;
  const std::string bunny = asset("stanford_bunny.obj");
  const ProgramRun edit =
      run_program({"edit", bunny, "--do", GetParam().command, "-o", "out.obj", "--json"}, folder.path());
  ASSERT_EQ(edit.exit_code, 0) << edit.err;
  const Json last = edit.lines().back();
  const Json written = run_program({"check", folder.at("out.obj"), "--json"}).line();
  for (const Json* report : {&last, &written}) {
    EXPECT_EQ((*report)["vertices"], 34834 + GetParam().vertices);
    EXPECT_EQ((*report)["edges"], 104288 + GetParam().edges);
    EXPECT_EQ((*report)["faces"], 69451 + GetParam().faces);
  }
  EXPECT_EQ(written["status"], "ok");
  EXPECT_EQ(written["boundary_loops"], 5);
  EXPECT_EQ(written["euler_characteristic"], -3);
}

INSTANTIATE_TEST_SUITE_P(Bunny, BunnyEdit,
                         testing::Values(EditCase{"collapse_inside", "collapse 8640-8282", -1, -3, -2},
                                         EditCase{"collapse_on_boundary", "collapse 1-2 mid", -1, -2, -1},
                                         EditCase{"swap", "swap 8640-8282", 0, 0, 0},
                                         EditCase{"split_inside", "split 8640-8282 0.25", 1, 3, 2},
                                         EditCase{"split_on_boundary", "split 1-2", 1, 2, 1}),
                         [](const auto& test) { return test.param.name; });

struct RefusedCase {
  const char* name;
  const char* command;
  const char* rule;
};

class BunnyRefusal : public testing::TestWithParam<RefusedCase> {};

TEST_P(BunnyRefusal, names_the_rule_and_writes_nothing) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"edit", asset("stanford_bunny.obj"), "--do", GetParam().command, "-o", "out.obj"}, folder.path());
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_NE(run.err.find(GetParam().rule), std::string::npos) << run.err;
  EXPECT_TRUE(folder.names().empty());
}

INSTANTIATE_TEST_SUITE_P(Bunny, BunnyRefusal,
                         testing::Values(RefusedCase{"collapse", "collapse 3167-3168", "common_neighbour"},
                                         RefusedCase{"swap", "swap 1-2", "boundary"}),
                         [](const auto& test) { return test.param.name; });

// The first of all lines that differ in their digits alone.
std::string one_of_each_line(const std::string& text) {
  std::unordered_set<std::string> seen;
  std::string lines, rest;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    rest.resize(end - begin);
    char* kept = rest.data();  // by pointers, which costs least where tests are not optimised
    for (const char *at = text.data() + begin, *const last = text.data() + end; at != last; ++at)
      if (*at < '0' || *at > '9') *kept++ = *at;
    rest.resize(static_cast<std::size_t>(kept - rest.data()));
    if (seen.insert(rest).second) lines.append(text, begin, end - begin);
  }
  return lines;
}

TEST(bunny, every_edge_is_judged) {
  const std::vector<std::string> words{"why", asset("stanford_bunny.obj"), "--op", "collapse", "--all", "--json"};
  ProgramRun run = run_unchecked(words);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 2 * 104288);
  // The contract of 200,000 lines takes long.
  if (!is_long_run()) run.out = one_of_each_line(run.out);
  EXPECT_EQ(fault_of_run(words, run), "");
}

}  // namespace
}  // namespace ryosen::test
