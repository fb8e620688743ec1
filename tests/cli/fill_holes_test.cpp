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

template <class Number>
std::string binary_ply(const IndexedMesh& list) {
  const char* const type = sizeof(Number) == 4 ? "float" : "double";
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(list.positions.size());
  for (const char* name : {"x", "y", "z"}) bytes += std::string("\nproperty ") + type + " " + name;
  bytes +=
      "\nelement face " + std::to_string(list.face_count()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto add = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const glm::dvec3& p : list.positions)
    for (int axis = 0; axis < 3; ++axis) add(static_cast<Number>(p[axis]));
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    add(static_cast<std::uint8_t>(list.face(f).size()));
    for (const std::uint32_t corner : list.face(f)) add(corner);
  }
  return bytes;
}

// The numbers are the same floats in all files.
TEST(fill_holes, is_flat_in_the_precision_of_the_type_of_the_file) {
  const TemporaryFolder folder;
  for (const std::uint32_t corners : {7u, 12u, 31u}) {
    const IndexedMesh list = as_floats(turned(cup(corners, 1.3, 1)));
    folder.write("single.ply", binary_ply<float>(list));
    folder.write("double.ply", binary_ply<double>(list));
    ASSERT_EQ(run_program({"convert", folder.at("single.ply"), "-o", folder.at("a.stl"), "--overwrite"}).exit_code, 0);
    ASSERT_EQ(run_program({"convert", folder.at("single.ply"), "-o", folder.at("a.obj"), "--overwrite"}).exit_code, 0);
    for (const auto& [name, told] :
         {std::pair("single.ply", ": flat"), {"a.stl", ": flat"}, {"a.obj", ": flat"}, {"double.ply", ": fair"}}) {
      for (const bool by_repair : {false, true}) {
        const std::string in = folder.at(name);
        const ProgramRun run = by_repair ? run_program({"repair", in, "--kinds", "fill_holes", "--lang", "en"})
                                         : run_program({"fill_holes", in, "--lang", "en"});
        EXPECT_NE(run.out.find(told), std::string::npos) << name << " " << run.out;
      }
    }
  }
}

TEST(fill_holes, is_flat_where_a_mesh_of_floats_was_moved) {
  const TemporaryFolder folder;
  const std::string in = folder.write("single.ply", binary_ply<float>(as_floats(turned(cup(12, 1.3, 1)))));
  const std::string rotate = "rotate angle=31 axis=1,2,3";
  for (const std::string& script :
       {rotate + "; fill_holes", rotate + "; undo; fill_holes", rotate + "; undo; redo; fill_holes",
        "translate by=0.1,0.2,0.3; " + rotate + "; fill_holes", rotate + "; repair fill_holes"}) {
    const std::string out = folder.at("out.ply");
    const ProgramRun run = run_program({"edit", in, "-o", out, "--overwrite", "--do", script});
    ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
    const double base = 12 * std::sin(M_PI / 6) / 2;
    EXPECT_NEAR(figures_of(out)["volume"].get<double>(), base * (1 + 1.3 + 1.69) / 3, 1e-5) << script;
  }
  // The file that was saved has doubles, since floats do not hold these places.
  run_program({"edit", in, "-o", folder.at("moved.ply"), "--do", rotate});
  EXPECT_NE(read_file(folder.at("moved.ply")).find("property double x"), std::string::npos);
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
