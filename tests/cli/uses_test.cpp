// The table "Uses" of the contract, row by row.
#include <gtest/gtest.h>

#include <set>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

constexpr const char* cube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(uses, check_tetrahedron) {
  const ProgramRun run = run_program({"check", asset("tetrahedron.off"), "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.line()["status"], "ok");
  EXPECT_EQ(run.line()["problems"], Json::array());
}

TEST(uses, check_bunny) {
  const ProgramRun run = run_program({"check", asset("stanford_bunny.obj"), "--json"});
  EXPECT_EQ(run.exit_code, 0);
  const Json report = run.line();
  EXPECT_EQ(report["boundary_loops"], 5);
  EXPECT_EQ(report["vertices"], 34834);
  EXPECT_EQ(report["faces"], 69451);
  EXPECT_EQ(report["problems"].size(), 1u);
  for (const Json& problem : report["problems"]) EXPECT_EQ(problem["severity"], "info");
}

TEST(uses, check_three_triangles_on_an_edge) {
  const ProgramRun run = run_program({"check", asset("three_tri_edge.off"), "--json"});
  EXPECT_EQ(run.exit_code, 1);
  const Json report = run.line();
  EXPECT_EQ(report["nonmanifold_edges"], 1);
  EXPECT_EQ(report["boundary_edges"], 6);
  EXPECT_EQ(report["boundary_loops"], 0);
}

TEST(uses, check_isolated_vertex) {
  const ProgramRun run = run_program({"check", asset("isolated_vertex.obj")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("isolated_vertex"), std::string::npos) << run.out;
}

TEST(uses, check_malformed) {
  const ProgramRun run = run_program({"check", asset("obj_16_text_coord.obj"), "--json"});
  EXPECT_EQ(run.exit_code, 4);
  const Json report = run.line();
  EXPECT_EQ(report["status"], "error");
  EXPECT_EQ(report["format"], "obj");
  ASSERT_EQ(report["messages"].size(), 1u);
  EXPECT_EQ(report["messages"][0]["line"], 1);
  EXPECT_EQ(report["messages"][0]["column"], 5);
  EXPECT_EQ(report.size(), 4u) << "file, format, status, messages";
}

TEST(uses, check_missing) {
  const ProgramRun run = run_program({"check", "nosuch.obj", "--json"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.line()["file"], "nosuch.obj");
  EXPECT_TRUE(run.line()["format"].is_null());
}

TEST(uses, check_several) {
  const std::string good = asset("cube.obj"), bad = asset("obj_16_text_coord.obj"), fin = asset("fin.obj");
  EXPECT_EQ(run_program({"check", good, "nosuch.obj"}).exit_code, 9);
  EXPECT_EQ(run_program({"check", bad, "nosuch.obj"}).exit_code, 4);
  EXPECT_EQ(run_program({"check", good, fin}).exit_code, 1);
  EXPECT_EQ(run_program({"check", "nosuch.obj", "neither.obj"}).exit_code, 3);
  EXPECT_EQ(run_program({"check", good, asset("torus.off")}).exit_code, 0);
}

TEST(uses, check_unknown_flag) {
  const ProgramRun run = run_program({"check", "--bogus", "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(run.line()["file"].is_null());
  EXPECT_EQ(run.line()["status"], "error");
}

TEST(uses, check_tetrahedron_of_facets) {
  const TemporaryFolder folder;
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 0\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
           "\n endloop\nendfacet\n";
  };
  const std::string o = "0 0 0", minus = "-0 -0.0 0", x = "1 0 0", y = "0 1 0", z = "0 0 1";
  folder.write("a.stl",
               "solid\n" + facet(minus, y, x) + facet(o, x, z) + facet(x, y, z) + facet(o, z, y) + "endsolid\n");
  const ProgramRun run = run_program({"check", "a.stl", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.line()["vertices"], 4);
  EXPECT_EQ(run.line()["corners"], 12);
}

TEST(uses, why_collapse_on_tetrahedron) {
  const ProgramRun run = run_program({"why", asset("tetrahedron.off"), "--op", "collapse", "--all", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  const std::vector<Json> lines = run.lines();
  EXPECT_EQ(lines.size(), 12u);
  for (const Json& line : lines) EXPECT_EQ(line["legal"], false);
}

TEST(uses, why_unknown_edge) {
  const ProgramRun run = run_program({"why", asset("tetrahedron.off"), "--op", "collapse", "--edge", "0-9"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("v9"), std::string::npos) << run.err;
}

TEST(uses, why_swap_on_three_triangles_on_an_edge) {
  const ProgramRun run = run_program({"why", asset("three_tri_edge.off"), "--op", "swap", "--all", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  std::vector<std::string> edges;
  std::size_t boundary = 0;
  for (const Json& line : run.lines()) {
    edges.push_back(line["edge"]);
    EXPECT_EQ(line["legal"], false);
    boundary += line["reasons"][0]["rule"] == "boundary";
  }
  EXPECT_EQ(boundary, 6u);
  EXPECT_EQ(edges, (std::vector<std::string>{"0-1@f0", "0-1@f1", "0-1@f2", "0-2", "0-3", "0-4", "1-2", "1-3", "1-4"}));
}

TEST(uses, why_swap_on_torus) {
  const ProgramRun run = run_program({"why", asset("torus.off"), "--op", "swap", "--all", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  std::set<std::string> edges;
  for (const Json& line : run.lines()) edges.insert(line["edge"]);
  EXPECT_EQ(edges.size(), 144u);
  EXPECT_EQ(run.lines().size(), 144u);
}

TEST(uses, edit_is_a_trial_without_output) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"edit", asset("stanford_bunny.obj"), "--do", "collapse 8640-8282", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json last = run.lines().back();
  EXPECT_EQ(last["vertices"], 34834 - 1);
  EXPECT_EQ(last["edges"], 104288 - 3);
  EXPECT_EQ(last["faces"], 69451 - 2);
  EXPECT_TRUE(last["output"].is_null());
  EXPECT_TRUE(folder.names().empty());
}

TEST(uses, edit_refused_writes_nothing) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"edit", asset("tetrahedron.off"), "--do", "collapse 0-1", "-o", "o.off"}, folder.path());
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_NE(run.err.find("duplicate_face"), std::string::npos) << run.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST(uses, edit_skips_refused) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(
      {"edit", asset("tetrahedron.off"), "--do", "collapse 0-1", "-o", "o.off", "--on-refuse", "skip"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"o.off"});
  Json written = run_program({"check", folder.at("o.off"), "--json"}).line();
  Json original = run_program({"check", asset("tetrahedron.off"), "--json"}).line();
  for (Json* report : {&written, &original}) report->erase("file");
  EXPECT_EQ(written, original) << "equal in all figures and in the hash of points and faces";
}

TEST(uses, edit_does_not_replace_its_input) {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("a.obj", cube);
  const ProgramRun refused = run_program({"edit", "a.obj", "--do", "swap 0-1", "-o", "a.obj"}, folder.path());
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_EQ(read_file(mesh), cube);
  const ProgramRun allowed =
      run_program({"edit", "a.obj", "--do", "swap 0-1", "-o", "a.obj", "--overwrite"}, folder.path());
  EXPECT_EQ(allowed.exit_code, 0) << allowed.err;
  EXPECT_NE(read_file(mesh), cube);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.obj"});
}

TEST(uses, edit_misspelt_command) {
  const TemporaryFolder folder;
  folder.write("a.obj", cube);
  const ProgramRun run = run_program({"edit", "a.obj", "--do", "colapse 0-1", "-o", "o.obj"}, folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("did you mean collapse"), std::string::npos) << run.err;
  EXPECT_FALSE(folder.has("o.obj"));
}

TEST(uses, edit_deleted_element) {
  const TemporaryFolder folder;
  folder.write("a.obj", cube);
  const ProgramRun run =
      run_program({"edit", "a.obj", "--do", "collapse 0-1; swap 0-2", "-o", "o.obj", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 6);
  const std::vector<Json> lines = run.lines();
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0]["result"], "done");
  EXPECT_EQ(lines[1]["result"], "refused");
  EXPECT_EQ(lines[1]["reasons"][0]["rule"], "deleted");
  EXPECT_EQ(lines[2]["status"], "error");
  EXPECT_FALSE(folder.has("o.obj"));
}

TEST(uses, shot_that_differs_from_its_reference) {
  const TemporaryFolder folder;
  folder.write("a.obj", cube);
  const std::vector<std::string> shot{"shot", "a.obj", "--size", "200x160", "--backend", "osmesa"};
  const auto with = [&](std::vector<std::string> further) {
    further.insert(further.begin(), shot.begin(), shot.end());
    return run_program(further, folder.path());
  };
  EXPECT_EQ(with({"--view", "iso", "-o", "ref.png"}).exit_code, 0);
  EXPECT_EQ(with({"--view", "iso", "--compare", "ref.png"}).exit_code, 0);
  const ProgramRun run = with({"--view", "front", "--compare", "ref.png", "--json"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.line()["status"], "error");
  EXPECT_GT(run.line()["different_percent"], 0.2);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.obj", "ref.png"})) << "needs no -o and writes nothing";
}

TEST(uses, editor_without_a_display) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{asset("cube.obj")}, {"view", asset("cube.obj")}, {}}) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 7) << testing::PrintToString(arguments);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find("ryosen shot"), std::string::npos) << run.err;
  }
}

TEST(uses, edit_failed_expectation) {
  const TemporaryFolder folder;
  folder.write("a.obj", cube);
  const ProgramRun run = run_program({"edit", "a.obj", "--do", "expect V 9", "-o", "o.obj"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_FALSE(folder.has("o.obj"));
  EXPECT_EQ(run_program({"edit", "a.obj", "--do", "expect V 8", "-o", "o.obj"}, folder.path()).exit_code, 0);
  EXPECT_TRUE(folder.has("o.obj"));
}

}  // namespace
}  // namespace ryosen::test
