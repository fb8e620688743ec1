// `hull`: the contract of its output, what it reads and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

class HullCommand : public testing::Test {
 protected:
  // Of points alone, a line each.
  ProgramRun hull_of(const std::string& lines, std::vector<std::string> flags = {}) {
    const std::string file = folder_.write("points.xyz", lines);
    std::vector<std::string> words{"hull", file, "--json", "-v"};
    words.insert(words.end(), flags.begin(), flags.end());
    return run_program(words);
  }
  TemporaryFolder folder_;
};

constexpr const char* cube_with_more =
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n.5 .5 .5\n.5 0 0\n1 .5 .5\n0 0 0\n";

TEST_F(HullCommand, says_what_the_hull_of_a_cube_is) {
  const Json line = hull_of(cube_with_more).line();
  EXPECT_EQ(line["dimension"], 3);
  EXPECT_EQ(line["vertices"], 8);
  EXPECT_EQ(line["facets"], 6);
  EXPECT_EQ(line["volume"], 1.0);
  EXPECT_EQ(line["area"], 6.0);
  EXPECT_EQ(line["used"], 12);
  EXPECT_EQ(line["points"], 12);
  EXPECT_EQ(line["facet_list"], Json::parse("[[0,1,5,4],[0,3,2,1],[0,4,7,3],[1,2,6,5],[2,3,7,6],[4,5,6,7]]"));
  EXPECT_TRUE(line["output"].is_null());
  EXPECT_EQ(line["status"], "ok");
}

TEST_F(HullCommand, writes_facets_or_triangles) {
  const std::string facets = folder_.at("facets.obj"), triangles = folder_.at("triangles.obj");
  EXPECT_EQ(hull_of(cube_with_more, {"-o", facets}).line()["facets"], 6);
  const Json line = hull_of(cube_with_more, {"--triangles", "-o", triangles}).line();
  EXPECT_EQ(line["facets"], 6) << "the united ones";
  EXPECT_EQ(line["output"], triangles);
  const Json checked = run_program({"check", facets, "--json"}).line();
  EXPECT_EQ(checked["quads"], 6);
  EXPECT_EQ(checked["volume"], 1.0);
  EXPECT_EQ(run_program({"check", triangles, "--json"}).line()["triangles"], 12);
  EXPECT_NE(read_file(triangles).find("f 1 2 6\nf 1 6 5\n"), std::string::npos) << "fans from the lowest number";
}

TEST_F(HullCommand, answers_in_every_dimension) {
  const std::pair<const char*, Json> cases[] = {
      {"", {-1, 0, 0, 0.0}},
      {"# nothing\n", {-1, 0, 0, 0.0}},
      {"1 2 3\n1 2 3\n", {0, 1, 0, 0.0}},
      {"0 0 0\n1 1 1\n2 2 2\n", {1, 2, 0, 0.0}},
      {"0 0 0\n2 0 0\n0 2 0\n2 2 0\n1 1 0\n", {2, 4, 1, 4.0}},
  };
  for (const auto& [lines, expected] : cases) {
    const std::string output = folder_.at("o" + std::to_string(&lines - &cases[0].first) + ".obj");
    const ProgramRun run = hull_of(lines, {"-o", output});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Json line = run.line();
    EXPECT_EQ(Json({line["dimension"], line["vertices"], line["facets"], line["area"]}), expected) << lines;
    EXPECT_EQ(line["volume"], 0.0);
    EXPECT_TRUE(folder_.has(std::filesystem::path(output).filename()));
  }
  EXPECT_EQ(hull_of(cases[4].first).line()["facet_list"], Json::parse("[[0,1,3,2]]"));
}

TEST_F(HullCommand, an_edge_and_a_point_are_written_as_far_as_the_format_holds_them) {
  const char* const segment = "0 0 0\n1 1 1\n2 2 2\n";
  hull_of(segment, {"-o", folder_.at("o.obj")});
  EXPECT_NE(read_file(folder_.at("o.obj")).find("l 1 2"), std::string::npos);
  const Json ply = hull_of(segment, {"-o", folder_.at("o.ply")}).line();
  EXPECT_EQ(ply["status"], "warnings");
  EXPECT_EQ(ply["messages"][0]["code"], "loses_wires");
  for (const char* const lines : {"", "1 2 3\n", segment}) {
    const ProgramRun run = hull_of(lines, {"-o", folder_.at("o.stl")});
    EXPECT_EQ(run.exit_code, 6);
    EXPECT_EQ(run.line()["status"], "error");
    EXPECT_EQ(run.line()["messages"][0]["code"], "refused");
    EXPECT_FALSE(folder_.has("o.stl"));
  }
  EXPECT_EQ(hull_of("0 0 0\n1 0 0\n0 1 0\n", {"-o", folder_.at("o.stl")}).exit_code, 0);
}

TEST_F(HullCommand, reads_points_alone) {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string obj = folder_.write("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const std::string ply = folder_.write("p.ply",
                                        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                                        "property float z\nend_header\n" +
                                            corners);
  for (const std::string& file : {obj, ply}) {
    const ProgramRun run = run_program({"hull", file, "--json", "-v"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.line()["facet_list"], Json::parse("[[0,1,3],[0,2,1],[0,3,2],[1,2,3]]")) << file;
  }
  const Json wide = hull_of("0 0 0 255 1\n1 0 0\n0 1 0\n0 0 1\n").line();
  EXPECT_EQ(wide["facets"], 4);
  EXPECT_EQ(wide["messages"][0]["code"], "extra_values");
  EXPECT_EQ(hull_of("0 0\n").exit_code, 4);
  EXPECT_EQ(hull_of("0 0 zero\n").exit_code, 4);
}

TEST_F(HullCommand, reads_standard_input) {
  const std::string points = folder_.write("points", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"), nothing = folder_.write("no", "");
  const auto dimension = [&](const std::string& input) {
    const std::string output = folder_.at("line");
    const std::string line = shell_program() + " hull - --json < " + shell_word(input) + " > " + shell_word(output);
    EXPECT_EQ(std::system(line.c_str()), 0);
    return Json::parse(read_file(output))["dimension"];
  };
  EXPECT_EQ(dimension(points), 3);
  EXPECT_EQ(dimension(nothing), -1);
  EXPECT_EQ(dimension("/dev/null"), -1);
}

TEST_F(HullCommand, refuses_what_is_not_finite_unless_it_may_be_left_out) {
  const std::string lines = "nan 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1e999\n0 0 1\n";
  const ProgramRun refused = hull_of(lines);
  EXPECT_EQ(refused.exit_code, 6);
  EXPECT_NE(refused.err.find("v0"), std::string::npos);
  const Json line = hull_of(lines, {"--skip-nonfinite"}).line();
  EXPECT_EQ(line["points"], 6);
  EXPECT_EQ(line["used"], 4);
  EXPECT_EQ(line["facet_list"], Json::parse("[[1,2,5],[1,3,2],[1,5,3],[2,3,5]]"));
}

TEST_F(HullCommand, figures_hold_for_huge_and_tiny_coordinates) {
  const Json tiny = hull_of("0 0 0\n1e-100 0 0\n0 1e-100 0\n0 0 1e-100\n").line();
  EXPECT_NEAR(double(tiny["volume"]) * 1e300, 1 / 6., 1e-9);
  const Json huge = hull_of("0 0 0\n1e300 0 0\n0 1e300 0\n0 0 1e300\n-1e308 -1e308 -1e308\n").line();
  EXPECT_TRUE(huge["volume"].is_null());
  EXPECT_EQ(huge["vertices"], 4);
  EXPECT_EQ(hull_of("5e-324 0 0\n0 5e-324 0\n0 0 5e-324\n0 0 0\n").line()["facets"], 4);
}

// Facets are exact there, so what is summed over them must not cancel.
TEST_F(HullCommand, figures_hold_for_nearly_flat_and_for_skewed_points) {
  const Json flat =
      hull_of(
          "133.71428571428572 0.7142857142857143 134.42857142857144\n"
          "102.71428571428571 46.142857142857146 148.85714285714286\n"
          "92.42857142857143 87.14285714285714 179.57142857142856\n41 22.571428571428573 63.57142857142857\n",
          {"--measure"})
          .line();
  EXPECT_EQ(flat["dimension"], 3);
  EXPECT_NEAR(flat["volume"], 1.352e-11, 1e-14) << "by fractions";
  EXPECT_GT(flat["width"], 0.0);
  const Json skewed = hull_of(
                          "1e308 5e-324 -1e200\n-1e-300 -1e-300 1e308\n1.0000000000000002 -1e200 0\n"
                          "1e308 -1e-300 1.0000000000000002\n")
                          .line();
  EXPECT_TRUE(skewed["volume"].is_null()) << "it is beyond the largest number";
}

TEST_F(HullCommand, measures_how_long_and_how_thin_it_is) {
  const Json line = hull_of(cube_with_more, {"--measure"}).line();
  EXPECT_DOUBLE_EQ(line["diameter"], std::sqrt(3));
  EXPECT_EQ(line["farthest"], Json({0, 6}));
  EXPECT_EQ(line["width"], 1.0);
  EXPECT_EQ(line["between"], Json::parse("[[0,1,5,4],[3]]"));
  EXPECT_EQ(line["extreme"], Json({0, 1, 2, 3, 4, 5, 6, 7}));
  const Json edges = hull_of("1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n", {"--measure"}).line();
  EXPECT_EQ(edges["width"], 2.0);
  EXPECT_EQ(edges["between"].size(), 2u);
  EXPECT_EQ(edges["between"][0].size(), 2u) << edges;
  const Json polygon = hull_of("0 0 0\n4 0 0\n4 1 0\n0 1 0\n", {"--measure"}).line();
  EXPECT_EQ(polygon["width"], 1.0);
  EXPECT_EQ(polygon["between"], Json::parse("[[0,1],[2]]"));
  const Json segment = hull_of("0 0 0\n3 4 0\n", {"--measure"}).line();
  EXPECT_EQ(segment["diameter"], 5.0);
  EXPECT_EQ(segment["width"], 0.0);
  EXPECT_EQ(segment["between"], Json::array());
  const Json nothing = hull_of("", {"--measure"}).line();
  EXPECT_EQ(nothing["diameter"], 0.0);
  EXPECT_EQ(nothing["farthest"], Json::array());
  const std::string text = run_program({"hull", asset("cube.obj"), "--measure", "--lang", "en"}).out;
  EXPECT_NE(text.find("Farthest apart: v0 and v6, 1.73205081. Smallest width: 1,"), std::string::npos) << text;
}

TEST_F(HullCommand, makes_one_of_each_component) {
  const std::string file = folder_.write(
      "parts.obj",
      "v 5 5 5\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 6 5 5\nv 6 6 5\nv 9 9 9\nv 7 7 7\nv 8 8 8\nv 6.5 5.5 5\n"
      "f 2 3 4\nf 2 3 5\nf 1 6 7\nl 9 10\n");
  const std::string output = folder_.at("o.obj");
  const Json line = run_program({"hull", file, "--per-component", "--measure", "--json", "-v", "-o", output}).line();
  EXPECT_EQ(line["dimension"], 3);
  EXPECT_EQ(line["points"], 11);
  EXPECT_EQ(line["vertices"], 3 + 4 + 1 + 2 + 1);
  EXPECT_EQ(line["facets"], 5);
  EXPECT_NEAR(line["volume"], 1 / 6., 1e-15);
  EXPECT_NEAR(line["area"], .5 + 1.5 + std::sqrt(.75), 1e-12);
  EXPECT_EQ(line["facet_list"], Json::parse("[[0,5,6],[1,2,4],[1,3,2],[1,4,3],[2,3,4]]"));
  EXPECT_FALSE(line.contains("diameter"));
  std::vector<Json> dimensions, extremes;
  for (const Json& part : line["components"]) {
    dimensions.push_back(part["dimension"]);
    extremes.push_back(part["extreme"]);
  }
  EXPECT_EQ(Json(dimensions), Json({2, 3, 0, 1, 0}));
  EXPECT_EQ(Json(extremes), Json::parse("[[0,5,6],[1,2,3,4],[7],[8,9],[10]]"));
  EXPECT_NEAR(line["components"][3]["diameter"], std::sqrt(3), 1e-12);
  const Json checked = run_program({"check", output, "--json"}).line();
  EXPECT_EQ(checked["faces"], 5);
  EXPECT_EQ(checked["components"], 2);
  EXPECT_EQ(run_program({"hull", asset("cube.obj"), "--per-component", "--json"}).line()["components"].size(), 1u);
  EXPECT_EQ(run_program({"hull", folder_.write("none.xyz", ""), "--per-component", "--json"}).line()["dimension"], -1);
  const std::string script = "hull per_component=on; expect V 22; expect F 8";
  EXPECT_EQ(run_program({"edit", file, "--do", script}).exit_code, 0);
}

TEST_F(HullCommand, of_points_seen_along_an_axis) {
  const char* const lines = "0 0 0\n2 0 1\n2 3 0\n0 3 1\n1 1 9\n1 4 0\n";
  const Json along_z = hull_of(lines, {"--project", "z"}).line();
  EXPECT_EQ(along_z["dimension"], 2);
  EXPECT_EQ(along_z["facet_list"], Json::parse("[[0,1,2,5,3]]"));
  EXPECT_EQ(along_z["area"], 7.0);
  EXPECT_EQ(hull_of(lines, {"--project", "best"}).line(), hull_of(lines, {"--project", "x"}).line());
  const Json along_y = hull_of(lines, {"--project", "y", "-o", folder_.at("o.obj")}).line();
  EXPECT_EQ(along_y["vertices"], 5);
  EXPECT_NE(read_file(folder_.at("o.obj")).find("v 1 0 9"), std::string::npos);
  EXPECT_EQ(hull_of("0 0 0\n0 0 5\n", {"--project", "z"}).line()["dimension"], 0);
  EXPECT_EQ(hull_of("nan 0 0\n0 0 5\n", {"--project", "x"}).exit_code, 6);
  for (const char* const wrong : {"none", "w", ""})
    EXPECT_EQ(hull_of(lines, {"--project", wrong}).exit_code, 2) << wrong;
  EXPECT_EQ(run_program({"edit", asset("cube.obj"), "--do", "hull project=y; expect V 12; expect F 7"}).exit_code, 0);
}

TEST_F(HullCommand, says_what_is_wrong_with_its_words) {
  EXPECT_EQ(hull_of("", {"--facets", "--triangles"}).exit_code, 2);
  EXPECT_EQ(hull_of("", {"-o", folder_.at("o.xyz")}).exit_code, 2) << "that is only read";
  EXPECT_EQ(hull_of("", {"-o", folder_.at("points.xyz")}).exit_code, 2);
  const std::string cube = folder_.copy(asset("cube.obj"), "cube.obj");
  EXPECT_EQ(run_program({"hull", cube, "-o", cube}).exit_code, 5);
  EXPECT_EQ(run_program({"hull", cube, "-o", cube, "--overwrite"}).exit_code, 0);
  EXPECT_EQ(run_program({"hull", "nosuch.obj"}).exit_code, 3);
  const std::string text = run_program({"hull", cube, "--lang", "en"}).out;
  EXPECT_NE(text.find("8 vertices and 6 facets"), std::string::npos) << text;
}

TEST_F(HullCommand, the_command_of_scripts_adds_the_same) {
  const std::string cube = asset("cube.obj");
  const Json edit = run_program({"edit", cube, "--do", "hull; expect V 16; expect F 12", "--json"}).lines().back();
  EXPECT_EQ(edit["status"], "ok") << edit;
  EXPECT_EQ(
      run_program({"edit", cube, "--do", "hull triangles elements=v0,v1,v2,v5; expect V 12; expect F 10"}).exit_code,
      0);
}

}  // namespace
}  // namespace ryosen::test
