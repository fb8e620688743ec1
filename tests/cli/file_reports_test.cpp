// The files of people's reports about formats (tests/data/reports), each with what must come of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

std::size_t count_lines(const std::string& text, const std::string& beginning) {
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.starts_with(beginning) ? 1 : 0;
  return count;
}

std::vector<std::string> codes_of(const Json& report) {
  std::vector<std::string> codes;
  for (const Json& message : report["messages"]) codes.push_back(message["code"]);
  return codes;
}

struct Counts {
  const char* file;
  int exit_code, vertices, triangles, faces;
  std::vector<std::string> codes;
};

TEST(file_reports, are_read_as_they_are_meant) {
  for (const Counts& known :
       {Counts{"cr_header.ply", 0, 3, 1, 1, {}}, Counts{"tristrips.ply", 0, 8, 4, 4, {}},
        Counts{"ncoff.off", 1, 4, 4, 4, {"content_mismatch"}}, Counts{"realsense.ply", 1, 3, 1, 1, {"read_by_words"}},
        Counts{"usemtl_backslash.obj", 1, 4, 1, 1, {"unknown_keyword"}}}) {
    const ProgramRun run = run_program({"check", report_file(known.file), "--json"});
    EXPECT_EQ(run.exit_code, known.exit_code) << known.file << run.err;
    EXPECT_EQ(run.line()["vertices"], known.vertices) << known.file;
    EXPECT_EQ(run.line()["triangles"], known.triangles) << known.file;
    EXPECT_EQ(run.line()["faces"], known.faces) << known.file;
    EXPECT_EQ(run.line()["quarantined"], 0) << known.file;
    EXPECT_EQ(codes_of(run.line()), known.codes) << known.file;
  }
}

TEST(file_reports, colours_go_out_as_bytes) {
  const TemporaryFolder folder;
  for (const char* format : {"ply-ascii", "ply-little", "ply-big"}) {
    ASSERT_EQ(
        run_program({"convert", report_file("colours_to_ply.obj"), "-o", "o.ply", "--format", format}, folder.path())
            .exit_code,
        0);
    EXPECT_NE(read_file(folder.at("o.ply")).find("property uchar red\nproperty uchar green\nproperty uchar blue\n"),
              std::string::npos)
        << format;
    ASSERT_EQ(run_program({"convert", "o.ply", "-o", "a.ply", "--format", "ply-ascii"}, folder.path()).exit_code, 0);
    EXPECT_NE(read_file(folder.at("a.ply")).find("\n0 0 0 128 64 255\n1 0 0 128 64 255\n0 1 0 128 64 255\n"),
              std::string::npos)
        << format;
  }
}

TEST(file_reports, colours_and_normals_of_ncoff_are_told_apart) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"convert", report_file("ncoff.off"), "-o", "o.ply", "--format", "ply-ascii"}, folder.path())
                .exit_code,
            0);
  const std::string text = read_file(folder.at("o.ply"));
  EXPECT_NE(text.find("property float nz\nproperty uchar red"), std::string::npos) << text;
  EXPECT_NE(text.find("\n0 0 0 0 0 -1 255 0 0 255\n"), std::string::npos) << text;
}

TEST(file_reports, what_an_edit_wrote_is_written_the_same_again) {
  const TemporaryFolder folder;
  for (const char* format : {"ply-ascii", "ply-little", "ply-big"}) {
    ASSERT_EQ(
        run_program({"convert", report_file("st.ply"), "-o", "in.ply", "--format", format}, folder.path()).exit_code,
        0);
    for (const std::vector<std::string>& algorithm :
         {std::vector<std::string>{"weld_equal"}, {"subdivide"}, {"simplify", "--faces", "1"}}) {
      std::vector<std::string> arguments{algorithm[0], "in.ply", "-o", "a.ply"};
      arguments.insert(arguments.end(), algorithm.begin() + 1, algorithm.end());
      const ProgramRun run = run_program(arguments, folder.path());
      ASSERT_TRUE(folder.has("a.ply")) << algorithm[0] << run.err;
      ASSERT_EQ(run_program({"convert", "a.ply", "-o", "b.ply"}, folder.path()).exit_code, 0);
      EXPECT_EQ(read_file(folder.at("a.ply")), read_file(folder.at("b.ply"))) << format << " " << algorithm[0];
      std::filesystem::remove(folder.at("a.ply"));
    }
  }
}

TEST(file_reports, texture_coordinates_that_are_left_over_are_not_written) {
  const TemporaryFolder folder;
  const auto vt_of = [&](const std::vector<std::string>& arguments) {
    EXPECT_LE(run_program(arguments, folder.path()).exit_code, 1);
    return count_lines(read_file(folder.at("out.obj")), "vt ");
  };
  EXPECT_EQ(vt_of({"simplify", report_file("leftover_vt.obj"), "--faces", "2", "-o", "out.obj"}), 4u);
  const std::size_t all = count_lines(read_file(report_file("leftover_vt.obj")), "vt ");
  EXPECT_EQ(vt_of({"convert", report_file("leftover_vt.obj"), "-o", "out.obj"}), all);
  EXPECT_EQ(vt_of({"edit", report_file("leftover_vt.obj"), "--do", "expect V 49; delete f0; undo", "-o", "out.obj"}),
            all);
}

// The indices behind the first slash of all corners.
std::set<std::string> texture_indices(const std::string& obj) {
  std::set<std::string> found;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream corners(line.starts_with("f ") ? line.substr(2) : "");
    for (std::string corner; corners >> corner;) {
      const std::string behind = corner.substr(corner.find('/') + 1);
      found.insert(behind.substr(0, behind.find('/')));
    }
  }
  return found;
}

// A square of 6 by 6 squares, each cut in two: 49 places of the texture, and 27 more that no corner has.
TEST(file_reports, whatever_changes_a_mesh_writes_the_texture_coordinates_of_its_corners) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      run_program({"convert", report_file("leftover_vt.obj"), "-o", "in.ply", "--format", "ply-big"}, folder.path())
          .exit_code,
      0);
  for (const std::string& input : {report_file("leftover_vt.obj"), std::string("in.ply")})
    for (const std::vector<std::string>& words : {std::vector<std::string>{"simplify", input, "--ratio", "0.5"},
                                                  {"unite_planar", input},
                                                  {"unite_planar", input, "--straight", "drop"},
                                                  {"remesh", input, "--length", "30%"},
                                                  {"subdivide", input},
                                                  {"edit", input, "--do", "delete f0; delete f1; delete f2"},
                                                  {"edit", input, "--do", "simplify faces=2"}}) {
      std::vector<std::string> all = words;
      all.insert(all.end(), {"-o", "out.obj", "--overwrite"});
      EXPECT_LE(run_program(all, folder.path()).exit_code, 1) << words[0];
      const std::string out = read_file(folder.at("out.obj"));
      EXPECT_EQ(count_lines(out, "vt "), texture_indices(out).size()) << words[0] << " " << words.back();
      EXPECT_GE(count_lines(out, "vt "), 4u) << words[0];
    }
}

TEST(file_reports, a_name_that_swallows_a_face_is_warned_of_with_its_line) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"convert", report_file("usemtl_backslash.obj"), "-o", "out.obj", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 0);
  ASSERT_EQ(run.line()["messages"].size(), 1u);
  EXPECT_EQ(run.line()["messages"][0]["line"], 6);
  EXPECT_NE(std::string(run.line()["messages"][0]["en"]).find("line 7, \"f 1 3 4\""), std::string::npos) << run.out;
}

TEST(file_reports, sentences_about_names_and_counts) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", ""}, {"convert", "", "-o", "o.obj"}}) {
    const ProgramRun run = run_program(words, folder.path());
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.err.find("The name of the file is empty."), std::string::npos) << run.err;
  }
  EXPECT_EQ(run_program({"check", ""}, folder.path()).out, "\"\": refused\n");
  const ProgramRun in_japanese = run_program({"check", "", "--lang", "ja"}, folder.path());
  EXPECT_NE(in_japanese.err.find("ファイル名が空です。"), std::string::npos) << in_japanese.err;
  const std::string file = report_file("two.obj");
  for (const auto& [words, exit_code] : std::initializer_list<std::pair<std::vector<std::string>, int>>{
           {{"repair", ""}, 3},
           {{"edit", "", "--do", "undo"}, 3},
           {{"edit", file, "--script", ""}, 3},
           {{"edit", file, "--do", "open \"\""}, 3},
           {{"distance", file, ""}, 3},
           {{"convert", file, "-o", ""}, 2},
           {{"repair", file, "-o", ""}, 2},
           {{"edit", file, "--do", "delete f0", "-o", ""}, 2},
           {{"edit", file, "--do", "delete f0; save \"\"", "--overwrite"}, 2},
           {{"edit", file, "--do", "delete f0; select f1; save_selected \"\""}, 2},
           {{"shot", file, "-o", ""}, 5}}) {
    const ProgramRun named = run_program(words, folder.path());
    EXPECT_EQ(named.exit_code, exit_code) << words[0] << words.back() << named.err;
    EXPECT_NE(named.err.find("The name of the file is empty."), std::string::npos) << words[0] << named.err;
  }
  EXPECT_NE(read_file(file).find("f 1 2 3"), std::string::npos) << "it was not saved over";
  folder.write("h.ply",
               "ply\nformat ascii 1.0\nelement vertex 18446744073709551616\nproperty float x\nproperty float y\n"
               "property float z\nend_header\n0 0 0\n");
  const ProgramRun run = run_program({"check", "h.ply"}, folder.path());
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_NE(run.err.find("The count 18446744073709551616 of"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace ryosen::test
