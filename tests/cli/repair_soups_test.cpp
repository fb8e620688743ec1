// `repair` on random soups in every format: its report is that of the file that is written, and a second run does
// nothing.
#include <gtest/gtest.h>

#include <map>

#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

// OBJ text of faces on few points of a small grid, often on a tetrahedron. Points may lie at one place or be in no
// face, and faces may visit a point twice.
std::string random_soup(std::uint64_t seed) {
  Dice dice(seed);
  std::string text;
  const int points = 4 + dice.below(6), size = dice.one_in(3) ? 3 : 2;
  const double step = dice.one_in(3) ? 0.1 : 1;
  for (int i = 0; i < 3 * points; ++i)
    text += (i % 3 == 0 ? "\nv " : " ") + std::to_string(step * dice.below(size) + (step < 1 ? 0.03 * dice.unit() : 0));
  std::vector<std::vector<int>> faces;
  if (dice.one_in(2)) faces = {{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {1, 4, 3}};
  for (int i = 1 + dice.below(14); i > 0; --i) {
    std::vector<int> face;
    for (int corners = dice.one_in(7) ? 4 : 3; corners > 0; --corners) face.push_back(1 + dice.below(points));
    faces.insert(faces.begin() + dice.below(static_cast<int>(faces.size()) + 1), face);
  }
  for (const std::vector<int>& face : faces) {
    text += "\nf";
    for (const int corner : face) text += " " + std::to_string(corner);
  }
  return text + "\n";
}

std::map<std::string, int> problems_of(const Json& check) {
  std::map<std::string, int> found;
  for (const Json& problem : check["problems"]) found[problem["kind"]] = problem["count"];
  return found;
}

std::map<std::string, int> left_by(const Json& report) {
  std::map<std::string, int> left;
  for (const Json& kind : report["findings"])
    if (kind["after"] != 0) left[kind["kind"]] = kind["after"];
  return left;
}

// Returns how many rounds changed something.
int expect_report_of_the_file(const std::string& input, const std::string& out, const TemporaryFolder& folder) {
  const std::string again = folder.at("again" + out.substr(out.rfind('.')));
  const Json report = run_here({"repair", input, "-o", out, "--overwrite", "--json"}).line();
  const Json check = run_here({"check", out, "--json"}).line();
  EXPECT_EQ(report["hash"], check["hash"]);
  EXPECT_EQ(left_by(report), problems_of(check));
  EXPECT_EQ(report["boundary_edges"]["after"], check["boundary_edges"]);
  const Json second = run_here({"repair", out, "-o", again, "--overwrite", "--json"}).line();
  EXPECT_EQ(second["rounds"], 0);
  for (const Json& repair : second["repairs"]) EXPECT_EQ(repair["changed"], 0) << repair["kind"];
  EXPECT_EQ(read_file(out), read_file(again));
  return report["rounds"];
}

TEST(repair_soups, a_report_is_that_of_the_file_and_a_second_run_does_nothing) {
  const TemporaryFolder folder;
  const std::uint64_t seeds = is_long_run() ? 2000 : 15;
  std::map<std::string, std::uint64_t> repaired;  // by format
  for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    const std::string input = folder.write("in.obj", random_soup(seed)), facets = folder.at("in.stl");
    run_here({"convert", input, "-o", facets, "--format", "stl-ascii", "--overwrite"});
    for (const char* const format : {"stl-ascii", "stl", "ply", "obj", "off"}) {
      const bool is_text = std::string(format) == "stl-ascii";
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + format + "\n" + random_soup(seed));
      const std::string out = folder.at(std::string("out.") + (is_text ? "stl" : format));
      repaired[format] += expect_report_of_the_file(is_text ? facets : input, out, folder) > 0;
    }
  }
  for (const auto& [format, count] : repaired) {
    EXPECT_GT(count, seeds / 10) << format;
    std::printf("%s: %zu of %zu soups repaired\n", format.c_str(), static_cast<std::size_t>(count),
                static_cast<std::size_t>(seeds));
  }
}

}  // namespace
}  // namespace ryosen::test
