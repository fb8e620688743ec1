// `repair`, and the script command of the same name.
#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <tuple>

#include "app/editor/session/session.h"
#include "tests/support/app/process.h"
#include "tests/support/app/program.h"
#include "tests/support/core/solids.h"

namespace ryosen::test {
namespace {

// Two triangles at one edge whose ends are there twice; one of them is there twice; a point of its own; a face that
// repeats a corner.
constexpr const char* broken =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 9 9\n"
    "f 1 2 3\nf 4 6 5\nf 5 4 6\nf 1 2 2\n";

const Json* repair_of(const Json& report, const std::string& kind) {
  for (const Json& repair : report["repairs"])
    if (repair["kind"] == kind) return &repair;
  return nullptr;
}

std::pair<int, int> counts_of(const Json& report, const std::string& kind) {
  for (const Json& count : report["findings"])
    if (count["kind"] == kind) return {count["before"], count["after"]};
  return {-1, -1};
}

TEST(repair, the_usual_repairs_together_take_no_number) {
  const std::string cube = asset("cube.obj");
  const ProgramRun run = run_program({"repair", cube, "--kinds", "default=5"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--kinds: default stands for several repairs and takes no number."), std::string::npos)
      << run.err;
  EXPECT_EQ(run.err.find("Did you mean"), std::string::npos) << run.err;
  EXPECT_EQ(run_program({"repair", cube, "--kinds", "default,weld_close=1e-9"}).exit_code, 0);
}

TEST(repair, gives_vertices_a_place_unasked) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("nan.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv nan 0 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  const ProgramRun run = run_program({"repair", path, "-o", folder.at("o.obj"), "--json"});
  const Json report = run.line();
  ASSERT_TRUE(repair_of(report, "give_places")) << run.out;
  EXPECT_EQ((*repair_of(report, "give_places"))["changed"], 1);
  EXPECT_EQ((*repair_of(report, "give_places"))["solves"], Json::array({"nonfinite_vertex"}));
  EXPECT_NE(read_file(folder.at("o.obj")).find("v 0.5 0.5 0\n"), std::string::npos);
  EXPECT_EQ(run_program({"edit", path, "--do", "repair default; expect F 4"}).exit_code, 0);
}

TEST(repair, keeps_all_geometry_unless_asked_and_says_what_is_left) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", broken);
  const ProgramRun run = run_program({"repair", path, "-o", folder.at("o.obj"), "--json"});
  EXPECT_EQ(run.exit_code, 1);
  const Json report = run.line();
  EXPECT_EQ(report["output"], folder.at("o.obj"));
  EXPECT_EQ(report["status"], "warnings");
  ASSERT_TRUE(repair_of(report, "remove_duplicates") && repair_of(report, "weld_equal"));
  EXPECT_EQ((*repair_of(report, "remove_duplicates"))["changed"], 1);
  EXPECT_EQ((*repair_of(report, "remove_duplicates"))["solves"], Json::array({"duplicate_face"}));
  EXPECT_EQ((*repair_of(report, "weld_equal"))["changed"], 2);
  EXPECT_EQ(repair_of(report, "fill_holes"), nullptr);
  EXPECT_EQ(report["vertices"], 5);
  EXPECT_EQ(report["faces"], 3);
  std::vector<std::string> left;
  for (const Json& problem : report["problems"]) left.push_back(problem["kind"]);
  EXPECT_EQ(left,
            (std::vector<std::string>{"degenerate_repeat", "isolated_vertex", "quarantined_face", "boundary_loop"}));
  const Json check = run_program({"check", folder.at("o.obj"), "--json"}).line();
  EXPECT_EQ(check["vertices"], 5);
  EXPECT_EQ(check["quarantined"], 1);
  EXPECT_EQ(check["hash"], report["hash"]);
  EXPECT_EQ(check["problems"].size(), report["problems"].size());
}

// OFF has no lines and OBJ no edges of its own: what only they use is isolated in the file that is written.
TEST(repair, counts_by_what_the_format_of_the_output_can_hold) {
  const TemporaryFolder folder;
  const std::string lines = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 6 6 6\nf 1 2 3\nl 4 5\n");
  const std::string edges = folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_index\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n5 5 5\n6 6 6\n3 0 1 2\n3 4\n");
  for (const auto& [input, kept, lost, loss] : {std::tuple{lines, "o.obj", "o.off", "loses_elements"},
                                                std::tuple{edges, "o.ply", "o.obj", "loses_extra_elements"}}) {
    const auto repair = [&, name = lost](const std::string& path, const std::string& kinds) {
      return run_program({"repair", path, "-o", folder.at(kinds + name), "--overwrite", "--kinds", kinds, "--json"});
    };
    const Json left = repair(input, "default").line();
    EXPECT_EQ(left["problems"][0]["kind"], "isolated_vertex") << left;
    EXPECT_EQ(left["messages"].back()["code"], loss);
    EXPECT_EQ(run_program({"check", folder.at(std::string("default") + lost)}).exit_code, 1);
    EXPECT_EQ((*repair_of(repair(input, "remove_isolated").line(), "remove_isolated"))["changed"], 2);
    EXPECT_EQ(repair(folder.at(std::string("remove_isolated") + lost), "remove_isolated").line()["rounds"], 0);
    const Json held = run_program({"repair", input, "-o", folder.at(kept), "--json"}).line();
    EXPECT_EQ(held["problems"][0]["kind"], "boundary_loop") << held;
  }
}

TEST(repair, vertices_that_other_things_of_the_file_use_are_not_isolated) {
  const TemporaryFolder folder;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 6 6 6\nv 7 7 7\n", face = "f 1 2 3\n";
  for (const std::string rest : {"f 4 4 1\n", "p 4\n", "l 4 1\n"}) {
    const std::string path = folder.write("a.obj", vertices + face + rest);
    const ProgramRun run =
        run_program({"repair", path, "-o", folder.at("o.obj"), "--kinds", "remove_isolated", "--json"});
    EXPECT_EQ((*repair_of(run.line(), "remove_isolated"))["changed"], 2) << rest;
    EXPECT_EQ((*repair_of(run.line(), "remove_isolated"))["left"], 1) << rest;
    EXPECT_EQ(read_file(folder.at("o.obj")), vertices.substr(0, vertices.find("v 6")) + face + rest);
  }
  const std::string edges =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
      "property int vertex2\nend_header\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n6 6 6\n3 0 1 2\n3 0\n";
  const ProgramRun run = run_program({"repair", folder.write("a.ply", edges), "--kinds", "remove_isolated", "--json"});
  EXPECT_EQ((*repair_of(run.line(), "remove_isolated"))["changed"], 1) << run.out;
}

TEST(repair, says_what_the_file_that_is_written_cannot_hold) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const auto codes = [](const Json& report) {
    std::vector<std::string> found;
    for (const Json& message : report["messages"]) found.push_back(message["code"]);
    return found;
  };
  const ProgramRun repair = run_program({"repair", path, "-o", folder.at("o.stl"), "--json"});
  EXPECT_EQ(repair.line()["status"], "warnings");
  EXPECT_EQ(codes(repair.line()), std::vector<std::string>{"loses_polygons"});
  EXPECT_NE(repair.err.find("more than three corners"), std::string::npos) << repair.err;
  const ProgramRun edit = run_program({"edit", path, "-o", folder.at("e.stl"), "--do", "split 0-1", "--json"});
  EXPECT_EQ(codes(edit.lines().back()), std::vector<std::string>{"loses_polygons"});
  EXPECT_EQ(edit.lines().back()["status"], "warnings");
  EXPECT_EQ(edit.exit_code, 0);
}

TEST(repair, everything_by_name) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", broken);
  const ProgramRun run = run_program(
      {"repair", path, "-o", folder.at("o.obj"), "--kinds", "drop_quarantined,remove_isolated,default", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.line()["status"], "ok");
  EXPECT_EQ(run_program({"check", folder.at("o.obj"), "--json"}).line()["quarantined"], 0);
  const ProgramRun only = run_program({"repair", path, "--kinds", "remove_isolated"});
  EXPECT_EQ(only.exit_code, 1);
  EXPECT_NE(only.out.find("remove_isolated: One isolated vertex was removed."), std::string::npos) << only.out;
  EXPECT_NE(only.out.find("duplicate_face x1"), std::string::npos) << only.out;
  EXPECT_NE(only.out.find("nothing written"), std::string::npos) << only.out;
}

TEST(repair, counts_what_an_stl_file_has_and_does_nothing_again) {
  const std::string reported = std::string(RYOSEN_SOURCE_DIR) + "/tests/data/reports/stl_report.stl";
  const TemporaryFolder folder;
  // Two solids that touch at an edge, in another format: the points of the edge are two in one and one in the other.
  const std::string touching = folder.write(
      "a.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 -1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 1 2 5\n"
      "f 1 6 2\nf 2 6 5\nf 1 5 6\n");
  for (const std::string& input : {reported, touching})
    for (const char* const kinds : {"default", "default,fill_holes,weld_close=1e-9"}) {
      const std::string out = folder.at("o.stl"), again = folder.at("again.stl");
      const Json report = run_program({"repair", input, "-o", out, "--overwrite", "--kinds", kinds, "--json"}).line();
      const Json check = run_program({"check", out, "--json"}).line();
      EXPECT_EQ(report["hash"], check["hash"]) << input;
      EXPECT_EQ(report["vertices"], check["vertices"]) << input;
      for (const Json& problem : check["problems"])
        EXPECT_EQ(counts_of(report, problem["kind"]).second, problem["count"]) << input << problem["kind"];
      const ProgramRun second = run_program({"repair", out, "-o", again, "--overwrite", "--kinds", kinds, "--json"});
      EXPECT_EQ(second.line()["rounds"], 0) << input << second.out;
      for (const Json& repair : second.line()["repairs"]) EXPECT_EQ(repair["changed"], 0) << input << repair["kind"];
      for (const Json& kind : second.line()["findings"]) EXPECT_EQ(kind["before"], kind["after"]) << kind;
      EXPECT_EQ(read_file(out), read_file(again));
    }
  const ProgramRun text = run_program({"repair", reported});
  EXPECT_NE(text.out.find("nothing to do: points at one place are one in the file"), std::string::npos) << text.out;
  EXPECT_EQ(text.exit_code, 1);
  // What helps stays: a triangle that is there twice goes.
  const std::string twice = folder.write("twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n");
  EXPECT_EQ(run_program({"repair", twice, "-o", folder.at("t.stl"), "--json"}).line()["rounds"], 1);
}

TEST(repair, a_script_tells_what_an_stl_that_it_saves_has) {
  const TemporaryFolder folder;
  const std::string touching = folder.write(
      "a.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 -1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 1 2 5\n"
      "f 1 6 2\nf 2 6 5\nf 1 5 6\n");
  const std::string told = "In the file points at one place are one: nonmanifold_edge 0 -> 1";
  const auto said = [&](const std::string& script, const std::string& out) {
    const ProgramRun run = run_program({"edit", touching, "-o", folder.at(out), "--overwrite", "--do", script});
    return run.out + run.err;
  };
  EXPECT_NE(said("repair default", "o.stl").find(told), std::string::npos) << said("repair default", "o.stl");
  const std::string saved = "repair default; save " + folder.at("s.stl");
  EXPECT_NE(said(saved, "o.off").find(told), std::string::npos) << said(saved, "o.off");
  EXPECT_EQ(said("repair default", "o.off").find(told), std::string::npos) << "points stay apart there";
  EXPECT_EQ(said("expect F 8", "o.stl").find(told), std::string::npos) << "nothing differs";
}

// A vertex that goes stays in the file at its place, where others lie, if a face set aside, a line or a point uses it.
TEST(repair, counts_removed_vertices_that_stay_in_the_file) {
  const TemporaryFolder folder;
  for (const char* const aside : {"f 1 1 3\n", "f 1 3 1\n", "f 3 1 3\n", "f 1 2 1\nf 4 4 1\n", "l 1 3\n", "p 1 3 4\n"})
    for (const char* const ending : {".obj", ".ply", ".off", ".stl"}) {
      const std::string out = folder.at(std::string("out") + ending);
      const std::string input = folder.write("in.obj",
                                             "v 1 1 1\nv 1 0 1\nv 0 1 0\nv 0 1 0\nf 3 1 2\nf 1 3 2\nf 1 2 4\n"
                                             "f 2 3 4\nf 1 4 3\nf 3 1 2\n" +
                                                 std::string(aside));
      const Json report = run_program({"repair", input, "-o", out, "--overwrite", "--json"}).line();
      const Json check = run_program({"check", out, "--json"}).line();
      for (const Json& problem : check["problems"])
        EXPECT_EQ(counts_of(report, problem["kind"]).second, problem["count"]) << aside << ending << problem["kind"];
      EXPECT_EQ(report["problems"].size(), check["problems"].size()) << aside << ending;
    }
}

// Solids and sheets that share points, edges and faces, some twice.
TEST(repair, counts_what_every_file_has_in_each_format) {
  const TemporaryFolder folder;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 1 1 1\n";
  const std::string solid = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const char* const beside[] = {"f 1 2 5\n",                             // a fin
                                "f 1 2 5\nf 2 1 5\n",                    // a fin of two sides
                                "f 4 5 6\n",                             // a sheet at a corner
                                "f 2 3 6\nf 3 4 6\nf 4 2 6\nf 2 4 3\n",  // a solid on a wall
                                "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",  // a solid on the same points
                                "f 2 3 4\n",                             // a face that is there twice
                                "f 4 3 2\n",                             // and turned over
                                "f 1 2 6 3\n"};  // a fin whose cure helps only where the unused points are gone
  for (const char* const more : beside) {
    const std::string input = folder.write("in.obj", corners + solid + more);
    for (const char* const ending : {".stl", ".ply", ".off", ".obj"}) {
      const std::string out = folder.at(std::string("out") + ending);
      const Json report = run_program({"repair", input, "-o", out, "--overwrite", "--json"}).line();
      const Json check = run_program({"check", out, "--json"}).line();
      EXPECT_EQ(report["hash"], check["hash"]) << more << ending;
      EXPECT_EQ(report["problems"].size(), check["problems"].size()) << more << ending;
      for (const Json& problem : check["problems"])
        EXPECT_EQ(counts_of(report, problem["kind"]).second, problem["count"]) << more << ending << problem["kind"];
      EXPECT_EQ(run_program({"repair", out, "--json"}).line()["rounds"], 0) << more << ending;
    }
  }
}

TEST(repair, an_inside_out_stl_is_turned) {
  const TemporaryFolder folder;
  const std::string inside = std::string(RYOSEN_SOURCE_DIR) + "/tests/data/reports/inside_out.off";
  run_program({"convert", inside, "-o", folder.at("a.stl")});
  const Json report = run_program({"repair", folder.at("a.stl"), "-o", folder.at("b.stl"), "--json"}).line();
  EXPECT_EQ(report["rounds"], 1);
  EXPECT_NEAR(run_program({"check", folder.at("b.stl"), "--json"}).line()["volume"].get<double>(), 1.0, 1e-12);
}

TEST(repair, names_the_loose_pieces_and_how_to_delete_them) {
  const TemporaryFolder folder;
  const std::string out = folder.at("o.off");
  const ProgramRun run =
      run_program({"repair", std::string(RYOSEN_SOURCE_DIR) + "/tests/data/reports/two_fins.off", "-o", out});
  EXPECT_NE(run.out.find("loose pieces: 2 (f4, f5)\n"), std::string::npos) << run.out;
  const std::string script = "select f4 f5; select linked; delete selected";
  EXPECT_NE(run.out.find("edit --do \"" + script + "\""), std::string::npos) << run.out;
  run_program({"edit", out, "-o", folder.at("solid.off"), "--do", script});
  const Json check = run_program({"check", folder.at("solid.off"), "--json"}).line();
  EXPECT_EQ(check["closed"], true);
  EXPECT_EQ(check["faces"], 4);
}

TEST(repair, stitches_within_a_distance_where_it_is_asked) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("a.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 1 -0.001 0\nv 0 -2 0\nf 1 2 3\nf 4 1 5\nf 2 4 5\n");
  EXPECT_EQ(run_program({"repair", path, "--kinds", "stitch", "--json"}).line()["rounds"], 0);
  const Json report = run_program({"repair", path, "--kinds", "stitch=0.01", "--json"}).line();
  EXPECT_EQ((*repair_of(report, "stitch"))["changed"], 1);
  EXPECT_EQ((*repair_of(report, "stitch"))["number"], 0.01);
  EXPECT_EQ(report["boundary_edges"]["after"], 4);
  EXPECT_EQ(run_program({"stitch", path, "--distance", "0.01", "--json"}).line()["crossings"], 0);
  const ProgramRun help = run_program({"help", "repair"});
  EXPECT_NE(help.out.find("every place and face stays; exact T-junctions are split"), std::string::npos) << help.out;
}

TEST(repair, fills_the_holes_of_the_bunny) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"repair", asset("stanford_bunny.obj"), "-o", folder.at("o.obj"), "--kinds", "fill_holes", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.line()["repairs"][0]["changed"], 5);
  const ProgramRun check = run_program({"check", folder.at("o.obj"), "--self-intersections", "--json"});
  EXPECT_EQ(check.exit_code, 0);
  const Json report = check.line();
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["euler_characteristic"], 2);
  EXPECT_EQ(report["problems"], Json::array());
}

TEST(repair, what_is_left_is_named_with_the_reason) {
  const TemporaryFolder folder;
  const Json json =
      run_program({"fill_holes", folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "--json"}).line();
  EXPECT_EQ(json["left"], 1);
  const Json reason{{"elements", {"0-1"}},
                    {"en", "a face on the same three points is there already"},
                    {"ja", "同じ三点の面がすでにあるため"}};
  EXPECT_EQ(json["left_for"], Json::array({reason}));
}

TEST(repair, a_recipe_tells_its_rounds_and_each_kind_before_and_after) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", broken);
  const std::vector<std::string> words{"repair", path, "--kinds", "default,remove_isolated,drop_quarantined"};
  std::vector<std::string> with_json = words;
  with_json.push_back("--json");
  const Json report = run_program(with_json).line();
  EXPECT_EQ(report["rounds"], 1);
  EXPECT_EQ(counts_of(report, "duplicate_face"), std::pair(1, 0));
  EXPECT_EQ(counts_of(report, "quarantined_face"), std::pair(1, 0));
  EXPECT_EQ(counts_of(report, "isolated_vertex"), std::pair(1, 0));
  EXPECT_EQ(counts_of(report, "nonmanifold_edge").second, 0);
  EXPECT_EQ(counts_of(report, "self_intersection"), std::pair(-1, -1)) << "not looked for";
  const ProgramRun text = run_program(words);
  for (const char* line : {"rounds: 1\n", "\n  degenerate_repeat: 1 -> 0\n", "\n  duplicate_face: 1 -> 0\n"})
    EXPECT_NE(text.out.find(line), std::string::npos) << text.out;
  const ProgramRun risen = run_program({"repair", asset("three_tri_edge.off")});
  EXPECT_NE(risen.out.find("boundary_loop: 0 -> 2 (+2)"), std::string::npos) << risen.out;
}

TEST(repair, solids_that_share_a_face_stay_closed_and_a_second_run_does_nothing) {
  const TemporaryFolder folder;
  const std::string reports = std::string(RYOSEN_SOURCE_DIR) + "/tests/data/reports/";
  for (const auto& [name, parts, boundary] : {std::tuple{"touching_tets.off", 2, 0}, std::tuple{"two_fins.off", 3, 6}})
    for (const char* const format : {"off", "obj", "ply"}) {
      const std::string out = folder.at(std::string(name) + "." + format);
      run_program({"repair", reports + name, "-o", out});
      const Json check = run_program({"check", out, "--json"}).line();
      EXPECT_EQ(check["components"], parts);
      EXPECT_EQ(check["boundary_edges"], boundary);
      EXPECT_EQ(check["manifold"], true);
      EXPECT_EQ(run_program({"repair", out, "--json"}).line()["rounds"], 0);
    }
}

std::string off_of(const IndexedMesh& mesh) {
  std::ostringstream text;
  text << "OFF\n" << mesh.positions.size() << " " << mesh.face_offsets.size() - 1 << " 0\n";
  for (const auto& p : mesh.positions) text << p.x << " " << p.y << " " << p.z << "\n";
  for (std::size_t f = 1; f < mesh.face_offsets.size(); ++f) {
    text << mesh.face_offsets[f] - mesh.face_offsets[f - 1];
    for (std::size_t i = mesh.face_offsets[f - 1]; i < mesh.face_offsets[f]; ++i) text << " " << mesh.corners[i];
    text << "\n";
  }
  return text.str();
}

// As exporters write them, each face with points of its own.
TEST(repair, loose_faces_of_solids_that_touch_become_closed_ones) {
  std::array<SolidBuilder, 7> solids;
  std::array<std::size_t, 7> parts{2, 2, 8, 2, 2, 2, 3};
  for (const int x : {0, 1}) {
    solids[0].add_cube({x, 0, 0});
    solids[1].add_cube({x, 0, 0}, true);
    for (int i = 0; i < 4; ++i) solids[2].add_cube({x, i % 2, i / 2});
    solids[3].add_cube({x, x, 0}, true);  // on an edge
    solids[4].add_cube({x, x, x});        // in a point
    solids[5].add_tetrahedron({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2 * x - 1}}});
    solids[6].add_cube({0, 0, x});
  }
  solids[6].add_tetrahedron({{{1, 0, 1}, {1, 1, 1}, {3, 0, 1}, {3, 0, 2}}});
  const TemporaryFolder folder;
  Dice dice(1);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    solids[i].shuffle(dice);
    const std::string path = folder.write("a" + std::to_string(i) + ".off", off_of(solids[i].loose()));
    for (const char* const format : {"off", "obj", "ply"}) {
      SCOPED_TRACE(std::to_string(i) + " " + format);
      const std::string in = folder.at("in" + std::to_string(i) + "." + format);
      const std::string out = folder.at("out" + std::to_string(i) + "." + format);
      run_program({"convert", path, "-o", in});
      run_program({"repair", in, "-o", out});
      const Json check = run_program({"check", out, "--json"}).line();
      EXPECT_EQ(check["components"], parts[i]);
      EXPECT_EQ(check["boundary_edges"], 0);
      EXPECT_EQ(check["manifold"], true);
      EXPECT_NEAR(check["volume"].get<double>(), static_cast<double>(solids[i].volume_six()) / 6, 1e-12);
      EXPECT_EQ(run_program({"repair", out, "--json"}).line()["rounds"], 0);
    }
  }
}

TEST(repair, a_pair_back_to_back_stays_and_is_said_to_be_deleted) {
  const TemporaryFolder folder;
  const std::string out = folder.at("o.obj");
  const ProgramRun run = run_program({"repair", asset("hanging_pair.obj"), "-o", out});
  EXPECT_NE(run.out.find("\n    No repair takes these away, since they bound a closed part: delete one of the two"),
            std::string::npos)
      << run.out;
  Session session(Document::open(asset("hanging_pair.obj")).value());
  ASSERT_TRUE(session.run("repair default").done());
  const std::string told = ryosen::told(*session.findings().last_repair(), session.mesh()).en;
  EXPECT_NE(told.find("Hanging pair: no repair takes it away, \"delete\" does"), std::string::npos) << told;
  const auto hanging = [](const std::string& path) {
    return run_program({"check", path, "--json"}).line()["hanging_pairs"].get<int>();
  };
  EXPECT_EQ(hanging(out), 1);
  const std::string none = folder.at("none.obj");
  EXPECT_EQ(run_program({"edit", out, "-o", none, "--do", "select f2; delete selected"}).exit_code, 0);
  EXPECT_EQ(hanging(none), 0);
}

TEST(repair, the_recipe_of_the_readme_leaves_the_bunny_closed_and_does_nothing_again) {
  const TemporaryFolder folder;
  const std::string kinds = "default,weld_close=0.001,remove_degenerate,fill_holes";
  const std::string out = folder.at("o.ply");
  EXPECT_EQ(run_program({"repair", asset("stanford_bunny.obj"), "-o", out, "--kinds", kinds}).exit_code, 0);
  const Json check = run_program({"check", out, "--json"}).line();
  EXPECT_EQ(check["manifold"], true);
  EXPECT_EQ(check["closed"], true);
  const Json again = run_program({"repair", out, "--kinds", kinds, "--json"}).line();
  EXPECT_EQ(again["rounds"], 0);
  EXPECT_EQ(again["hash"], check["hash"]);
}

TEST(repair, wrong_use_is_explained) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", broken);
  const ProgramRun unknown = run_program({"repair", path, "--kinds", "fill_hole"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("Did you mean 'fill_holes'?"), std::string::npos) << unknown.err;
  for (const char* kinds : {"weld_close", "weld_close=x", "weld_close=-1", "orient=2", "", "orient,"})
    EXPECT_EQ(run_program({"repair", path, "--kinds", kinds}).exit_code, 2) << kinds;
  EXPECT_EQ(run_program({"repair", path, "-o", path}).exit_code, 5);
  EXPECT_EQ(read_file(path), broken);
  EXPECT_EQ(run_program({"repair", path, "-o", folder.at("o.xyz")}).exit_code, 2);
  EXPECT_EQ(run_program({"repair", folder.at("none.obj"), "-o", folder.at("o.obj")}).exit_code, 3);
  EXPECT_EQ(run_program({"repair", path, "-o", folder.at("no/such/o.obj")}).exit_code, 5);
  EXPECT_EQ(run_program({"repair", path, "-o", path, "--overwrite"}).exit_code, 1);
}

TEST(repair, is_a_command_of_scripts_and_one_entry_of_the_history) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", broken);
  const auto edit = [&](const std::string& commands) {
    return run_program({"edit", path, "--do", commands, "--json"}).exit_code;
  };
  EXPECT_EQ(
      edit("repair remove_duplicates; repair weld_equal; expect V 5; expect F 2; undo; expect V 7; undo; expect F 3"),
      0);
  EXPECT_EQ(edit("repair remove_duplicates; repair weld_close 0.5; undo; redo; expect V 5"), 0);
  EXPECT_EQ(edit("repair orient; repair orient"), 0) << "nothing to do is no failure";
  EXPECT_EQ(edit("repair"), 2);
  EXPECT_EQ(edit("repair weld_close"), 2);
  const ProgramRun run =
      run_program({"edit", path, "--do", "repair drop_quarantined; undo; redo; undo", "-o", folder.at("kept.obj")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run_program({"check", folder.at("kept.obj"), "--json"}).line()["quarantined"], 1);
  run_program({"edit", path, "--do", "repair drop_quarantined; undo; redo", "-o", folder.at("dropped.obj")});
  EXPECT_EQ(run_program({"check", folder.at("dropped.obj"), "--json"}).line()["quarantined"], 0);
}

TEST(repair, help_lists_every_repair_with_what_it_solves) {
  const ProgramRun help = run_program({"help", "repair"});
  for (const char* part : {"weld_close=DISTANCE", "fill_holes", "detach_nonmanifold", "solves degenerate_area"})
    EXPECT_NE(help.out.find(part), std::string::npos) << part << "\n" << help.out;
}

TEST(repair, an_interrupt_cancels_it_and_nothing_is_written) {
  const TemporaryFolder folder;
  Process repair({RYOSEN_PROGRAM, "repair", folder.write("band.obj", bands_around_holes()), "-o", folder.at("o.obj"),
                  "--kinds", "orient,fill_holes", "--lang", "en"},
                 {}, folder.at("out"), folder.at("err"));
  const auto has_begun = [&] { return read_file(folder.at("out")).find("orient: ") != std::string::npos; };
  wait_for([&] { return has_begun() || repair.is_over(); }, std::chrono::seconds(120));
  ASSERT_TRUE(has_begun()) << read_file(folder.at("err"));
  repair.end_by(SIGINT);
  EXPECT_EQ(repair.exit_code(), 8);
  EXPECT_NE(read_file(folder.at("err")).find("Cancelled; nothing is written."), std::string::npos);
  EXPECT_FALSE(folder.has("o.obj"));
}

TEST(repair, cancelled_in_a_session_leaves_mesh_and_history_as_they_were) {
  const TemporaryFolder folder;
  auto document = Document::open(folder.write("band.obj", bands_around_holes()));
  ASSERT_TRUE(document.ok());
  Session session(std::move(document).value());
  const std::uint64_t before = session.mesh().hash();
  std::vector<double> shares;
  session.frontend.on_progress = [&](double share) {
    shares.push_back(share);
    return shares.size() < 3;
  };
  const Outcome outcome = session.run("repair fill_holes");
  EXPECT_EQ(outcome.kind, Outcome::Kind::failed);
  EXPECT_EQ(outcome.exit_code, ExitCode::cancelled);
  EXPECT_FALSE(outcome.sentence.ja.empty());
  EXPECT_EQ(shares.size(), 3u);
  EXPECT_EQ(session.mesh().hash(), before);
  EXPECT_FALSE(session.document().is_modified());
  EXPECT_TRUE(session.log().empty());
  session.frontend.on_progress = {};
  EXPECT_TRUE(session.run("repair remove_isolated").done()) << "goes on as if nothing had been";
}

}  // namespace
}  // namespace ryosen::test
