// `measure`: the numbers of a mesh, of whatever shape.
#include <gtest/gtest.h>

#include <cmath>

#include "ryosen/scene/highlights/colour_maps.h"
#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

TEST(measure_command, says_the_numbers_of_a_cube) {
  const ProgramRun run = run_program({"measure", asset("cube.obj"), "--map", "edge_length", "--bars", "4", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json line = run.line();
  EXPECT_EQ(line["sort"], "edge");
  EXPECT_EQ(line["unit"], "length");
  EXPECT_EQ(line["count"], 12);
  for (const char* const key : {"lowest", "highest", "mean", "median", "percentile_5", "percentile_95"})
    EXPECT_EQ(line[key], 1.0) << key;
  EXPECT_EQ(line["deviation"], 0.0);
  EXPECT_EQ(line["histogram"].size(), 4u);
  int all = 0;
  for (const Json& bar : line["histogram"]) all += int(bar["count"]);
  EXPECT_EQ(all, 12);
}

TEST(measure_command, has_a_line_for_every_map) {
  const ProgramRun run = run_program({"measure", asset("torus.off"), "--json"});
  std::vector<const ColourMap*> maps;
  for (const ColourMap& map : colour_maps())
    if (!map.against) maps.push_back(&map);
  ASSERT_EQ(run.lines().size(), maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const Json line = run.lines()[i];
    EXPECT_EQ(line["map"], maps[i]->id);
    EXPECT_TRUE(line["histogram"].is_null());
    if (line["count"] == 0) continue;
    EXPECT_LE(double(line["lowest"]), double(line["median"])) << line;
    EXPECT_LE(double(line["median"]), double(line["highest"])) << line;
  }
  const std::string text = run_program({"measure", asset("torus.off"), "--lang", "en"}).out;
  for (const ColourMap* const map : maps) EXPECT_NE(text.find(map->name_en), std::string::npos) << map->id;
}

TEST(measure_command, measures_from_another_mesh_where_one_is_named) {
  const TemporaryFolder folder;
  const std::string cube = asset("cube.obj"), larger = folder.at("larger.obj");
  ASSERT_EQ(run_program({"translate", cube, "-o", larger, "--by", "0,0,0.25"}).exit_code, 0);
  const Json line = run_program({"measure", larger, "--against", cube, "--map", "distance", "--json"}).line();
  EXPECT_EQ(line["sort"], "vertex");
  EXPECT_EQ(line["unit"], "length");
  EXPECT_EQ(line["count"], 8);
  EXPECT_EQ(line["lowest"], 0.0) << "of the corners within its sides";
  EXPECT_EQ(line["highest"], 0.25);
  EXPECT_EQ(run_program({"measure", larger, "--map", "distance"}).exit_code, 2);
  EXPECT_EQ(run_program({"measure", larger, "--against", "nosuch.obj"}).exit_code, 3);
}

TEST(measure_command, tells_the_curvature_of_a_sphere) {
  const TemporaryFolder folder;
  const std::string sphere = folder.at("sphere.obj");
  ASSERT_EQ(run_program({"sphere", "-o", sphere, "--radius", "2"}).exit_code, 0);
  for (const auto& [map, unit, value] : {std::tuple{"mean_curvature", "per_length", 0.5},
                                         {"gaussian_curvature", "per_area", 0.25},
                                         {"largest_curvature", "per_length", 0.5},
                                         {"smallest_curvature", "per_length", 0.5}}) {
    const Json line = run_program({"measure", sphere, "--map", map, "--json"}).line();
    EXPECT_EQ(line["unit"], unit);
    EXPECT_NEAR(double(line["median"]), value, 0.06 * value) << map << ", of a coarse one";
  }
}

TEST(measure_command, measures_what_is_named) {
  const ProgramRun run = run_program({"measure", asset("cube.obj"), "v0", "v1", "--json"});
  EXPECT_EQ(run.line()["elements"], Json({"v0", "v1"}));
  EXPECT_EQ(run.line()["values"][0]["value"], 1.0);
  EXPECT_EQ(run_program({"measure", asset("cube.obj"), "f0", "--lang", "en"}).out, "area 1, perimeter 4\n");
}

TEST(measure_command, refuses_what_it_cannot_measure) {
  const std::string cube = asset("cube.obj");
  const std::vector<std::pair<std::vector<std::string>, int>> wrong = {{{"measure", cube, "v99"}, 2},
                                                                       {{"measure", cube, "--map", "edge_lenght"}, 2},
                                                                       {{"measure", cube, "--bars", "0"}, 2},
                                                                       {{"measure", cube, "--bars", "x"}, 2},
                                                                       {{"measure", cube, "v0", "--bars", "3"}, 2},
                                                                       {{"measure", cube, "v0"}, 6},
                                                                       {{"measure", "nosuch.obj"}, 3}};
  for (const auto& [line, exit_code] : wrong) {
    const ProgramRun run = run_program(line);
    EXPECT_EQ(run.exit_code, exit_code) << line.back();
    EXPECT_FALSE(run.err.empty()) << line.back();
  }
  EXPECT_NE(run_program(wrong[1].first).err.find("edge_length"), std::string::npos);
}

// Nothing that is no number comes out of places that are none, of faces without area, or of nothing.
TEST(measure_command, knows_ugly_meshes) {
  const TemporaryFolder folder;
  const std::vector<std::string> files = {
      folder.write("empty.obj", "# nothing\n"),
      folder.write("points.obj", "v 0 0 0\nv 1 0 0\n"),
      folder.write("far.off", "OFF\n4 2 0\n0 0 0\n1e308 0 0\n0 1e308 0\n-1e308 -1e308 0\n3 0 1 2\n3 0 2 3\n"),
      folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 0 0\nf 1 2 3\nf 1 4 2\n"),
      asset("fin.obj"),
      asset("bow_tie.obj"),
      asset("collinear.obj"),
      asset("isolated_vertex.obj"),
      asset("klein_bottle.off")};
  for (const std::string& file : files) {
    const ProgramRun run = run_program({"measure", file, "--bars", "5", "--json"});
    EXPECT_EQ(run.exit_code, 0) << file << run.err;
    for (const Json& line : run.lines()) {
      EXPECT_EQ(line["lowest"].is_null(), line["count"] == 0) << file << line;
      for (const char* const key : {"lowest", "highest", "median", "percentile_5", "percentile_95"})
        EXPECT_EQ(line[key].is_null(), line["count"] == 0) << file << ' ' << key << line;
      std::size_t all = 0;
      for (const Json& bar : line["histogram"]) all += std::size_t(bar["count"]);
      EXPECT_EQ(all, std::size_t(line["count"])) << file << line;
    }
    EXPECT_EQ(run.out.find("nan"), std::string::npos) << file;
    EXPECT_EQ(run_program({"measure", file, "--bars", "5"}).out.find("nan"), std::string::npos) << file;
  }
}

}  // namespace
}  // namespace ryosen::test
