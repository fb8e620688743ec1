// The figures of `check` against those of meshes that others made, and its answers to malformed files. Both collections
// lie beside the project; where they do not, the assets alone are compared with what is known of them.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

struct KeyPair {
  const char *reported, *known;
};

constexpr KeyPair compared_keys[] = {
    {"vertices", "V_file"},
    {"faces", "F_file"},
    {"edges", "E"},
    {"triangles", "tri"},
    {"quads", "quad"},
    {"polygons", "poly5plus"},
    {"boundary_edges", "boundary_edges"},
    {"boundary_loops", "boundary_loops"},
    {"nonmanifold_edges", "nm_edges"},
    {"max_edge_faces", "max_edge_faces"},
    {"nonmanifold_vertices", "nm_vertices"},
    {"bowtie_vertices", "bowtie_vertices"},
    {"misoriented_edges", "inconsistent_edges"},
    {"degenerate_repeat", "deg_repeat"},
    {"degenerate_area", "deg_zero_area"},
    {"duplicate_faces", "dup_faces"},
    {"isolated_vertices", "isolated_v"},
    {"nonfinite_vertices", "nonfinite_v"},
    {"components", "components"},
    {"euler_characteristic", "chi"},
    {"genus", "genus"},
    {"manifold", "manifold"},
    {"closed", "closed"},
    {"orientable", "orientable"},
};

std::vector<Json> read_lines(const std::string& path) {
  std::vector<Json> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) rows.push_back(Json::parse(line));
  return rows;
}

void compare_with_truth(const std::string& folder) {
  const std::string truth = shared_file(folder + "/truth.jsonl");
  if (truth.empty()) return;
  std::vector<std::string> arguments{"check", "--json"};
  std::vector<Json> rows;
  for (Json& row : read_lines(truth)) {
    const std::string file = shared_file(folder + "/" + std::string(row["file"]));
    if (file.empty()) continue;
    arguments.push_back(file);
    rows.push_back(std::move(row));
  }
  const std::vector<Json> reports = run_program(arguments).lines();
  ASSERT_EQ(reports.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i]["status"] != "ok") {
      EXPECT_NE(reports[i]["status"], "ok") << rows[i]["file"];
      continue;
    }
    ASSERT_NE(reports[i]["status"], "error") << reports[i];
    for (const KeyPair& key : compared_keys) {
      if (key.reported == std::string("vertices") && reports[i]["format"] == "stl") {
        EXPECT_EQ(reports[i]["vertices"], rows[i]["V"]) << rows[i]["file"];
        continue;
      }
      // The figures of that table know no lines.
      if (key.known == std::string("isolated_v") && reports[i].contains("lines")) continue;
      EXPECT_EQ(reports[i][key.reported], rows[i][key.known]) << rows[i]["file"] << key.known;
    }
  }
}

TEST(check_truth, real_meshes) { compare_with_truth("meshes"); }
TEST(check_truth, known_meshes) { compare_with_truth("meshes/known"); }

// The place that a row of the manifest names is among those of the messages and problems.
bool names_place(const Json& report, const std::string& where) {
  if (where.rfind("line ", 0) != 0) return true;
  const int line = std::stoi(where.substr(5));
  for (const char* list : {"messages", "problems"})
    if (report.contains(list))
      for (const Json& entry : report[list])
        if (entry.contains("line") && entry["line"] == line) return true;
  return false;
}

TEST(check_truth, malformed_files) {
  const std::string manifest = shared_file("malformed/manifest.jsonl");
  if (manifest.empty()) return;
  for (const Json& row : read_lines(manifest)) {
    const std::string name = row["file"];
    const std::string file = shared_file("malformed/" + name);
    if (file.empty()) continue;
    const ProgramRun run = run_program({"check", file, "--json"});
    const Json report = run.line();
    // These two rows name a line at which the file does not have what they speak of.
    const bool has_other_line = name == "stla_02_truncated_facet.stl" || name == "stla_06_nan.stl";
    EXPECT_TRUE(has_other_line || names_place(report, row["where"])) << row << report;
    if (row["expect"] == "error") {
      EXPECT_EQ(run.exit_code, 4) << row;
      EXPECT_EQ(report["status"], "error") << row;
      continue;
    }
    EXPECT_EQ(report["vertices"], row["V"]) << row;
    EXPECT_EQ(static_cast<int>(report["faces"]) - static_cast<int>(report["quarantined"]), row["F"]) << row;
    if (row["expect"] == "warn") {
      EXPECT_EQ(report["status"], "warnings") << row;
      // Whether a material library is there does not set the exit code.
      const bool is_about_library = !report["messages"].empty() &&
                                    report["messages"][0]["code"] == "material_library_missing" &&
                                    report["problems"].empty();
      EXPECT_EQ(run.exit_code, is_about_library ? 0 : 1) << row;
    }
    if (row["expect"] == "ok") {
      EXPECT_EQ(report["messages"], Json::array()) << row;
    }
  }
}

struct AssetFigures {
  const char* name;
  int vertices, edges, faces, euler, boundary_loops;
  std::vector<std::string> problems;
};

TEST(check_truth, assets) {
  const AssetFigures assets[] = {
      {"tetrahedron.off", 4, 6, 4, 2, 0, {}},
      {"cube.obj", 8, 12, 6, 2, 0, {}},
      {"fan.obj", 7, 12, 6, 1, 1, {}},
      {"two_quads.obj", 6, 7, 2, 1, 1, {}},
      {"bow_tie.obj", 5, 6, 2, 1, 2, {"nonmanifold_vertex"}},
      {"fin.obj", 5, 7, 3, 1, 0, {"nonmanifold_edge", "nonmanifold_vertex"}},
      {"moebius.off", 18, 36, 18, 0, 1, {"misoriented_edge"}},
      {"misoriented.obj", 4, 5, 2, 1, 1, {"misoriented_edge"}},
      {"sliver.obj", 5, 8, 4, 1, 1, {}},
      {"collinear.obj", 5, 8, 4, 1, 1, {"degenerate_area"}},
      {"duplicate_face.obj", 4, 4, 2, 2, 0, {"misoriented_edge", "duplicate_face"}},
      {"hanging_pair.obj", 4, 5, 3, 2, 0, {"nonmanifold_edge", "nonmanifold_vertex", "duplicate_face", "hanging_pair"}},
      {"isolated_vertex.obj", 4, 3, 1, 1, 1, {"isolated_vertex"}},
      {"torus.off", 48, 144, 96, 0, 0, {}},
      {"figures/000-5a.obj", 15, 22, 8, 1, 1, {}},
      {"figures/000-5b.obj", 18, 27, 10, 1, 0, {"nonmanifold_edge", "nonmanifold_vertex"}},
  };
  for (const AssetFigures& known : assets) {
    const Json report = run_program({"check", asset(known.name), "--json"}).line();
    EXPECT_EQ(report["vertices"], known.vertices) << known.name;
    EXPECT_EQ(report["edges"], known.edges) << known.name;
    EXPECT_EQ(report["faces"], known.faces) << known.name;
    EXPECT_EQ(report["euler_characteristic"], known.euler) << known.name;
    EXPECT_EQ(report["boundary_loops"], known.boundary_loops) << known.name;
    // Chains of boundary edges end at edges of three faces alone.
    if (report["nonmanifold_edges"] == 0) {
      EXPECT_TRUE(report["open_boundary"].is_null()) << known.name;
    }
    std::vector<std::string> problems;
    for (const Json& problem : report["problems"])
      if (problem["severity"] == "problem") problems.push_back(problem["kind"]);
    EXPECT_EQ(problems, known.problems) << known.name;
  }
}

// 16 boundary edges, but no 0 beside them.
TEST(check_truth, says_why_there_is_no_number_of_boundary_loops) {
  const std::string text = run_program({"check", asset("figures/000-5b.obj")}).out;
  EXPECT_NE(text.find("boundary edges    16    boundary loops     -"), text.npos) << text;
  EXPECT_NE(text.find("  boundary Some boundary edges end at an edge of three or more faces and close to no loop.\n"),
            text.npos)
      << text;
  const Json line = run_program({"check", asset("figures/000-5b.obj"), "--json"}).line();
  EXPECT_NE(line["open_boundary"]["en"], "");
  EXPECT_NE(line["open_boundary"]["ja"], "");
  const std::string whole = run_program({"check", asset("figures/000-5a.obj")}).out;
  EXPECT_NE(whole.find("boundary loops     1"), whole.npos) << whole;
  EXPECT_EQ(whole.find("close to no loop"), whole.npos) << whole;
}

}  // namespace
}  // namespace ryosen::test
