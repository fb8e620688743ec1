// `forms --growth`: how the work of the forms grows, as lines, as a table and as a picture.
#include <gtest/gtest.h>

#include <set>

#include "render/image.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/pairing.h"
#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

TEST(form_growth_command, prints_a_line_per_curve) {
  const std::vector<Json> lines = run_program({"forms", asset("torus.off"), "--growth", "--json"}).lines();
  std::set<std::string> pairings, forms_asked, relations;
  for (const Json& line : lines) {
    ASSERT_FALSE(line["points"].empty());
    for (std::size_t i = 1; i < line["points"].size(); ++i)
      EXPECT_GT(line["points"][i]["faces"], line["points"][i - 1]["faces"]);
    EXPECT_NE(line["counted"]["en"], line["counted"]["ja"]);
    if (line["of"] == "pairing") pairings.insert(line["id"]);
    if (line["of"] != "query") {
      EXPECT_TRUE(line["relation"].is_null());
      continue;
    }
    forms_asked.insert(line["id"]);
    relations.insert(line["relation"]);
  }
  EXPECT_EQ(pairings.size(), pairing_methods().size());
  for (const forms::FormRow& form : forms::all_forms())
    EXPECT_EQ(forms_asked.contains(std::string(form.id)), form.stores_vertices) << form.id;
  EXPECT_EQ(relations.size(), forms::relation_count);
}

TEST(form_growth_command, measures_tori_where_there_is_no_file) {
  if (!is_long_run()) GTEST_SKIP() << "about two seconds; growth_test measures smaller ones";
  const std::vector<Json> lines = run_program({"forms", "--growth", "--json"}).lines();
  ASSERT_GT(lines.size(), 100u);
  EXPECT_EQ(lines[0]["id"], "brute_force");
  EXPECT_NEAR(lines[0]["slope"].get<double>(), 2, 0.01);
  EXPECT_GT(lines[1]["points"].back()["faces"], 50'000);
}

TEST(form_growth_command, writes_the_curves_in_both_themes_and_languages) {
  TemporaryFolder folder;
  std::vector<Image> pictures;
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{}, {"--theme", "light"}, {"--lang", "ja"}, {"--relation", "valence"}}) {
    const std::string path = folder.at(std::to_string(pictures.size()) + ".png");
    std::vector<std::string> line{"forms", asset("torus.off"), "--growth", "--plot", path};
    line.insert(line.end(), more.begin(), more.end());
    const ProgramRun run = run_program(line);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    pictures.push_back(read_png(path).value());
    EXPECT_EQ(pictures.back().size.width, 1440);
    EXPECT_GT(pictures.back().size.height, 600);
  }
  const auto ground = [&](std::size_t i) { return pictures[i].at(2, 2); };
  EXPECT_EQ(ground(0), ground(2));
  EXPECT_LT(ground(0)[0] + 100, ground(1)[0]) << "dark and light";
  for (std::size_t i = 1; i < pictures.size(); ++i) EXPECT_FALSE(pictures[i] == pictures[0]) << i;
}

TEST(form_growth_command, says_where_a_mesh_has_one_size_alone) {
  const std::string small = run_program({"forms", asset("tetrahedron.off"), "--growth", "--lang", "en"}).out;
  EXPECT_EQ(small.find("Measured at one size alone, 4 faces: too few"), 0u) << small;
  EXPECT_EQ(run_program({"forms", asset("torus.off"), "--growth", "--lang", "en"}).out.find("Growth from "), 0u);
}

TEST(form_growth_command, takes_only_what_goes_together) {
  TemporaryFolder folder;
  const std::string mesh = asset("torus.off"), empty = folder.write("empty.off", "OFF\n0 0 0\n");
  const std::vector<std::pair<std::vector<std::string>, int>> wrong = {
      {{"forms"}, 2},
      {{"forms", mesh, "--plot", folder.at("p.png")}, 2},
      {{"forms", mesh, "--growth", "--theme", "light"}, 2},
      {{"forms", mesh, "--growth", "--element", "v0"}, 2},
      {{"forms", mesh, "--growth", "--plot", folder.at("p.png"), "--theme", "pink"}, 2},
      {{"forms", mesh, "--growth", "--plot", folder.at("p.png"), "--relation", "x"}, 2},
      {{"forms", mesh, "--growth", "--plot", folder.at("nosuch/p.png")}, 5},
      {{"forms", empty, "--growth"}, 6}};
  for (const auto& [line, exit_code] : wrong) EXPECT_EQ(run_program(line).exit_code, exit_code) << line.back();
}

}  // namespace
}  // namespace ryosen::test
