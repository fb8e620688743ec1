// Algorithms from outside: every row of their table is a subcommand and a command of scripts, and so is one that the
// program does not have, called within this process.
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/algorithm_call.h"
#include "tests/support/core/goal_algorithm.h"
#include "tests/support/core/scatter_algorithm.h"

namespace ryosen::test {
namespace {

// Two triangles beside each other whose common points lie a thousandth apart.
constexpr const char* loose = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1.001 0 0\nv 0 1.001 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";

// A tetrahedron without one of its faces.
constexpr const char* with_hole = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";

class Algorithms : public testing::Test {
 protected:
  const ScopedAlgorithm scatter_{scatter_row()};
  TemporaryFolder folder_;
};

TEST_F(Algorithms, a_share_of_the_diagonal_is_a_length_however_large_the_mesh_is) {
  const std::string file =
      folder_.write("large.obj", "v -5e199 0 0\nv 5e199 0 0\nv 0 5e199 0\nv 0 -5e199 0\nf 1 2 3\nf 2 1 4\n");
  const Json report = run_here({"weld_close", file, "--distance", "0.1%", "--json"}).line();
  EXPECT_EQ(report["changed"], 0) << report;
  EXPECT_NEAR(report["parameters"]["distance"].get<double>(), 1.414e197, 1e195);
}

TEST_F(Algorithms, refuse_a_share_of_no_diagonal_and_faces_where_edges_are_meant) {
  const std::string one_place = folder_.write("one.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
  const ProgramRun share = run_program({"remesh", one_place, "--length", "5%", "--json"});
  EXPECT_EQ(share.exit_code, 6);
  EXPECT_NE(share.line()["messages"][0]["en"].get<std::string>().find("length 5% is no length"), std::string::npos);
  const ProgramRun sharp = run_program({"subdivide", asset("cube.obj"), "--sharp", "f0", "--json"});
  EXPECT_EQ(sharp.exit_code, 2);
  EXPECT_NE(sharp.line()["messages"][0]["en"].get<std::string>().find("f0 is a face"), std::string::npos);
  EXPECT_EQ(run_program({"subdivide", asset("cube.obj"), "--sharp", "0-1"}).exit_code, 0);
}

TEST_F(Algorithms, are_subcommands_with_a_flag_for_each_parameter) {
  const std::string input = asset("moebius.off"), output = folder_.at("o.off");
  const std::string all = run_here({"help", "--lang", "en"}).out;
  for (const AlgorithmRow& row : algorithm_table()) {
    if (row.has_own_subcommand) continue;
    const std::string id(row.id);
    EXPECT_NE(all.find("ryosen " + id + (row.is_primitive ? " [FILE]" : " FILE")), std::string::npos) << id;
    const std::string help = run_here({"help", id, "--lang", "en"}).out,
                      japanese = run_here({"help", id, "--lang", "ja"}).out;
    for (const ParameterRow& parameter : row.parameters) {
      EXPECT_NE(help.find(cli::flag_of(parameter) + " " + cli::flag_value(parameter)), std::string::npos) << help;
      EXPECT_NE(help.find(described(parameter).en), std::string::npos) << help;
      EXPECT_NE(japanese.find(described(parameter).ja), std::string::npos) << japanese;
    }
    EXPECT_EQ(run_here({"help", id, "--json"}).line()["flags"].size(), row.parameters.size() + (row.has_goal ? 3 : 2));
    const ProgramRun run = run_here(words_for(row, input), {"-o", output, "--json"});
    ASSERT_LE(run.exit_code, 1) << id << run.err;
    const Json report = run.line();
    EXPECT_EQ(report["algorithm"], id);
    EXPECT_EQ(report["output"], output);
    EXPECT_EQ(report["parameters"].size(), row.parameters.size());
    for (const char* key : {"status", "changed", "left", "solves", "en", "ja", "vertices", "edges", "faces", "hash",
                            "problems", "messages"})
      EXPECT_TRUE(report.contains(key)) << id << " " << key;
    EXPECT_EQ(run_here({"check", output, "--json"}).line()["hash"], report["hash"]) << id;
    // An operator of this name comes first, so it must do without values; no other command may have the name.
    EXPECT_TRUE(row.parameters.empty() || !find_op(id)) << id;
    EXPECT_TRUE(find_op(id) || find_command_row(id)->help_en == row.help_en) << id;
    const AlgorithmCall call{&row, ParameterValues(row.parameters)};
    EXPECT_TRUE(call_of(call.line())->is_long) << id;
    EXPECT_TRUE(call_of_command(call)->is_long) << id;
  }
}

TEST_F(Algorithms, of_the_program_run_as_repair_does) {
  const std::string input = folder_.write("loose.obj", loose);
  const Json alone = run_program({"weld_close", input, "--distance=0.5", "--json"}).line();
  const Json listed = run_program({"repair", input, "--kinds", "weld_close=0.5", "--json"}).line();
  EXPECT_EQ(alone["hash"], listed["hash"]);
  EXPECT_EQ(alone["changed"], 2);
  EXPECT_EQ(alone["changed"], listed["repairs"][0]["changed"]);
  EXPECT_EQ(alone["parameters"]["distance"], 0.5);
  EXPECT_EQ(alone["parameters"], listed["repairs"][0]["parameters"]);
  EXPECT_EQ(alone["problems"], listed["problems"]);
  const ProgramRun wrong = run_program({"weld_close", input, "--distance", "-1"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(
      wrong.err.find("--distance is a length from 0 up, in units of the mesh or with % of its diagonal, not '-1'."),
      std::string::npos)
      << wrong.err;
  EXPECT_NE(run_program({"weld_close", input, "--lang", "ja"}).err.find("--distance を指定してください：長さ（0 以上"),
            std::string::npos);
  EXPECT_NE(run_program({"weld_clos", input}).err.find("Did you mean 'weld_close'?"), std::string::npos);
  EXPECT_NE(run_program({"weld_close", input, "--distanc", "1"}).err.find("Did you mean '--distance'?"),
            std::string::npos);
  EXPECT_EQ(run_program({"fill_holes", input, "-o", input}).exit_code, 5);
  EXPECT_EQ(run_program({"fill_holes", folder_.at("none.obj")}).exit_code, 3);
}

TEST_F(Algorithms, give_their_values_as_json_of_their_kind) {
  const std::string input = folder_.write("a.obj", "v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n");  // a diagonal of 5
  const ProgramRun run = run_here({"scatter", input, "--json", "--distance", "10%", "--x", "-2", "--copies", "3",
                                   "--at", "v1,0-2", "--mirror", "on", "--way", "down", "--angle", "180"});
  EXPECT_EQ(run.line()["parameters"], (Json{{"distance", 0.5},
                                            {"x", -2.0},
                                            {"copies", 3},
                                            {"share", 0.5},
                                            {"angle", 180.0},
                                            {"by", {0.0, 0.0, 0.0}},
                                            {"way", "down"},
                                            {"mirror", true},
                                            {"at", {"v1", "0-2"}}}));
  EXPECT_TRUE(run.line()["parameters"]["copies"].is_number_unsigned());
  EXPECT_EQ(run.line()["changed"], 3);
  EXPECT_EQ(run.line()["vertices"], 6);
  EXPECT_EQ(run_here({"fill_holes", input, "--json"}).line()["parameters"],
            (Json{{"most_edges", nullptr}, {"shape", "auto"}, {"crossing", "refuse"}}));
  for (const std::vector<std::string>& flags :
       std::vector<std::vector<std::string>>{{"--at", "v1"},
                                             {"--distance", "1"},
                                             {"--distance", "1", "--at", "v1", "--copies", "0"},
                                             {"--distance", "1", "--at", "v9"},
                                             {"--distance", "1", "--at", "v1", "--way", "left"}})
    EXPECT_EQ(run_here({"scatter", input, "--json", "-q"}, flags).exit_code, 2) << flags.back();
}

TEST_F(Algorithms, with_a_goal_account_for_their_end) {
  const ScopedAlgorithm wish(wish_row());
  const std::string cube = asset("cube.obj");  // 6 faces, 12 edges
  const ProgramRun reached = run_here({"wish", cube, "--faces", "7", "--json"}),
                   short_of = run_here({"wish", cube, "--ratio", "0.5", "--measured", "--json"});
  EXPECT_EQ(reached.exit_code, 0);
  EXPECT_EQ(reached.line()["stopped"], "goal");
  EXPECT_EQ(reached.line()["faces_before"], 6);
  EXPECT_EQ(reached.line()["faces_after"], 6);
  EXPECT_TRUE(reached.line()["error_max"].is_null());
  EXPECT_EQ(reached.line()["remaining"].size(), edge_rule_table().size());
  EXPECT_EQ(reached.line()["remaining"]["free"], 12);
  EXPECT_EQ(short_of.exit_code, 1);
  EXPECT_EQ(short_of.line()["stopped"], "blocked");
  EXPECT_EQ(short_of.line()["error_max"], 0.25);
  EXPECT_EQ(short_of.line()["remaining"]["structure"], 12);
  EXPECT_EQ(short_of.line()["remaining"]["free"], 0);
  EXPECT_EQ(run_here({"wish", cube, "--faces", "7"}).exit_code, 0);
  EXPECT_EQ(run_here({"wish", folder_.write("empty.off", "OFF\n0 0 0\n"), "--faces", "7"}).exit_code, 6);
  // What is left of other kinds is told, but does not make it fall short.
  const std::string sheet = folder_.write("twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n");
  const ProgramRun with_problems = run_here({"wish", sheet, "--faces", "2", "--json"});
  EXPECT_EQ(with_problems.exit_code, 0);
  EXPECT_EQ(with_problems.line()["status"], "warnings");
}

TEST_F(Algorithms, of_whose_goals_one_must_be_given_say_so) {
  const ScopedAlgorithm wish(wish_row());
  const ProgramRun none = run_here({"wish", asset("cube.obj"), "--lang", "en"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("one of --faces, --ratio must be given."), std::string::npos) << none.err;
  EXPECT_EQ(fault_of_command("wish")->en, "wish: one of faces, ratio must be given");
  EXPECT_FALSE(fault_of_command("wish ratio=0.5"));
  EXPECT_FALSE(fault_of_command("wish 3 measured=on"));
  EXPECT_EQ(described(find_algorithm("wish")->parameters[1]).en,
            "a ratio from 0 to 1; one of faces, ratio must be given");
}

TEST_F(Algorithms, take_a_flag_by_its_name_alone) {
  const ScopedAlgorithm wish(wish_row());
  const std::string cube = asset("cube.obj");
  const auto measured = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"wish", "--faces", "1", "--json"};
    all.insert(all.end(), words.begin(), words.end());
    return run_here(all).line()["parameters"]["measured"];
  };
  EXPECT_EQ(measured({cube}), false);
  EXPECT_EQ(measured({cube, "--measured"}), true);
  EXPECT_EQ(measured({"--measured", cube}), true) << "the file is not its value";
  EXPECT_EQ(measured({"--measured", "on", cube}), true);
  EXPECT_EQ(measured({"--measured", "off", cube}), false);
  EXPECT_EQ(measured({"--measured=off", cube}), false);
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--measured=maybe"}, {"--measured", "--measured"}, {"--measured", "on", "--measured"}})
    EXPECT_EQ(run_here({"wish", cube, "--faces", "1"}, wrong).exit_code, 2) << wrong.back();
}

TEST_F(Algorithms, that_are_primitives_begin_with_nothing_or_add_to_a_file) {
  const std::string first = folder_.at("first.obj"), second = folder_.at("second.obj");
  for (const AlgorithmRow& row : algorithm_table()) {
    if (!row.is_primitive) continue;
    const std::string id(row.id);
    const ProgramRun alone = run_here({id, "-o", first, "--overwrite", "--json"});
    EXPECT_EQ(alone.exit_code, 0) << id << alone.err;
    const Json report = alone.line();
    EXPECT_TRUE(report["file"].is_null()) << report;
    EXPECT_EQ(report["changed"], report[row.adds_points ? "vertices" : "faces"]);
    EXPECT_EQ(run_here({"check", first, "--self-intersections"}).exit_code, row.adds_points ? 1 : 0) << id;
    const ProgramRun added = run_here({id, first, "-o", second, "--overwrite", "--at=0,9,0", "--json"});
    EXPECT_EQ(added.exit_code, 0) << id << added.err;
    EXPECT_EQ(added.line()["file"], first);
    EXPECT_EQ(added.line()["vertices"], 2 * report["vertices"].get<int>()) << id;
    EXPECT_EQ(added.line()["faces"], 2 * report["faces"].get<int>()) << id;
  }
  EXPECT_EQ(run_program({"cube", "-o", folder_.at("cube.ply"), "--size", "3"}).exit_code, 0);
  EXPECT_EQ(run_program({"weld_close", "--distance", "1"}).exit_code, 2) << "it needs a mesh";
  EXPECT_EQ(run_here({"cube", folder_.at("none.obj")}).exit_code, 3);
}

TEST_F(Algorithms, whose_values_do_not_go_together_end_as_wrong_usage_and_write_nothing) {
  const std::string output = folder_.at("o.obj");
  const ProgramRun run = run_here({"torus", "-o", output, "--tube", "2", "--lang", "en"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("must be less than that of the circle it follows (1)."), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(output));
  Session session(std::make_unique<Document>());
  const Outcome outcome = session.run("torus tube=2");
  EXPECT_EQ(outcome.exit_code, ExitCode::usage);
  EXPECT_EQ(outcome.sentence.en,
            "torus: the radius of the tube (2) must be less than that of the circle it follows (1)");
  EXPECT_TRUE(session.log().empty());
  EXPECT_EQ(session.document().position(), 0u);
}

TEST_F(Algorithms, are_commands_of_scripts_and_one_entry_of_the_history_that_replays) {
  for (const std::string line :
       {"weld_close distance=0.5", "repair weld_close 0.5", "repair weld_close distance=0.5", "weld_close distance=5%",
        "fill_holes shape=auto crossing=refuse", "repair orient", "fill_holes most_edges=18 shape=fair crossing=allow",
        "scatter distance=1 x=0 copies=2 share=0.5 angle=0 by=0,0,0 way=up mirror=on at=f0,v3"}) {
    const std::string input = folder_.write("a.obj", line.starts_with("fill") ? with_hole : loose);
    const auto open = [&] { return Session(Document::open(input).value()); };
    Session session = open(), again = open();
    const Outcome outcome = session.run(line);
    ASSERT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
    EXPECT_EQ(outcome.performed, line);
    EXPECT_EQ(session.log(), std::vector<std::string>{line});
    if (line == "repair orient") continue;  // there is nothing to turn
    ASSERT_EQ(session.document().position(), 1u) << line;
    EXPECT_EQ(session.document().history()[0].command, line);
    ASSERT_TRUE(again.run(session.document().history()[0].command).done()) << line;
    EXPECT_EQ(again.mesh().hash(), session.mesh().hash()) << line;
    session.run("undo");
    EXPECT_EQ(session.mesh().hash(), open().mesh().hash()) << line;
  }
}

TEST_F(Algorithms, refuse_words_before_a_script_runs) {
  for (const char* line :
       {"weld_close", "weld_close distance=x", "weld_close size=1", "repair weld_close", "repair fill_holes 1.5",
        "repair nothing", "repair", "repair scatter distance=1 at=v0", "scatter distance=1 at=q",
        "fill_holes most_edges=1 most_edges=2", "remove_isolated 3", "values", "values nothing"})
    EXPECT_TRUE(fault_of_command(line)) << line;
  for (const char* line : {"weld_close 1%", "repair fill_holes 12", "repair weld_close 1e-3", "fill_holes",
                           "scatter distance=1 at=v900", "values scatter"})
    EXPECT_FALSE(fault_of_command(line)) << line;
  EXPECT_EQ(fault_of_command("weld_close distance=x")->en,
            "weld_close: distance is a length from 0 up, in units of the mesh or with % of its diagonal, not 'x'");
  EXPECT_EQ(unknown_command("scater").sentence.en, "there is no command 'scater'; did you mean scatter?");
  const ProgramRun run = run_here({"edit", asset("cube.obj"), "--do", "split 0-1; weld_close distance=-1", "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out.find("\"done\""), std::string::npos) << "nothing has run";
  EXPECT_NE(run_here({"help", "edit"}).out.find("scatter distance=LENGTH [x=NUMBER]"), std::string::npos);
}

TEST_F(Algorithms, name_an_element_that_is_not_there) {
  Session session(Document::open(asset("cube.obj")).value());
  const Outcome unknown = session.run("scatter distance=1 at=v0,v99");
  EXPECT_EQ(unknown.exit_code, ExitCode::usage);
  EXPECT_NE(unknown.sentence.en.find("v99"), std::string::npos) << unknown.sentence.en;
  ASSERT_TRUE(session.run("delete f0").done());
  EXPECT_EQ(session.run("scatter distance=1 at=f0").exit_code, ExitCode::refused) << "it was there before";
}

TEST_F(Algorithms, are_kept_for_after_a_crash) {
  setenv("XDG_STATE_HOME", folder_.path().c_str(), 1);
  std::uint64_t hash = 0;
  {
    Session crashed(Document::open(folder_.write("loose.obj", loose)).value());
    Autosave autosave(recovery_folder());
    crashed.frontend.autosave = &autosave;
    autosave.begin(crashed.document());
    for (const char* line :
         {"scatter distance=7% copies=2 at=f1", "weld_close distance=0.01", "fill_holes", "undo", "split 0-1"})
      ASSERT_TRUE(crashed.run(line).done()) << line;
    hash = crashed.mesh().hash();
  }
  Session again(std::make_unique<Document>());
  ASSERT_TRUE(again.run("recover").done());
  const Outcome outcome = again.run("recover 1");
  EXPECT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_EQ(again.mesh().hash(), hash);
  unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace ryosen::test
