// `convert`: formats, losses, refusals.
#include <gtest/gtest.h>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

constexpr const char* quads =
    "# two quads\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0.1\nv 2 1 0\ng left\nf 1 2 3 4\ng right\nf 2 5 6 3\n";

Json loss(const Json& report, const std::string& code) {
  for (const Json& entry : report["losses"])
    if (entry["code"] == code) return entry;
  return {};
}

TEST(convert, numbers_that_single_precision_loses_altogether_are_said_as_that) {
  const TemporaryFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1e-60 1\nv 0 1e39 -1e300\nv 0.1 2 0\nf 1 2 3\nf 2 3 4\nf 1 2 5\n");
  const auto convert = [&](std::vector<std::string> further) {
    further.insert(further.begin(), {"convert", "a.obj", "--json"});
    return run_program(further, folder.path());
  };
  const Json report = convert({"-o", "o.stl"}).line();
  EXPECT_EQ(loss(report, "loses_large_numbers")["count"], 1);
  EXPECT_NE(
      loss(report, "loses_large_numbers")["en"].get<std::string>().find("which become infinite: 1 (the first is v3)"),
      std::string::npos);
  EXPECT_EQ(loss(report, "loses_small_numbers")["count"], 1);
  EXPECT_NE(loss(report, "loses_small_numbers")["ja"].get<std::string>().find("1 個(最初は v2)。"), std::string::npos);
  EXPECT_EQ(loss(report, "loses_precision")["count"], 1);
  EXPECT_EQ(run_program({"check", folder.at("o.stl"), "--json"}).line()["nonfinite_vertices"], 1);
  EXPECT_EQ(convert({"-o", "strict.stl", "--strict"}).exit_code, 6);
  EXPECT_EQ(convert({"-o", "text.stl", "--format", "stl-ascii", "--strict"}).exit_code, 0);
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1e99 0 1e-99\nf 1 2 3\n");
  const Json unused = convert({"-o", "unused.stl"}).line();
  EXPECT_EQ(loss(unused, "loses_isolated_vertices")["count"], 1);
  EXPECT_TRUE(loss(unused, "loses_large_numbers").is_null() && loss(unused, "loses_small_numbers").is_null())
      << "what is not written becomes nothing";
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1e99 0 0\nf 1 2 3\nf 1 1 4\n");
  EXPECT_EQ(loss(convert({"-o", "quarantined.stl"}).line(), "loses_large_numbers")["count"], 1)
      << "a quarantined face is written too";
}

TEST(convert, a_number_of_a_vertex_beyond_32_bits_is_lost_in_binary_alone) {
  const TemporaryFolder folder;
  folder.write("a.off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 5000000000\n3 0 1 4000000000\n");
  const auto count = [&](const char* format) {
    const Json report =
        run_program({"convert", "a.off", "-o", "o.ply", "--format", format, "--json"}, folder.path()).line();
    return loss(report, "loses_quarantined").is_null() ? 0 : loss(report, "loses_quarantined")["count"].get<int>();
  };
  EXPECT_EQ(count("ply-ascii"), 0);
  EXPECT_EQ(count("ply-little"), 2) << "with a sign both are too large";
  folder.write("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 4000000000\n");
  EXPECT_EQ(count("ply-little"), 0) << "without a sign it is not";
}

TEST(convert, writes_the_format_of_the_name) {
  const TemporaryFolder folder;
  folder.write("a.obj", quads);
  for (const char* name : {"b.off", "b.ply", "b.stl", "b.txt", "b.obj"}) {
    const ProgramRun run = run_program({"convert", "a.obj", "-o", name, "--json"}, folder.path());
    EXPECT_EQ(run.exit_code, 0) << name << run.err;
    const Json report = run.line();
    EXPECT_EQ(report["output"], name);
    EXPECT_EQ(report["from"], "obj");
    EXPECT_EQ(report["vertices"], 6);
    const Json check = run_program({"check", folder.at(name), "--json"}).line();
    EXPECT_EQ(check["vertices"], 6) << name;
    EXPECT_EQ(check["quads"], name == std::string("b.stl") || name == std::string("b.txt") ? 0 : 2) << name;
    EXPECT_EQ(check["format"], std::string(name).substr(2));
  }
}

TEST(convert, names_what_is_lost_with_counts) {
  const TemporaryFolder folder;
  folder.write("a.obj", quads);
  const ProgramRun run = run_program({"convert", "a.obj", "-o", "b.stl", "--json"}, folder.path());
  const Json report = run.line();
  EXPECT_EQ(report["status"], "warnings");
  EXPECT_EQ(report["losses"].size(), 3u);
  EXPECT_EQ(loss(report, "loses_polygons")["count"], 2);
  EXPECT_EQ(loss(report, "loses_precision")["count"], 1);
  EXPECT_EQ(loss(report, "loses_groups")["count"], 2);
  EXPECT_NE(run.err.find("b.stl: warning: STL"), std::string::npos) << run.err;
  const ProgramRun japanese = run_program({"convert", "a.obj", "-o", "c.stl", "--lang", "ja"}, folder.path());
  EXPECT_NE(japanese.err.find("保持できません"), std::string::npos) << japanese.err;
  EXPECT_NE(japanese.out.find("c.stl"), std::string::npos);
}

TEST(convert, strict_refuses_and_writes_nothing) {
  const TemporaryFolder folder;
  folder.write("a.obj", quads);
  const ProgramRun run = run_program({"convert", "a.obj", "-o", "b.stl", "--strict", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_EQ(run.line()["status"], "error");
  EXPECT_TRUE(run.line()["output"].is_null());
  EXPECT_EQ(run.line()["losses"].size(), 3u);
  EXPECT_FALSE(folder.has("b.stl"));
  EXPECT_EQ(run_program({"convert", "a.obj", "-o", "b.ply", "--strict"}, folder.path()).exit_code, 6) << "groups";
  EXPECT_EQ(run_program({"convert", "a.obj", "-o", "b.obj", "--strict"}, folder.path()).exit_code, 0);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.obj", "b.obj"}));
}

TEST(convert, formats_and_triangles) {
  const TemporaryFolder folder;
  folder.write("a.obj", quads);
  const ProgramRun text = run_program(
      {"convert", "a.obj", "-o", "b.any", "--format", "stl-ascii", "--triangulate", "--json"}, folder.path());
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.line()["faces"], 4);
  EXPECT_EQ(loss(text.line(), "loses_polygons"), Json());
  EXPECT_EQ(read_file(folder.at("b.any")).substr(0, 11), "solid left\n");
  run_program({"convert", "a.obj", "-o", "b.ply", "--format", "ply-big"}, folder.path());
  EXPECT_NE(read_file(folder.at("b.ply")).find("format binary_big_endian 1.0\n"), std::string::npos);
  run_program({"convert", "b.ply", "-o", "c.ply", "--format", "ply-ascii"}, folder.path());
  EXPECT_NE(read_file(folder.at("c.ply")).find("\n4 1 4 5 2\n"), std::string::npos) << read_file(folder.at("c.ply"));
  EXPECT_NE(read_file(folder.at("c.ply")).find("\n2 0 0.1\n"), std::string::npos) << "to the last bit";
}

TEST(convert, points_that_rounding_brings_to_one_place) {
  const TemporaryFolder folder;
  folder.write("near.obj", "v 0 0 0\nv 0.1 0 0\nv 0.10000000001 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 4\nf 2 3 4\nf 1 4 5\n");
  const Json rounded = run_program({"convert", "near.obj", "-o", "b.stl", "--json"}, folder.path()).line();
  EXPECT_EQ(loss(rounded, "loses_topology")["count"], 1);
  EXPECT_EQ(run_program({"check", folder.at("b.stl"), "--json"}).line()["vertices"], 4) << "of 5";
  const Json text =
      run_program({"convert", "near.obj", "-o", "c.stl", "--format", "stl-ascii", "--json"}, folder.path()).line();
  EXPECT_TRUE(text["losses"].empty()) << text;
  EXPECT_EQ(run_program({"check", folder.at("c.stl"), "--json"}).line()["vertices"], 5);
}

TEST(convert, faces_that_were_set_aside_and_points_at_one_place) {
  const TemporaryFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\nf 4 5 6\nf 1 2 9\n");
  const Json report = run_program({"convert", "a.obj", "-o", "b.stl", "--json"}, folder.path()).line();
  EXPECT_EQ(loss(report, "loses_quarantined")["count"], 1);
  EXPECT_EQ(loss(report, "loses_topology")["count"], 2);
  const ProgramRun ply = run_program({"convert", "a.obj", "-o", "b.ply", "--strict", "--json"}, folder.path());
  EXPECT_EQ(ply.exit_code, 0) << ply.err;
  EXPECT_EQ(run_program({"check", folder.at("b.ply"), "--json"}).line()["quarantined"], 1);
}

TEST(convert, what_cannot_be_done) {
  const TemporaryFolder folder;
  folder.write("a.obj", quads);
  EXPECT_EQ(run_program({"convert", "a.obj"}, folder.path()).exit_code, 2);
  EXPECT_EQ(run_program({"convert", "a.obj", "-o", "b"}, folder.path()).exit_code, 2);
  const ProgramRun misspelt = run_program({"convert", "a.obj", "-o", "b.stl", "--format", "slt"}, folder.path());
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_NE(misspelt.err.find("'stl'"), std::string::npos) << misspelt.err;
  EXPECT_EQ(run_program({"convert", "no.obj", "-o", "b.stl"}, folder.path()).exit_code, 3);
  EXPECT_EQ(run_program({"convert", asset("obj_16_text_coord.obj"), "-o", "b.stl"}, folder.path()).exit_code, 4);
  EXPECT_EQ(run_program({"convert", "a.obj", "-o", "a.obj"}, folder.path()).exit_code, 5);
  EXPECT_EQ(run_program({"convert", "a.obj", "-o", "no/b.off"}, folder.path()).exit_code, 5);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.obj"});
  EXPECT_EQ(run_program({"convert", "a.obj", "-o", "a.obj", "--overwrite"}, folder.path()).exit_code, 0);
}

TEST(convert, a_wrong_name_is_said) {
  const TemporaryFolder folder;
  folder.copy(asset("tetrahedron.off"), "a.obj");
  const ProgramRun run = run_program({"convert", "a.obj", "-o", "b.ply", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.line()["from"], "off");
  EXPECT_EQ(run.line()["messages"][0]["code"], "content_mismatch");
}

TEST(convert, edited_files_keep_what_belongs_to_them) {
  const TemporaryFolder folder;
  folder.write("a.ply",
               "ply\nformat ascii 1.0\ncomment kept\nelement vertex 5\nproperty float x\nproperty float y\n"
               "property float z\nproperty int id\nelement face 3\nproperty list uchar int vertex_indices\n"
               "property int label\nelement edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n"
               "0 0 0 10\n1 0 0 11\n1 1 0 12\n0 1 0 13\n9 9 9 14\n3 0 1 2 20\n3 0 2 7 21\n3 0 2 3 22\n0 1\n2 4\n");
  const ProgramRun run = run_program({"edit", "a.ply", "--do", "split 0-2; delete v4", "-o", "b.ply"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string text = read_file(folder.at("b.ply"));
  EXPECT_NE(text.find("comment kept\nelement vertex 6\n"), std::string::npos) << text;
  EXPECT_NE(text.find("9 9 9 14\n0.5 0.5 0 10\n"), std::string::npos) << "as the first end of the edge" << text;
  EXPECT_NE(text.find(" 8 21\n"), std::string::npos) << "the face that was set aside stays" << text;
  EXPECT_EQ(text.substr(text.size() - 8), "0 1\n2 4\n") << "the edge keeps the vertex that is gone" << text;
  const Json report = run_program({"check", folder.at("b.ply"), "--json"}).line();
  EXPECT_EQ(report["quarantined"], 1);
  EXPECT_EQ(report["faces"], 5);
}

TEST(convert, strict_refuses_what_reading_left_out) {
  const TemporaryFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvp 0 1\nf 1 2 3\nsurf 0 1 0 1 1 2 3\n");
  const ProgramRun strict = run_program({"convert", "a.obj", "-o", "b.obj", "--strict", "--json"}, folder.path());
  EXPECT_EQ(strict.exit_code, 6);
  EXPECT_FALSE(folder.has("b.obj"));
  ASSERT_EQ(strict.line()["losses"].size(), 1u);
  EXPECT_EQ(strict.line()["losses"][0]["code"], "loses_unread_lines");
  EXPECT_EQ(strict.line()["losses"][0]["count"], 2);
  EXPECT_EQ(run_program({"convert", "a.obj", "-o", "b.obj", "--json"}, folder.path()).exit_code, 0);
}

}  // namespace
}  // namespace ryosen::test
