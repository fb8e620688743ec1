// fill_holes as a command: files of reports, and what files of floats hold.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "tests/support/app/program.h"
#include "tests/support/core/open_shapes.h"

namespace ryosen::test {
namespace {

Json figures_of(const std::string& path) { return run_program({"check", path, "--json"}).line(); }

// As ASCII with properties of type float.
std::string float_ply(const IndexedMesh& list) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(list.positions.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(list.face_count()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const glm::dvec3& p : list.positions) {
    char line[100];
    std::snprintf(line, sizeof line, "%.9g %.9g %.9g\n", p.x, p.y, p.z);
    text += line;
  }
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    text += std::to_string(list.face(f).size());
    for (const std::uint32_t corner : list.face(f)) text += " " + std::to_string(corner);
    text += "\n";
  }
  return text;
}

TEST(fill_holes, keeps_the_files_of_reports_in_shape) {
  const TemporaryFolder folder;
  const std::string out = folder.at("out.off");
  ASSERT_EQ(run_program({"fill_holes", report_file("planar_hole.off"), "-o", out}).exit_code, 0);
  EXPECT_NEAR(figures_of(out)["volume"].get<double>(), 2.3776, 1e-4);
  ASSERT_EQ(run_program({"fill_holes", report_file("degenerate_rim.off"), "-o", out, "--overwrite"}).exit_code, 0);
  EXPECT_EQ(figures_of(out)["closed"], true);
  EXPECT_NEAR(figures_of(out)["volume"].get<double>(), 9, 1e-9);
  const ProgramRun refused = run_program({"fill_holes", report_file("pierced_hole.off"), "-o", out, "--overwrite"});
  EXPECT_NE(refused.out.find("crosses the surface or itself at f3, crossing=allow fills anyway"), std::string::npos)
      << refused.out;
  EXPECT_EQ(figures_of(out)["boundary_loops"], 2);
  const Json allowed = run_program({"fill_holes", report_file("pierced_hole.off"), "-o", out, "--overwrite",
                                    "--crossing", "allow", "--json"})
                           .line();
  EXPECT_EQ(allowed["changed"], 1);
  EXPECT_EQ(allowed["crossings"], 1);
  EXPECT_EQ(figures_of(out)["boundary_loops"], 1) << "that of the triangle which pierces it";
}

TEST(fill_holes, is_flat_in_files_of_floats_whose_rims_were_turned) {
  const TemporaryFolder folder;
  for (const std::uint32_t corners : {5u, 12u, 31u, 48u}) {
    const std::string in = folder.write("cup.ply", float_ply(as_floats(turned(cup(corners, 1.3, 1)))));
    ASSERT_EQ(run_program({"convert", in, "-o", folder.at("cup.stl"), "--overwrite"}).exit_code, 0);
    for (const char* name : {"cup.ply", "cup.stl"}) {
      const ProgramRun run = run_program({"fill_holes", folder.at(name), "-o", folder.at("out.ply"), "--overwrite"});
      EXPECT_NE(run.out.find(": flat (shape=fair continues the surface)."), std::string::npos) << run.out;
      const double base = corners * std::sin(2 * M_PI / corners) / 2;
      EXPECT_NEAR(figures_of(folder.at("out.ply"))["volume"].get<double>(), base * (1 + 1.3 + 1.69) / 3, 1e-5);
    }
  }
}

TEST(fill_holes, is_named_among_repairs_as_it_is_written_there) {
  const auto said = [](const char* kinds) {
    return run_program({"repair", report_file("planar_hole.off"), "--kinds", kinds, "--lang", "en"}).out;
  };
  EXPECT_TRUE(said("fill_holes").starts_with("fill_holes: One hole was filled")) << said("fill_holes");
  EXPECT_TRUE(said("fill_holes=9").starts_with("fill_holes=9: One hole was filled"));
  EXPECT_TRUE(said("fill_holes=shape=fair").starts_with("fill_holes=shape=fair: One hole was filled"));
  EXPECT_NE(said("fill_holes=shape=fair").find(": fair."), std::string::npos);
}

}  // namespace
}  // namespace ryosen::test
