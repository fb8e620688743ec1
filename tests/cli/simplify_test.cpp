// `simplify`: its goals and how it ends, its account, what it leaves alone, and what it refuses.
#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <thread>

#include "ryosen/algo/edge_rules.h"
#include "tests/support/app/process.h"
#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

class Simplify : public testing::Test {
 protected:
  ProgramRun run(std::vector<std::string> words) {
    words.insert(words.begin(), "simplify");
    words.push_back("--json");
    return run_program(words);
  }
  // What the account says adds up, and what is said of the output is what `check` says of it.
  void expect_accounts(const Json& line, const std::string& output) {
    ASSERT_EQ(line["remaining"].size(), edge_rule_table().size());
    std::size_t sum = 0;
    for (const EdgeRuleRow& rule : edge_rule_table()) sum += line["remaining"][std::string(rule.id)].get<std::size_t>();
    EXPECT_EQ(sum, line["edges"].get<std::size_t>());
    const Json checked = run_program({"check", output, "--fail-on", "none", "--json"}).line();
    EXPECT_EQ(checked["faces"], line["faces_after"]);
    EXPECT_EQ(checked["edges"], line["edges"]);
  }

  TemporaryFolder folder_;
  std::string bunny_ = asset("stanford_bunny.obj");
  std::string output_ = folder_.at("out.off");
};

TEST_F(Simplify, ends_with_0_where_it_reaches_its_goal_and_accounts_for_every_edge) {
  const ProgramRun faces = run({bunny_, "-o", output_, "--faces", "1000"});
  EXPECT_EQ(faces.exit_code, 0) << faces.err;
  const Json line = faces.line();
  EXPECT_EQ(line["stopped"], "goal");
  EXPECT_EQ(line["status"], "ok");
  EXPECT_EQ(line["faces_before"], 69451);
  EXPECT_LE(line["faces_after"], 1000);
  EXPECT_GE(line["faces_after"], 998);
  EXPECT_GT(line["error_max"], 0.0);
  EXPECT_GT(line["remaining"]["free"], 0);
  expect_accounts(line, output_);
  const ProgramRun ratio = run({bunny_, "--ratio", "0.5"});
  EXPECT_EQ(ratio.exit_code, 0) << ratio.err;
  EXPECT_LE(ratio.line()["faces_after"], 34725);
  const ProgramRun error = run({bunny_, "-o", output_, "--overwrite", "--error", "0.001", "--relative"});
  EXPECT_EQ(error.exit_code, 0) << error.err;
  EXPECT_EQ(error.line()["stopped"], "error");
  EXPECT_EQ(error.line()["remaining"]["free"], 0);
  EXPECT_GT(error.line()["remaining"]["error"], 0);
  EXPECT_LE(error.line()["error_max"], 0.001 * 0.26) << "the diagonal is a little less";
  expect_accounts(error.line(), output_);
}

TEST_F(Simplify, takes_an_error_with_a_percent_sign_as_a_share_whether_it_is_said_or_not) {
  const Json share = run({bunny_, "--error", "0.01", "--relative"}).line();
  for (const std::vector<std::string>& further : {std::vector<std::string>{}, {"--relative"}}) {
    std::vector<std::string> words{bunny_, "--error", "1%"};
    words.insert(words.end(), further.begin(), further.end());
    EXPECT_EQ(run(words).line()["faces_after"], share["faces_after"]) << further.size();
  }
  EXPECT_GT(share["faces_after"], run({bunny_, "--error", "0.02", "--relative"}).line()["faces_after"]);
}

TEST_F(Simplify, keeps_a_distance_that_distance_confirms) {
  const std::string sphere = folder_.at("sphere.obj");
  ASSERT_EQ(run_program({"sphere", "-o", sphere, "--radius", "1"}).exit_code, 0);
  const ProgramRun kept = run({sphere, "-o", output_, "--max-distance", "0.05", "--triangulate", "--distance"});
  EXPECT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_EQ(kept.line()["stopped"], "distance");
  EXPECT_GT(kept.line()["remaining"]["distance"], 0);
  EXPECT_EQ(kept.line()["remaining"]["free"], 0);
  EXPECT_LE(kept.line()["distance"]["hausdorff"], 0.05);
  EXPECT_LT(kept.line()["faces_after"], 200);
  expect_accounts(kept.line(), output_);
  const ProgramRun both = run({sphere, "--faces", "10", "--max-distance", "5%", "--triangulate"});
  EXPECT_EQ(both.exit_code, 1) << both.err;
  EXPECT_EQ(both.line()["stopped"], "distance");
}

TEST_F(Simplify, ends_with_1_where_it_stops_before) {
  const ProgramRun error = run({bunny_, "--faces", "10", "--error", "0.0001", "--relative"});
  EXPECT_EQ(error.exit_code, 1) << error.err;
  EXPECT_EQ(error.line()["stopped"], "error");
  const ProgramRun blocked = run({asset("cube.obj"), "-o", output_, "--faces", "0", "--triangulate"});
  EXPECT_EQ(blocked.exit_code, 1) << blocked.err;
  EXPECT_EQ(blocked.line()["stopped"], "blocked");
  EXPECT_EQ(blocked.line()["remaining"]["free"], 0);
  expect_accounts(blocked.line(), output_);
}

TEST_F(Simplify, ends_with_1_where_more_would_lose_the_shape_and_goes_on_by_force) {
  const std::string fine = folder_.at("fine.obj");
  ASSERT_EQ(run_program({"subdivide", asset("cube.obj"), "--scheme", "midpoint", "--steps", "3", "-o", fine}).exit_code,
            0);
  const ProgramRun shape = run({fine, "-o", output_, "--faces", "6", "--triangulate"});
  EXPECT_EQ(shape.exit_code, 1) << shape.err;
  EXPECT_EQ(shape.line()["stopped"], "shape");
  EXPECT_EQ(shape.line()["faces_after"], 12);
  EXPECT_EQ(shape.line()["remaining"]["free"], 0);
  EXPECT_GT(shape.line()["remaining"]["error"], 0);
  expect_accounts(shape.line(), output_);
  const ProgramRun forced = run({fine, "--faces", "6", "--triangulate", "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_EQ(forced.line()["stopped"], "goal");
  const std::string misoriented =
      folder_.write("misoriented.obj",
                    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 5\nf 3 2 5\nf 3 4 5\nf 1 4 5\n"
                    "f 1 2 3\nf 3 1 4\n");
  const ProgramRun left = run({misoriented, "--faces", "4"});
  EXPECT_EQ(left.exit_code, 1) << left.err;
  EXPECT_EQ(left.line()["stopped"], "shape");
  EXPECT_EQ(left.line()["changed"], 0);
  EXPECT_NE(left.line()["en"].get<std::string>().find("orient"), std::string::npos);
  EXPECT_NE(left.line()["ja"].get<std::string>().find("orient"), std::string::npos);
  const std::string turned = folder_.at("turned.obj");
  ASSERT_EQ(run_program({"edit", misoriented, "--do", "orient", "-o", turned}).exit_code, 0);
  EXPECT_EQ(run({turned, "--faces", "4"}).line()["stopped"], "goal");
}

TEST_F(Simplify, without_an_output_is_a_trial) {
  const std::string before = read_file(bunny_);
  const ProgramRun trial = run({bunny_, "--faces", "5000"}), done = run({bunny_, "-o", output_, "--faces", "5000"});
  EXPECT_EQ(trial.exit_code, 0);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"out.off"}) << "of the second alone";
  EXPECT_EQ(read_file(bunny_), before);
  for (const char* const key : {"faces_after", "edges", "remaining", "error_max", "stopped"})
    EXPECT_EQ(trial.line()[key], done.line()[key]) << key;
}

TEST_F(Simplify, counts_faces_that_are_set_aside) {
  std::string sheet;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) sheet += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const int a = 5 * y + x + 1;
      sheet += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 6) + "\n";
      sheet += "f " + std::to_string(a) + " " + std::to_string(a + 6) + " " + std::to_string(a + 5) + "\n";
    }
  const std::string input = folder_.write("aside.obj", sheet + "f 1 1 2\nf 3 3 4\n"), output = folder_.at("o.obj");
  const ProgramRun done = run({input, "-o", output, "--faces", "10"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.line()["faces_before"], 34);
  EXPECT_LE(done.line()["faces_after"], 10) << "two of them set aside";
  const Json checked = run_program({"check", output, "--fail-on", "none", "--json"}).line();
  EXPECT_EQ(checked["faces"], done.line()["faces_after"]);
  EXPECT_EQ(checked["quarantined"], 2);
}

TEST_F(Simplify, refuses_what_it_cannot_do) {
  struct Refused {
    std::vector<std::string> words;
    int exit_code;
  };
  const std::string empty = folder_.write("empty.off", "OFF\n0 0 0\n"),
                    points = folder_.write("points.obj", "v 0 0 0\nv 1 0 0\n"),
                    malformed = folder_.write("bad.obj", "v 0 0 zero\nf 1 2 3\n");
  const std::vector<Refused> all{
      {{bunny_}, 2},
      {{bunny_, "--faces", "-1"}, 2},
      {{bunny_, "--faces", "1e300"}, 2},
      {{bunny_, "--faces", "nan"}, 2},
      {{bunny_, "--faces", "2.5"}, 2},
      {{bunny_, "--ratio", "1.5"}, 2},
      {{bunny_, "--ratio", "nan"}, 2},
      {{bunny_, "--error", "-0.5"}, 2},
      {{bunny_, "--error", "inf"}, 2},
      {{bunny_, "--max-distance", "-1%"}, 2},
      {{bunny_, "--faces", "10", "--max-turn", "0"}, 2},
      {{bunny_, "--faces", "10", "--max-turn", "91"}, 2},
      {{bunny_, "--faces", "10", "--min-angle", "61"}, 2},
      {{bunny_, "--faces", "10", "--effort", "3"}, 2},
      {{bunny_, "--faces", "10", "--boundary", "tied"}, 2},
      {{bunny_, "--faces", "10", "--select", "v99999999"}, 2},
      {{bunny_, "--faces", "10", "--lock", "q7"}, 2},
      {{folder_.at("none.obj"), "--faces", "10"}, 3},
      {{malformed, "--faces", "10"}, 4},
      {{empty, "--faces", "10"}, 6},
      {{points, "--faces", "10"}, 6},
      {{asset("cube.obj"), "--faces", "10", "--no-self-intersections"}, 6},
      {{asset("cube.obj"), "--max-distance", "1%"}, 6},
  };
  for (const Refused& one : all) {
    std::vector<std::string> words = one.words;
    words.insert(words.end(), {"-o", output_});
    const ProgramRun refused = run(words);
    const std::string name = testing::PrintToString(words);
    EXPECT_EQ(refused.exit_code, one.exit_code) << name << refused.err;
    EXPECT_FALSE(std::filesystem::exists(output_)) << name;
    const Json line = refused.line();
    ASSERT_TRUE(line.contains("messages") && !line["messages"].empty()) << name << refused.out;
    EXPECT_FALSE(line["messages"][0]["en"].get<std::string>().empty()) << name;
    EXPECT_FALSE(line["messages"][0]["ja"].get<std::string>().empty()) << name;
  }
  EXPECT_EQ(run({bunny_, "--faces", "9000000"}).line()["faces_after"], 69451) << "more than there are";
}

TEST_F(Simplify, ends_with_8_and_writes_nothing_where_it_is_cancelled) {
  // So much that it is still at work when the signal comes.
  const std::string large = folder_.at("large.off");
  ASSERT_EQ(run_program({"subdivide", bunny_, "-o", large, "--scheme", "midpoint", "--steps", "1"}).exit_code, 0);
  Process process({RYOSEN_PROGRAM, "simplify", large, "-o", output_, "--faces", "0", "--effort", "2", "--json"}, {},
                  folder_.at("printed"), folder_.at("told"));
  for (int i = 0; i < 2000 && !process.handles(SIGINT) && !process.is_over(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  process.end_by(SIGINT);
  EXPECT_EQ(process.exit_code(), 8) << read_file(folder_.at("told"));
  EXPECT_EQ(Json::parse(read_file(folder_.at("printed")))["stopped"], "cancelled");
  EXPECT_FALSE(std::filesystem::exists(output_));
}

}  // namespace
}  // namespace ryosen::test
