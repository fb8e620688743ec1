// `check`: options, folders, several inputs, and the shape of its JSON.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "ryosen/ops/all.h"
#include "tests/support/app/contract.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::vector<std::string> files_of(const std::vector<Json>& lines) {
  std::vector<std::string> files;
  for (const Json& line : lines) files.push_back(line["file"]);
  return files;
}

// What programs elsewhere read; further keys may come between them.
bool holds_in_order(const std::vector<std::string>& keys, std::string_view read) {
  auto at = keys.begin();
  for (const std::string_view word : split_words(read)) {
    at = std::find(at, keys.end(), word);
    if (at++ == keys.end()) return false;
  }
  return true;
}

TEST(check, json_has_the_keys_of_the_contract_in_order) {
  constexpr std::string_view read_elsewhere =
      "file format status vertices corners faces edges triangles quads polygons quarantined rings "
      "boundary_edges boundary_loops nonmanifold_edges max_edge_faces nonmanifold_vertices bowtie_vertices "
      "misoriented_edges degenerate_repeat degenerate_area duplicate_faces hanging_pairs isolated_vertices "
      "nonfinite_vertices components euler_characteristic genus manifold closed orientable bounds area "
      "volume kind kind_reason hash problems messages";
  const Json report = run_program({"check", asset("fin.obj"), "--json"}).line();
  const std::vector<Json> contract = run_program({"help", "json", "--json"}).lines();
  EXPECT_EQ(keys_of(report), required_keys(contract, "check"));
  EXPECT_TRUE(holds_in_order(keys_of(report), read_elsewhere));
  ASSERT_FALSE(report["problems"].empty());
  const Json& problem = report["problems"][0];
  EXPECT_EQ(keys_of(problem), required_keys(contract, "problem"));
  EXPECT_TRUE(holds_in_order(keys_of(problem), "kind severity count elements where line en ja"));
  EXPECT_EQ(problem["kind"], "nonmanifold_edge");
  EXPECT_EQ(problem["elements"], Json::array({"0-1"}));
  EXPECT_EQ(problem["line"], 9);
  EXPECT_EQ(problem["where"], Json::array({0.5, 0.0, 0.0}));
}

TEST(check, says_in_one_word_what_a_mesh_is) {
  const std::pair<const char*, const char*> kinds[] = {
      {"fin.obj", "non_manifold"},  {"bow_tie.obj", "non_manifold"},
      {"moebius.off", "one_sided"}, {"misoriented.obj", "misoriented"},
      {"two_quads.obj", "surface"}, {"stanford_bunny.obj", "surface"},
      {"cube.obj", "solid"},        {"torus.off", "solid"},
  };
  for (const auto& [name, kind] : kinds) {
    const Json report = run_program({"check", asset(name), "--json"}).line();
    EXPECT_EQ(report["kind"], kind) << name;
    EXPECT_EQ(keys_of(report["kind_reason"]), (std::vector<std::string>{"en", "ja"})) << name;
  }
  EXPECT_EQ(run_program({"check", asset("fin.obj"), "--json"}).line()["kind_reason"]["en"],
            "Edge 0-1 carries 3 faces.");
  const TemporaryFolder folder;
  const std::string inside_out =
      folder.write("inside_out.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n");
  const ProgramRun run = run_program({"check", inside_out});
  EXPECT_EQ(run.exit_code, 0) << "a kind is no problem";
  EXPECT_NE(run.out.find("  surface sphere\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  kind inside out: The faces of the shell of f0 look inwards.\n"), std::string::npos)
      << run.out;
  EXPECT_EQ(run_program({"check", folder.write("points.off", "OFF\n1 0 0\n0 0 0\n"), "--json"}).line()["kind"],
            "points");
}

TEST(check, names_a_surface_whose_faces_have_holes) {
  const TemporaryFolder folder;
  const std::string script = std::string(RYOSEN_SOURCE_DIR) + "/assets/exercises/cube_with_hole.ryosen";
  ASSERT_EQ(run_program({"edit", "--new", "--script", script, "-o", folder.at("holed.obj")}).exit_code, 0);
  const ProgramRun run = run_program({"check", folder.at("holed.obj")});
  EXPECT_NE(run.out.find("  surface torus\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  kind solid: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("ring x2: Faces have 2 rings"), std::string::npos) << run.out;
}

TEST(check, numbers_that_are_not_finite_become_null) {
  const TemporaryFolder folder;
  folder.write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n");
  const ProgramRun run = run_program({"check", folder.at("nan.obj"), "--json"});
  EXPECT_EQ(run.exit_code, 1);
  const Json report = run.line();
  EXPECT_TRUE(report["bounds"].is_null());
  EXPECT_EQ(report["nonfinite_vertices"], 1);
  const auto& problems = report["problems"];
  const auto found =
      std::find_if(problems.begin(), problems.end(), [](const Json& p) { return p["kind"] == "nonfinite_vertex"; });
  ASSERT_NE(found, problems.end());
  EXPECT_TRUE((*found)["where"].is_null());
}

TEST(check, quarantined_face_is_named_with_its_line) {
  const TemporaryFolder folder;
  folder.write("q.obj", std::string(triangle) + "f 1 2\n");
  const ProgramRun run = run_program({"check", folder.at("q.obj"), "--json"});
  EXPECT_EQ(run.exit_code, 1);
  const Json report = run.line();
  EXPECT_EQ(report["faces"], 2);
  EXPECT_EQ(report["quarantined"], 1);
  EXPECT_EQ(report["problems"][0]["kind"], "quarantined_face");
  EXPECT_EQ(report["problems"][0]["elements"], Json::array({"f1"}));
  EXPECT_EQ(report["problems"][0]["line"], 5);
  ASSERT_EQ(report["messages"].size(), 1u);
  EXPECT_EQ(report["messages"][0]["severity"], "warning");
  EXPECT_EQ(report["messages"][0]["line"], 5);
}

TEST(check, fail_on_chooses_the_kinds_that_count) {
  const std::string fin = asset("fin.obj"), fan = asset("fan.obj");
  EXPECT_EQ(run_program({"check", fin, "--fail-on", "none"}).exit_code, 0);
  EXPECT_EQ(run_program({"check", fin, "--fail-on", "isolated_vertex"}).exit_code, 0);
  EXPECT_EQ(run_program({"check", fin, "--fail-on", "isolated_vertex,nonmanifold_edge"}).exit_code, 1);
  EXPECT_EQ(run_program({"check", fan}).exit_code, 0);
  EXPECT_EQ(run_program({"check", fan, "--fail-on=boundary_loop"}).exit_code, 1);
  const ProgramRun wrong = run_program({"check", fan, "--fail-on", "boundary_lop"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("'boundary_loop'"), std::string::npos) << wrong.err;
  EXPECT_EQ(run_program({"check", fan, "--fail-on", "none,isolated_vertex"}).exit_code, 2);
}

TEST(check, warnings_of_the_reader_count_as_problems) {
  const TemporaryFolder folder;
  folder.write("m.obj", "curv 0 1\n" + std::string(triangle));
  const ProgramRun run = run_program({"check", folder.at("m.obj"), "--json"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.line()["status"], "warnings");
  EXPECT_EQ(run.err, "") << "the JSON carries them";
  EXPECT_NE(run_program({"check", folder.at("m.obj")}).err.find("m.obj:1: warning: "), std::string::npos);
}

TEST(check, a_material_library_that_is_missing_is_a_warning_without_exit_code) {
  const TemporaryFolder folder;
  folder.write("m.obj", "mtllib some.mtl\n" + std::string(triangle));
  const auto check = [&] { return run_program({"check", folder.at("m.obj"), "--json"}); };
  const auto warning = [](const ProgramRun& run) { return run.line()["messages"][0]; };
  const ProgramRun without = check();
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_EQ(without.line()["status"], "warnings");
  EXPECT_EQ(warning(without)["code"], "material_library_missing");
  EXPECT_EQ(warning(without)["severity"], "warning");
  EXPECT_EQ(warning(without)["line"], 1);
  ASSERT_EQ(::mkfifo(folder.at("some.mtl").c_str(), 0600), 0);
  EXPECT_EQ(warning(check())["code"], "material_library_no_file");
  EXPECT_EQ(check().exit_code, 0);
  std::filesystem::remove(folder.at("some.mtl"));
  folder.write("some.mtl", "newmtl x\n");
  const ProgramRun with = check();
  EXPECT_EQ(with.exit_code, 0);
  EXPECT_EQ(with.line()["messages"], Json::array());
  Json before = without.line(), after = with.line();
  for (const char* key : {"messages", "status"}) {
    before.erase(key);
    after.erase(key);
  }
  EXPECT_EQ(before, after);
}

TEST(check, counts_lines_and_points_and_calls_no_vertex_of_a_line_isolated) {
  const TemporaryFolder folder;
  const std::string five = std::string(triangle) + "v 5 0 0\nv 6 0 0\nv 7 0 0\n";
  folder.write("lines.obj", five + "l 4 5\nl 1 2 3\nl 6 1\np 6\n");
  folder.write("alone.obj", five + "l 4 5\n");
  folder.write("points.obj", five + "l 4 5\np 6\n");
  folder.write("edges.ply",
               "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
               "property int vertex2\nend_header\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n3 0 1 2\n3 4\n");
  const ProgramRun run = run_program({"check", folder.at("lines.obj"), "--json"});
  const Json lines = run.line();
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(lines["lines"], 3);
  EXPECT_EQ(lines["points"], 1);
  EXPECT_EQ(lines["isolated_vertices"], 0);
  EXPECT_EQ(lines["euler_characteristic"], 1) << "that of the surface";
  const std::vector<std::string> keys = keys_of(lines);
  EXPECT_EQ((std::vector<std::string>(keys.begin() + 5, keys.begin() + 9)),
            (std::vector<std::string>{"faces", "lines", "points", "edges"}));
  const Json alone = run_program({"check", folder.at("alone.obj"), "--json"}).line();
  EXPECT_EQ(alone["lines"], 1);
  EXPECT_FALSE(alone.contains("points"));
  EXPECT_EQ(alone["isolated_vertices"], 1);
  EXPECT_EQ(alone["problems"][0]["elements"], Json::array({"v5"}));
  const Json points = run_program({"check", folder.at("points.obj"), "--json"}).line();
  EXPECT_EQ(points["isolated_vertices"], 1) << "a point element joins nothing";
  const ProgramRun edges = run_program({"check", folder.at("edges.ply"), "--json"});
  EXPECT_EQ(edges.exit_code, 0) << edges.out;
  EXPECT_EQ(edges.line()["lines"], 1);
  folder.write("wires.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\n");
  const Json wires = run_program({"check", folder.at("wires.obj"), "--json"}).line();
  EXPECT_EQ(wires["kind"], "wires");
  EXPECT_EQ(wires["kind_reason"]["en"], "There is no usable face; lines: 2.");
  EXPECT_EQ(lines["kind"], "surface") << "lines beside faces are not the mesh";
  folder.write("fans.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element trifans 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(run_program({"check", folder.at("fans.ply"), "--json"}).line()["kind"], "points") << "a fan is no line";
  EXPECT_NE(run_program({"check", folder.at("lines.obj")}).out.find("lines  "), std::string::npos);
}

TEST(check, walks_folders_in_byte_order) {
  const TemporaryFolder folder;
  for (const char* name : {"b.obj", "a/z.obj", "a.obj", "B.OBJ", "a/c/k.off", "notes.txt"})
    folder.write(name, std::string(name).ends_with("off") ? "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n" : triangle);
  const ProgramRun run = run_program({"check", ".", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(files_of(run.lines()),
            (std::vector<std::string>{"./B.OBJ", "./a.obj", "./a/c/k.off", "./a/z.obj", "./b.obj"}));
}

TEST(check, empty_folder_is_missing_input) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"check", folder.path().string(), "--json"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.line()["status"], "error");
  EXPECT_TRUE(run.line()["format"].is_null());
}

TEST(check, lines_come_in_input_order_however_many_jobs) {
  std::vector<std::string> arguments{"check", "--json", "--jobs", "4", asset("stanford_bunny.obj")};
  for (int i = 0; i < 20; ++i) arguments.push_back(asset(i % 2 ? "cube.obj" : "torus.off"));
  const std::vector<std::string> inputs(arguments.begin() + 4, arguments.end());
  EXPECT_EQ(files_of(run_program(arguments).lines()), inputs);
  arguments.push_back("--unordered");
  std::vector<std::string> files = files_of(run_program(arguments).lines());
  EXPECT_TRUE(std::is_permutation(files.begin(), files.end(), inputs.begin(), inputs.end()));
}

TEST(check, jobs_must_be_a_number) {
  for (const char* jobs : {"0", "-1", "two", "3x", ""})
    EXPECT_EQ(run_program({"check", asset("cube.obj"), "--jobs", jobs}).exit_code, 2) << jobs;
}

TEST(check, says_the_format_of_a_refused_file_and_of_a_misnamed_one) {
  const TemporaryFolder folder;
  folder.write("empty.obj", "");
  folder.write("cube.off", read_file(asset("cube.obj")));
  const ProgramRun empty = run_program({"check", folder.at("empty.obj"), "--json"});
  EXPECT_EQ(empty.exit_code, 4);
  EXPECT_EQ(empty.line()["messages"][0]["code"], "empty_file");
  const Json misnamed = run_program({"check", folder.at("cube.off"), "--json"}).line();
  EXPECT_EQ(misnamed["format"], "obj");
  EXPECT_EQ(misnamed["status"], "warnings");
}

TEST(check, report_for_people_names_elements_place_and_line) {
  const ProgramRun run = run_program({"check", asset("fin.obj")});
  for (const char* part : {"fin.obj (obj): warnings", "vertices", "nonmanifold_edge x1", "0-1", "line 9"})
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
  const ProgramRun japanese = run_program({"check", asset("fin.obj"), "--lang", "ja"});
  EXPECT_NE(japanese.out.find("三つ以上の面が接する稜線"), std::string::npos) << japanese.out;
}

TEST(check, many_elements_are_shortened_for_people_only) {
  const TemporaryFolder folder;
  std::string points;
  for (int i = 0; i < 50; ++i) points += "v " + std::to_string(i) + " 5 5\n";
  folder.write("p.obj", std::string(triangle) + points);
  const std::string path = folder.at("p.obj");
  EXPECT_EQ(run_program({"check", path}).out.find("v52"), std::string::npos);
  EXPECT_NE(run_program({"check", path, "-v"}).out.find("v52"), std::string::npos);
  EXPECT_EQ(run_program({"check", path, "--json"}).line()["problems"][0]["elements"].size(), 50u);
}

// Two triangles that cross and one that stands aside.
constexpr const char* crossing =
    "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 1 1\nv 2 2 1\nv 9 0 0\nv 9 1 0\nv 8 0 0\n"
    "f 7 8 9\nf 1 2 3\nf 4 5 6\n";

TEST(check, self_intersections_are_found_on_request) {
  const TemporaryFolder folder;
  const std::string path = folder.write("x.obj", crossing);
  const ProgramRun plain = run_program({"check", path, "--json"});
  EXPECT_EQ(plain.exit_code, 0);
  const ProgramRun run = run_program({"check", path, "--json", "--self-intersections"});
  EXPECT_EQ(run.exit_code, 1);
  const Json report = run.line();
  EXPECT_EQ(report["status"], "warnings");
  const Json& problem = report["problems"][0];
  EXPECT_EQ(problem["kind"], "self_intersection");
  EXPECT_EQ(problem["severity"], "problem");
  EXPECT_EQ(problem["count"], 2);
  EXPECT_EQ(problem["elements"], Json::array({"f1", "f2"}));
  EXPECT_EQ(problem["pairs"], Json::array({Json::array({"f1", "f2"})}));
  EXPECT_EQ(problem["complete"], true);
  EXPECT_EQ(problem["line"], 11);
  const ProgramRun text = run_program({"check", path, "--self-intersections"});
  EXPECT_NE(text.out.find("f1 x f2"), std::string::npos) << text.out;
}

TEST(check, says_when_more_pairs_meet_than_it_lists) {
  constexpr int faces = 1200;  // whose pairs are just more
  const TemporaryFolder folder;
  std::string stack;
  for (int i = 0; i < faces; ++i) stack += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
  const std::string path = folder.write("stack.obj", stack);
  const std::vector<std::string> words{"check", path, "--json", "--self-intersections"};
  ProgramRun run = run_unchecked(words);
  const std::string pairs = "\"pairs\":[";
  const std::size_t begin = run.out.find(pairs) + pairs.size(), end = run.out.find("]]", begin) + 1;
  ASSERT_LT(begin, end);
  const auto pair_count = std::count(run.out.begin() + static_cast<std::ptrdiff_t>(begin),
                                     run.out.begin() + static_cast<std::ptrdiff_t>(end), '[');
  // Half a million pairs take long to parse: a short run leaves one.
  if (!is_long_run()) run.out.erase(begin, run.out.rfind('[', end) - begin);
  EXPECT_EQ(fault_of_run(words, run), "");
  const Json problem = run.line()["problems"][0];
  EXPECT_EQ(problem["kind"], "self_intersection");
  EXPECT_EQ(problem["count"], faces);
  EXPECT_EQ(problem["pairs"].size(), is_long_run() ? static_cast<std::size_t>(pair_count) : 1u);
  const std::string listed = std::to_string(pair_count), all = std::to_string(faces * (faces - 1) / 2);
  EXPECT_GT(pair_count, 500000);
  EXPECT_EQ(problem["complete"], false);
  EXPECT_NE(problem["en"].get<std::string>().find("Of " + all + " pairs " + listed + " are listed."),
            std::string::npos);
  EXPECT_NE(problem["ja"].get<std::string>().find(all + " 組のうち " + listed + " 組"), std::string::npos);
}

// Two triangles on the same places, by points of their own.
TEST(check, lists_points_that_lie_on_others_as_information) {
  const TemporaryFolder folder;
  const std::string stl_facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  const std::pair<const char*, std::string> files[] = {
      {"two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n"},
      {"two.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n-0 0 0\n1 0 0\n0 1e0 0\n3 0 1 2\n3 3 4 5\n"},
      {"two.ply",
       "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
       "0 0 0\n1 0 0\n0 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 3 4 5\n"},
      {"two.stl", "solid\n" + stl_facet + stl_facet + "endsolid\n"}};
  for (const auto& [name, text] : files) {
    SCOPED_TRACE(name);
    const std::string path = folder.write(name, text);
    const bool is_welded = std::string_view(name).ends_with(".stl");
    const Json report = run_program({"check", path, "--json"}).line();
    const auto at = std::find_if(report["problems"].begin(), report["problems"].end(),
                                 [](const Json& problem) { return problem["kind"] == "coincident_points"; });
    ASSERT_EQ(at == report["problems"].end(), is_welded) << "reading STL welds them";
    EXPECT_EQ(run_program({"check", path, "--fail-on", "coincident_points"}).exit_code, is_welded ? 0 : 1);
    if (is_welded) continue;
    EXPECT_EQ((*at)["severity"], "info");
    EXPECT_EQ((*at)["count"], 6);
    EXPECT_EQ((*at)["elements"], Json::array({"v0", "v1", "v2", "v3", "v4", "v5"}));
    EXPECT_EQ((*at)["where"], Json::array({0.0, 0.0, 0.0}));
    EXPECT_EQ((*at)["en"], "6 vertices lie on others.");
    EXPECT_EQ(report["status"], "ok");
    const ProgramRun said = run_program({"check", path});
    EXPECT_EQ(said.exit_code, 0) << "it is no problem";
    EXPECT_NE(said.out.find("info coincident_points x6: 6 vertices lie on others.\n    v0, v1, v2"), std::string::npos)
        << said.out;
    EXPECT_EQ(run_program({"check", path, "--fail-on", "none"}).exit_code, 0);
  }
  EXPECT_NE(run_program({"help", "check"}).out.find("coincident_points"), std::string::npos);
}

TEST(check, pairs_of_faces_that_meet_stay_within_their_share_of_memory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  const TemporaryFolder folder;
  std::string stack;
  for (int i = 0; i < (is_long_run() ? 2500 : 1700); ++i) stack += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
  const std::string path = folder.write("stack.obj", stack);
  const std::string limit = "ulimit -d " + std::to_string((std::size_t{64} << 10) + 64 * stack.size() / 1024);
  const std::string command = shell_program() + " check --jobs 1 --self-intersections --json " + path;
  const int status = std::system((limit + "; " + command + " >/dev/null 2>&1").c_str());
  ASSERT_TRUE(WIFEXITED(status)) << "a signal ended it";
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

TEST(check, fail_on_self_intersections_looks_for_them) {
  const TemporaryFolder folder;
  const std::string path = folder.write("x.obj", crossing);
  EXPECT_EQ(run_program({"check", path, "--fail-on", "self_intersection"}).exit_code, 1);
  EXPECT_EQ(run_program({"check", asset("cube.obj"), "--fail-on", "self_intersection"}).exit_code, 0);
  EXPECT_EQ(run_program({"check", path, "--self-intersections", "--fail-on", "boundary_loop,ring"}).exit_code, 1);
  EXPECT_EQ(run_program({"check", path, "--self-intersections", "--fail-on", "none"}).exit_code, 0);
}

TEST(check, names_that_are_not_utf8_stay_different_in_json) {
  const TemporaryFolder folder;
  const std::string stand_in = "\xef\xb7\x9f";  // a character that no name should have
  for (const std::string name : {"\xfe.obj", "\xff.obj", "\xe3\x81\x82\xe3\x81.obj"}) folder.write(name, triangle);
  folder.write("\xff" + stand_in + ".obj", triangle);
  const ProgramRun run = run_program({"check", ".", "nosuch\xff.obj", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 9);
  for (const char* name : {"/\\udcfe.obj\"", "/\\udcff.obj\"", "/\xe3\x81\x82\\udce3\\udc81.obj\"",
                           "/\\udcff\\udcef\\udcb7\\udc9f.obj\"", "There is no file nosuch\\udcff.obj."})
    EXPECT_NE(run.out.find(name), std::string::npos) << name << '\n' << run.out;
  std::string text = run.out;
  for (std::size_t at = text.find("\\udc"); at != std::string::npos; at = text.find("\\udc")) text.replace(at, 6, "?");
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    EXPECT_FALSE(Json::parse(text.substr(begin, text.find('\n', begin) - begin), nullptr, false).is_discarded())
        << text;
}

TEST(check, follows_links_to_folders_once) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder, outside;
  outside.write("far.obj", triangle);
  fs::create_directories(folder.at("m/inner"));
  fs::create_directories(outside.at("deep"));
  outside.write("deep/deeper.obj", triangle);
  folder.write("m/inner/near.obj", triangle);
  fs::create_directory_symlink("..", folder.at("m/inner/up"));
  fs::create_directory_symlink("inner", folder.at("m/a_link"));
  fs::create_directory_symlink(outside.path(), folder.at("m/first"));
  fs::create_directory_symlink(outside.path(), folder.at("m/second"));
  fs::create_directory_symlink("self", folder.at("m/self"));
  const ProgramRun run = run_program({"check", "m", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::vector<std::string> files;
  for (const Json& line : run.lines()) files.push_back(line["file"]);
  EXPECT_EQ(files, (std::vector<std::string>{"m/first/deep/deeper.obj", "m/first/far.obj", "m/inner/near.obj"}));
}

TEST(check, goes_through_the_first_link_in_the_order_of_bytes) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder, outside;
  outside.write("far.obj", triangle);
  fs::create_directories(folder.at("m/a"));
  fs::create_directory_symlink(outside.path(), folder.at("m/a/zz"));
  fs::create_directory_symlink(outside.path(), folder.at("m/a-c"));
  const ProgramRun run = run_program({"check", "m", "--json"}, folder.path());
  ASSERT_EQ(run.lines().size(), 1u) << run.err;
  EXPECT_EQ(run.line()["file"], "m/a-c/far.obj") << "a hyphen comes before a slash";
}

TEST(check, says_in_the_users_language_why_a_folder_cannot_be_read) {
  const TemporaryFolder folder;
  folder.write("a.obj", triangle);
  // Folders so deep that the innermost cannot be named, not even by the administrator.
  const std::string name(250, 'n');
  int at = open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(mkdirat(at, name.c_str(), 0700), 0);
    const int below = openat(at, name.c_str(), O_RDONLY | O_DIRECTORY);
    close(std::exchange(at, below));
  }
  close(at);
  const ProgramRun run = run_program({"check", ".", "--lang", "ja"}, folder.path());
  EXPECT_EQ(run.exit_code, 9);
  EXPECT_NE(run.err.find("フォルダを読めません：名前が長すぎます。"), std::string::npos) << run.err;
}

TEST(check, faces_without_corners_stay_far_within_their_share_of_memory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  const TemporaryFolder folder;
  constexpr std::size_t faces = 4000000;  // of one byte each
  const std::string path =
      folder.write("a.ply",
                   "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                   "property float z\nelement face " +
                       std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n" +
                       std::string(36 + faces, '\0'));
  // 64 MiB and 64 bytes for each of the file are allowed, which were nearly used up.
  const auto status_within = [&](std::size_t kibibytes) {
    const std::string limit = "ulimit -d " + std::to_string(kibibytes);
    return std::system((limit + "; " + shell_program() + " check --jobs 1 " + path + " >/dev/null 2>&1").c_str());
  };
  const int status = status_within((std::size_t{64} << 10) + 52 * faces / 1024);
  ASSERT_TRUE(WIFEXITED(status)) << "a signal ended it";
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const int starved = status_within(12 * faces / 1024);
  EXPECT_FALSE(WIFEXITED(starved) && WEXITSTATUS(starved) == 1) << "the limit does not bind";
}

TEST(check, a_pipe_is_refused_without_waiting_for_it) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo(folder.at("p.obj").c_str(), 0600), 0);
  const ProgramRun run = run_program({"check", "p.obj", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.line()["messages"][0]["code"], "input_not_a_file");
  EXPECT_NE(run.err.find("p.obj is a pipe"), std::string::npos) << run.err;
  folder.copy(asset("cube.obj"), "q.obj");
  EXPECT_EQ(run_program({"check", folder.path()}).exit_code, 9) << "in a folder beside a mesh";
}

TEST(check, names_the_line_of_a_vertex) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.obj", "# one\nv 0 0 0\nv nan 0 0\n\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 3 4\nf 1 2 3\n"},
           {"a.off", "OFF\n5 2 0\n0 0 0\n\nnan 0 0\n1 0 0\n# two\n0 1 0\n9 9 9\n3 0 2 3\n3 0 1 2\n"},
           {"a.ply",
            "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n\nnan 0 0\n1 0 0\n0 1 0\n9 9 "
            "9\n"
            "3 0 2 3\n3 0 1 2\n"},
           {"a.txt", "5 2\n0 0 0\nnan 0 0\n1 0 0\n0 1 0\n9 9 9\n1 3 4\n1 2 3\n"}}) {
    const Json report = run_program({"check", folder.write(name, text), "--json"}).line();
    const auto line_of_text = [&all = text](const std::string& words) {
      return std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.find(words)), '\n') + 1;
    };
    std::size_t found = 0;
    for (const Json& problem : report["problems"]) {
      const bool is_isolated = problem["kind"] == "isolated_vertex";
      if (!is_isolated && problem["kind"] != "nonfinite_vertex") continue;
      EXPECT_EQ(problem["line"], line_of_text(is_isolated ? "9 9 9" : "nan")) << name;
      ++found;
    }
    EXPECT_EQ(found, 2u) << name;
  }
}

}  // namespace
}  // namespace ryosen::test
