// `edit`: scripts, refusals, what is written and what never is.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

TEST(edit, reports_every_command_then_the_whole) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"edit", asset("fan.obj"), "--do", "collapse 0-1", "--do", "# nothing", "--do",
                                      "split 2-3 0.25; expect V 7", "-o", "o.obj", "--json"},
                                     folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::vector<Json> lines = run.lines();
  ASSERT_EQ(lines.size(), 4u);
  std::vector<std::string> keys;
  for (const auto& item : lines[0].items()) keys.push_back(item.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"line", "command", "result", "created", "deleted", "reasons", "warnings"}));
  EXPECT_EQ(lines[0]["command"], "collapse 0-1");
  EXPECT_EQ(lines[0]["line"], 1);
  EXPECT_EQ(lines[1]["line"], 3);
  EXPECT_NE(lines[0]["deleted"].dump().find("\"v0\""), std::string::npos) << lines[0];
  EXPECT_NE(lines[1]["created"].dump().find("\"v7\""), std::string::npos) << lines[1];
  keys.clear();
  for (const auto& item : lines[3].items()) keys.push_back(item.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"file", "output", "status", "vertices", "edges", "faces", "rings", "hash",
                                            "applied", "refused"}));
  EXPECT_EQ(lines[3]["output"], "o.obj");
  EXPECT_EQ(lines[3]["status"], "ok");
  EXPECT_EQ(lines[3]["applied"], 3);
  EXPECT_EQ(lines[3]["refused"], 0);
}

TEST(edit, writes_the_mesh_and_not_the_step_that_is_shown) {
  const test::TemporaryFolder folder;
  const ProgramRun run = run_program(
      {"edit", asset("cube.obj"), "--do", "steps script square; steps last", "-o", "o.obj", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.lines().back()["vertices"], 8);
  EXPECT_EQ(run_program({"check", folder.at("o.obj"), "--json"}).line()["faces"], 6);
  // Names are those of the mesh, though a step with others is shown.
  const ProgramRun split = run_program(
      {"edit", asset("cube.obj"), "--do", "steps script square; steps last; split 4-5", "--json"}, folder.path());
  EXPECT_EQ(split.exit_code, 0) << split.err;
  EXPECT_EQ(split.lines().back()["vertices"], 9);
}

TEST(edit, runs_scripts_with_comments_and_undoes_them) {
  const TemporaryFolder folder;
  folder.write("s.txt", "# a trial\ncollapse 0-1 mid ; swap 2-3\n\nundo 2\nexpect V 8; expect E 12; expect F 6\n");
  const std::string hash = run_program({"check", asset("cube.obj"), "--json"}).line()["hash"];
  const ProgramRun run = run_program({"edit", asset("cube.obj"), "--script", folder.at("s.txt"), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.lines().back()["hash"], hash);
  EXPECT_EQ(run_program({"edit", asset("cube.obj"), "--do", "split 0-1; undo; expect hash " + hash}).exit_code, 0);
}

TEST(edit, stops_at_a_refusal_and_skips_the_rest) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(
      {"edit", asset("tetrahedron.off"), "--do", "split 0-1; collapse 2-3; split 1-2", "-o", "o.off", "--json"},
      folder.path());
  EXPECT_EQ(run.exit_code, 6);
  const std::vector<Json> lines = run.lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0]["result"], "done");
  EXPECT_EQ(lines[1]["result"], "refused");
  EXPECT_FALSE(lines[1]["reasons"].empty());
  EXPECT_EQ(lines[2]["result"], "skipped");
  EXPECT_EQ(lines[3]["status"], "error");
  EXPECT_EQ(lines[3]["refused"], 1);
  EXPECT_TRUE(folder.names().empty());
}

TEST(edit, goes_on_after_a_refusal_when_asked) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"edit", asset("tetrahedron.off"), "--do", "collapse 0-1; split 1-2", "-o",
                                      "o.off", "--on-refuse", "skip", "--json"},
                                     folder.path());
  EXPECT_EQ(run.exit_code, 1);
  const Json last = run.lines().back();
  EXPECT_EQ(last["status"], "warnings");
  EXPECT_EQ(last["applied"], 1);
  EXPECT_EQ(last["refused"], 1);
  EXPECT_EQ(run_program({"check", folder.at("o.off"), "--json"}).line()["vertices"], 5);
}

TEST(edit, a_failed_expectation_is_no_refusal) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"edit", asset("cube.obj"), "--do", "expect V 9; split 0-1", "-o", "o.obj", "--on-refuse", "skip"},
                  folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(folder.names().empty());
}

TEST(edit, a_line_that_does_not_parse_is_found_before_anything_is_written) {
  const TemporaryFolder folder;
  const std::string cube = asset("cube.obj");
  for (const char* wrong : {"split 0-1 x",
                            "split 0",
                            "collapse 0-1 middle",
                            "swap",
                            "make_face 0 1",
                            "weld 0 1-2",
                            "detach f0 1",
                            "orient 1",
                            "expect",
                            "expect X 1",
                            "expect V many",
                            "expect w 1",
                            "expect G",
                            "expect F 6x",
                            "expect legal",
                            "expect legal foo",
                            "expect refused split 0",
                            "view above",
                            "undo x",
                            "repair nothing",
                            "show bondary",
                            "camera {\"eye\":1}",
                            "bind Ctrl+K bind Ctrl+L undo",
                            "key NoKey",
                            "select 0-",
                            "tool knife",
                            "open",
                            "drag 1,2",
                            "recover x"}) {
    folder.write("s.txt", std::string("split 0-1\nsave o.obj\n\n") + wrong + "\n");
    const ProgramRun run = run_program({"edit", cube, "--script", "s.txt"}, folder.path());
    EXPECT_EQ(run.exit_code, 2) << wrong << "\n" << run.err;
    EXPECT_NE(run.err.find("s.txt:4"), std::string::npos) << run.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"s.txt"})) << wrong;
    EXPECT_EQ(run.out, "") << "nothing ran";
  }
  const ProgramRun json =
      run_program({"edit", cube, "--do", "save o.obj; split 0-1 x", "--json", "--lang", "ja"}, folder.path());
  EXPECT_EQ(json.exit_code, 2);
  EXPECT_EQ(json.line()["status"], "error");
  EXPECT_EQ(json.line()["messages"][0]["line"], 1);
  EXPECT_NE(json.line()["messages"][0]["en"].get<std::string>().find("'x'"), std::string::npos) << json.out;
}

TEST(edit, lines_that_the_mesh_decides_are_left_to_the_run) {
  const TemporaryFolder folder;
  for (const char* line : {"camera {\"target\":[0.42,0.36,1]}", "view iso; frame; frame selected",
                           "mode face; tool none", "select v0 f1 0-8; select none", "show boundary off",
                           "expect legal split 0-1", "key Home", "undo; redo", "click 10,10 poke", "repair orient"}) {
    const ProgramRun run = run_program({"edit", asset("cube.obj"), "--do", "split 0-1", "--do", line}, folder.path());
    EXPECT_NE(run.exit_code, 2) << line << "\n" << run.err;
  }
}

TEST(edit, a_stop_says_what_had_been_saved) {
  const TemporaryFolder folder;
  const auto edit = [&](const char* lines, const char* language) {
    return run_program({"edit", asset("cube.obj"), "--do", lines, "--lang", language}, folder.path());
  };
  const ProgramRun never = edit("save a.obj; split 0-1; save b.obj; save a.obj; split 0-77", "en");
  EXPECT_EQ(never.exit_code, 2);
  EXPECT_NE(never.err.find("v77 does not exist (saved before: a.obj, b.obj)"), std::string::npos) << never.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.obj", "b.obj"}));
  const ProgramRun refused = edit("save c.obj; key Ctrl+S; swap 0-1; collapse 0-1", "ja");
  EXPECT_EQ(refused.exit_code, 6);
  EXPECT_NE(refused.err.find("（ここまでに保存：c.obj）"), std::string::npos) << refused.err;
  EXPECT_EQ(edit("split 0-77; save d.obj", "en").err.find("saved"), std::string::npos);
}

TEST(edit, a_refusal_for_very_many_reasons_says_the_first_and_how_many_more) {
  const TemporaryFolder folder;
  std::string lines = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 20; ++i) lines += "f 1 2 3\n";
  folder.write("equal.obj", lines);
  const ProgramRun run = run_program({"edit", "equal.obj", "--do", "split 0-1@f0", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_EQ(run.lines()[0]["reasons"].size(), 19u);
  const std::string said = run_program({"edit", "equal.obj", "--do", "split 0-1@f0"}, folder.path()).err;
  EXPECT_NE(said.find("There are 11 more reasons. [same_apex]"), std::string::npos) << said;
}

TEST(edit, names_a_point_that_goes_with_all_its_copies_once) {
  const TemporaryFolder folder;
  folder.write("book.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  const Json gone =
      run_program({"edit", "book.obj", "--do", "delete v0", "--json"}, folder.path()).lines()[0]["deleted"];
  for (const char* name : {"v0", "v1", "v2", "v3", "v4"})
    EXPECT_EQ(std::count(gone.begin(), gone.end(), Json(name)), 1) << name << " in " << gone;
  const Json some =
      run_program({"edit", "book.obj", "--do", "delete f1", "--json"}, folder.path()).lines()[0]["deleted"];
  EXPECT_EQ(std::count(some.begin(), some.end(), Json("v0")), 0) << some;
  EXPECT_EQ(std::count(some.begin(), some.end(), Json("v0@f1")), 1) << some;
}

TEST(edit, unknown_element_stops_even_when_skipping) {
  const ProgramRun run =
      run_program({"edit", asset("cube.obj"), "--do", "split 0-1; collapse 0-77", "--on-refuse", "skip"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("v77"), std::string::npos) << run.err;
}

TEST(edit, edge_that_is_gone_is_refused_and_one_that_never_was_is_usage) {
  const std::string cube = asset("cube.obj");
  const ProgramRun gone = run_program({"edit", cube, "--do", "swap 0-1; collapse 0-1", "--json"});
  EXPECT_EQ(gone.exit_code, 6);
  EXPECT_EQ(gone.lines()[1]["reasons"][0]["rule"], "deleted");
  EXPECT_EQ(run_program({"edit", cube, "--do", "collapse 0-6"}).exit_code, 2);
}

TEST(edit, strict_turns_warnings_into_refusals) {
  const TemporaryFolder folder;
  // The top of a low pyramid is pulled through its base.
  const std::vector<std::string> edit{"edit", asset("fan.obj"), "--do", "collapse 0-1 9,9,9", "-o", "o.obj", "--json"};
  const ProgramRun plain = run_program(edit, folder.path());
  EXPECT_EQ(plain.exit_code, 0);
  ASSERT_FALSE(plain.lines()[0]["warnings"].empty());
  EXPECT_EQ(plain.lines()[0]["warnings"][0]["severity"], "warn");
  std::filesystem::remove(folder.at("o.obj"));
  std::vector<std::string> strict = edit;
  strict.push_back("--strict");
  const ProgramRun run = run_program(strict, folder.path());
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_EQ(run.lines()[0]["reasons"][0]["rule"], plain.lines()[0]["warnings"][0]["rule"]);
  EXPECT_TRUE(folder.names().empty());
}

TEST(edit, strict_refuses_to_write_what_would_be_lost) {
  const TemporaryFolder folder;
  const std::vector<std::string> edit{"edit", asset("cube.obj"), "--do", "move_vertex v0 -1.5,-1.5,-1.5"};
  for (const std::vector<std::string>& write : {std::vector<std::string>{"-o", "o.stl"}, {"--do", "save o.stl"}}) {
    std::vector<std::string> strict = edit;
    strict.insert(strict.end(), write.begin(), write.end());
    strict.insert(strict.end(), {"--json", "--strict"});
    const ProgramRun run = run_program(strict, folder.path());
    EXPECT_EQ(run.exit_code, 6) << run.out;
    EXPECT_NE(run.out.find("Nothing was written: --strict allows none of these warnings."), std::string::npos);
    EXPECT_NE(run.out.find("faces with more than three corners"), std::string::npos) << run.out;
    EXPECT_EQ(run.lines().back()["output"], nullptr);
    EXPECT_TRUE(folder.names().empty());
  }
  std::vector<std::string> lossless = edit;
  lossless.insert(lossless.end(), {"-o", "o.obj", "--strict"});
  EXPECT_EQ(run_program(lossless, folder.path()).exit_code, 0);
}

TEST(edit, says_what_it_does_not_count_beside_what_expect_counts) {
  const auto edit = [](const std::string& script) { return run_program({"edit", "--new", "--do", script}).out; };
  const std::string wire = "make_vertex 0,0,0; make_vertex 1,0,0; make_edge v0 v1; expect E 1";
  EXPECT_NE(edit(wire).find("E 0 (0)"), std::string::npos) << edit(wire);
  EXPECT_NE(edit(wire).find("as expect counts: V 2  E 1  F 0\n"), std::string::npos) << edit(wire);
  EXPECT_EQ(edit("make_vertex 0,0,0; expect V 1").find("expect counts"), std::string::npos);
}

TEST(edit, warns_of_what_is_legal_and_doubtful) {
  const std::pair<const char*, const char*> doubtful[] = {
      {"split 0-1 1.5", "outside_edge"}, {"separate_edge 0-1 -1", "outside_edge"}, {"split 0-1 0", "same_place"}};
  for (const auto& [line, rule] : doubtful) {
    const ProgramRun run = run_program({"edit", asset("cube.obj"), "--do", line, "--json"});
    EXPECT_EQ(run.exit_code, 0) << line;
    ASSERT_EQ(run.lines()[0]["warnings"].size(), 1u) << run.out;
    EXPECT_EQ(run.lines()[0]["warnings"][0]["rule"], rule) << line;
    EXPECT_EQ(run_program({"edit", asset("cube.obj"), "--do", line, "--strict"}).exit_code, 6) << line;
    const ProgramRun why = run_program({"why", asset("cube.obj"), "--do", line, "--json"});
    EXPECT_NE(why.out.find(rule), std::string::npos) << why.out;
  }
}

TEST(edit, expect_knows_every_term_of_the_sum) {
  const auto ends_with = [](const std::string& mesh, const std::string& script) {
    return run_program({"edit", asset(mesh), "--do", script}).exit_code;
  };
  EXPECT_EQ(ends_with("torus.off",
                      "expect V 48; expect E 144; expect F 96; expect B 0; expect H 0; expect S 1; "
                      "expect G 1"),
            0);
  EXPECT_EQ(ends_with("cube.obj", "expect G 0; delete f0; expect B 1; detach f1; expect S 2; undo 2; expect S 1"), 0);
  EXPECT_EQ(ends_with("isolated_vertex.obj", "expect B 1; expect S 2; remove_vertex v3; expect S 1; expect B 1"), 0);
  const std::string exercise = read_file(RYOSEN_SOURCE_DIR "/assets/exercises/cube_with_two_holes.ryosen");
  const TemporaryFolder folder;
  folder.write("s.txt", exercise + "\nexpect H 4; expect G 2; expect B 0\n");
  EXPECT_EQ(run_program({"edit", "--new", "--script", "s.txt"}, folder.path()).exit_code, 0);
  EXPECT_EQ(ends_with("cube.obj", "expect G 1"), 1);
  const ProgramRun none = run_program({"edit", asset("fin.obj"), "--do", "expect G 0"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_NE(none.err.find("expected G 0, found: none, not manifold at 0-1"), std::string::npos) << none.err;
}

// Three of the triangles around point 4 are turned over: it lies on several sheets.
TEST(edit, a_vertex_on_several_sheets_must_be_named_with_its_face) {
  const TemporaryFolder folder;
  const std::string path = folder.write("seam.off",
                                        "OFF\n9 8 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n0 2 0\n1 2 0\n2 2 0\n"
                                        "3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n3 3 4 7\n3 3 7 6\n3 4 8 5\n3 4 7 8\n");
  for (const char* line : {"dissolve v4", "vertex_split v4 v0 v3"}) {
    const ProgramRun run = run_program({"edit", path, "--do", line});
    EXPECT_EQ(run.exit_code, 2) << line;
    EXPECT_NE(run.err.find("v4 lies on several sheets; choose one of v4@f0, v4@f6"), std::string::npos) << run.err;
  }
  EXPECT_EQ(run_program({"edit", path, "--do", "dissolve v4@f6"}).exit_code, 0);
  EXPECT_EQ(run_program({"edit", path, "--do", "move_vertex v4 1,1,1"}).exit_code, 0) << "a point is meant";
}

TEST(edit, save_in_a_script) {
  const TemporaryFolder folder;
  folder.copy(asset("cube.obj"), "a.obj");
  EXPECT_EQ(
      run_program({"edit", "a.obj", "--do", "split 0-1; save b.off; split 1-2; save c.obj"}, folder.path()).exit_code,
      0);
  EXPECT_EQ(run_program({"check", folder.at("b.off"), "--json"}).line()["vertices"], 9);
  EXPECT_EQ(run_program({"check", folder.at("c.obj"), "--json"}).line()["vertices"], 10);
}

TEST(edit, file_names_in_quotes) {
  const TemporaryFolder folder;
  const std::string odd = "x; \"y\" #1.obj";
  folder.copy(asset("cube.obj"), odd);
  const std::string argument = "\"x; \\\"y\\\" #1.obj\"";
  EXPECT_EQ(run_program({"edit", odd, "--do", "split 0-1; save " + argument}, folder.path()).exit_code, 5)
      << "the input is recognised under its quoted name";
  EXPECT_EQ(run_program({"edit", asset("fan.obj"), "--do", "open " + argument + "; split 0-1; save \"o 2.obj\""},
                        folder.path())
                .exit_code,
            0);
  EXPECT_EQ(run_program({"check", folder.at("o 2.obj"), "--json"}).line()["vertices"], 9);
}

TEST(edit, nothing_runs_when_an_input_would_be_replaced) {
  const TemporaryFolder folder;
  folder.copy(asset("cube.obj"), "a.obj");
  folder.copy(asset("fan.obj"), "b.obj");
  folder.write("s.obj", "split 0-1\n");
  std::filesystem::create_symlink("a.obj", folder.at("link.obj"));
  const std::string cube = read_file(asset("cube.obj"));
  const std::vector<std::vector<std::string>> wrong = {
      {"--do", "save; save new.obj"},
      {"--do", "split 0-1; save new.obj; save a.obj"},
      {"--do", "split 0-1; save new.obj; save ./a.obj"},
      {"--do", "split 0-1; save new.obj; save link.obj"},
      {"--do", "save new.obj; open b.obj; save"},
      {"--do", "save new.obj; key Ctrl+S", "-o", "a.obj"},
      {"--do", "save new.obj", "-o", "link.obj"},
      {"--script", "s.obj", "-o", "s.obj"},
  };
  for (const auto& further : wrong) {
    std::vector<std::string> arguments{"edit", "a.obj"};
    arguments.insert(arguments.end(), further.begin(), further.end());
    EXPECT_EQ(run_program(arguments, folder.path()).exit_code, 5) << testing::PrintToString(arguments);
    EXPECT_FALSE(folder.has("new.obj")) << testing::PrintToString(arguments);
    EXPECT_EQ(read_file(folder.at("a.obj")), cube);
  }
  EXPECT_EQ(run_program({"edit", "a.obj", "--do", "split 0-1; save", "--overwrite"}, folder.path()).exit_code, 0);
  EXPECT_EQ(run_program({"check", folder.at("a.obj"), "--json"}).line()["vertices"], 9);
}

TEST(edit, output_that_cannot_be_written) {
  const TemporaryFolder folder;
  const std::string cube = asset("cube.obj");
  const ProgramRun no_folder =
      run_program({"edit", cube, "--do", "split 0-1", "-o", "no/such/folder/o.obj", "--json"}, folder.path());
  EXPECT_EQ(no_folder.exit_code, 5);
  EXPECT_EQ(no_folder.lines().back()["status"], "error");
  EXPECT_TRUE(no_folder.lines().back()["output"].is_null());
  EXPECT_EQ(run_program({"edit", cube, "--do", "split 0-1", "-o", "o.xyz"}, folder.path()).exit_code, 2);
  EXPECT_TRUE(folder.names().empty());
}

TEST(edit, mistakes_are_found_before_anything_runs) {
  const TemporaryFolder folder;
  folder.write("s.txt", "save first.obj\n\n  splitt 0-1\n");
  const ProgramRun run =
      run_program({"edit", asset("cube.obj"), "--script", "s.txt", "-o", "o.obj", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.line()["messages"][0]["line"], 3);
  EXPECT_NE(run.err.find("s.txt:3: error: "), std::string::npos) << run.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.txt"});
}

TEST(edit, usage_errors) {
  const std::string cube = asset("cube.obj");
  const std::vector<std::vector<std::string>> wrong = {
      {"edit", cube},
      {"edit", cube, "--do", "split 0-1", "--script", "s.txt"},
      {"edit", cube, "--do", "split 0-1", "--on-refuse", "stop"},
      {"edit", cube, "--do", "split 0-1", "-o", "a.obj", "-o", "b.obj"},
      {"edit", "--do", "split 0-1"},
      {"edit", cube, cube, "--do", "split 0-1"},
  };
  for (const auto& arguments : wrong)
    EXPECT_EQ(run_program(arguments).exit_code, 2) << testing::PrintToString(arguments);
  EXPECT_EQ(run_program({"edit", cube, "--script", "nosuch.txt"}).exit_code, 3);
  EXPECT_EQ(run_program({"edit", "nosuch.obj", "--do", "split 0-1"}).exit_code, 3);
}

TEST(edit, keeps_what_the_file_holds) {
  const TemporaryFolder folder;
  folder.write("a.obj",
               "# made by hand\nmtllib m.mtl\ng left\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\n"
               "vt 1 1\nusemtl red\nf 1/1 2/2 3/3 4\nusemtl blue\nf 2 5 3\nf 1 2 2\n");
  folder.write("m.mtl", "newmtl red\nnewmtl blue\n");
  EXPECT_EQ(run_program({"edit", "a.obj", "--do", "split 1-2", "-o", "o.obj"}, folder.path()).exit_code, 0);
  const std::string written = read_file(folder.at("o.obj"));
  for (const char* part : {"# made by hand", "mtllib m.mtl", "g left", "usemtl red", "usemtl blue", "vt 1 1"})
    EXPECT_NE(written.find(part), std::string::npos) << part << "\n" << written;
  const Json report = run_program({"check", folder.at("o.obj"), "--json"}).line();
  EXPECT_EQ(report["quarantined"], 1);
  EXPECT_EQ(report["degenerate_repeat"], 1);
}

TEST(edit, keeps_a_deleted_vertex_in_the_file_that_a_line_uses) {
  const TemporaryFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\nf 4 4 1\nl 4 1\n");
  const ProgramRun run = run_program({"edit", "a.obj", "--do", "collapse 3-2", "-o", "o.obj", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json last = run.lines().back();
  EXPECT_EQ(last["vertices"], 3);
  EXPECT_EQ(last["status"], "warnings");
  ASSERT_EQ(last["messages"].size(), 1u);
  EXPECT_EQ(last["messages"][0]["code"], "keeps_vertices");
  const std::string written = read_file(folder.at("o.obj"));
  EXPECT_NE(written.find("v 1 1 0\n"), std::string::npos);
  EXPECT_NE(written.find("f 4 4 1\n"), std::string::npos);
  EXPECT_NE(written.find("l 4 1\n"), std::string::npos);
}

}  // namespace
}  // namespace ryosen::test
