// The flags and exit codes of `shot`.
#include <gtest/gtest.h>

#include <filesystem>

#include "render/image.h"
#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using test::asset;
using test::run_program;

int shot(const std::string& mesh, const std::string& output, std::vector<std::string> flags) {
  flags.insert(flags.begin(), {"shot", mesh, "-o", output, "--size", "320x240"});
  return run_program(flags).exit_code;
}

TEST(shot, writes_a_picture_of_the_size_asked_for) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(shot(asset("cube.obj"), folder.at("a.png"), {}), 0);
  const Result<Image> picture = read_png(folder.at("a.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->size, (Size{320, 240}));
}

TEST(shot, gives_equal_bytes_for_equal_questions) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.png", "b.png"})
    EXPECT_EQ(shot(asset("torus.off"), folder.at(name), {"--panels", "--lang", "ja"}), 0);
  EXPECT_TRUE(test::read_file(folder.at("a.png")) == test::read_file(folder.at("b.png")));
}

TEST(shot, every_flag_changes_the_picture) {
  const test::TemporaryFolder folder;
  const std::string mesh = asset("fin.obj"), script = folder.write("s.txt", "split 0-1@f0 0.3\n");
  ASSERT_EQ(shot(mesh, folder.at("plain.png"), {}), 0);
  const std::string plain = test::read_file(folder.at("plain.png"));
  const std::vector<std::vector<std::string>> changes{
      {"--view", "top"},      {"--camera", R"({"eye":[1,1,3],"target":[0,0,0],"up":[0,1,0]})"},
      {"--show", "none"},     {"--select", "f0"},
      {"--hover", "173,130"}, {"--script", script},
      {"--panels"},           {"--transparent"},
      {"--supersample", "2"}, {"--theme", "light"},
  };
  for (const std::vector<std::string>& flags : changes) {
    EXPECT_EQ(shot(mesh, folder.at("other.png"), flags), 0) << flags[0];
    EXPECT_TRUE(test::read_file(folder.at("other.png")) != plain) << flags[0];
  }
}

// Pictures are PNG files: no other name is written to, by a flag or by a line of a script.
TEST(shot, refuses_names_that_end_in_another_format) {
  const test::TemporaryFolder folder;
  const std::string right = folder.at("right.png");
  ASSERT_EQ(shot(asset("fin.obj"), right, {}), 0);
  for (const char* const name : {"x.jpg", "x.JPG", "x.svg", "x.webp", "x.tiff", "x.off"}) {
    const std::string file = folder.at(name);
    const auto expect_refused = [&](const std::vector<std::string>& line) {
      const test::ProgramRun run = run_program(line);
      EXPECT_EQ(run.exit_code, 2) << line.back() << run.err;
      EXPECT_NE(run.err.find(".png"), std::string::npos) << run.err;
      EXPECT_FALSE(std::filesystem::exists(file)) << line.back();
    };
    expect_refused({"shot", asset("fin.obj"), "--size", "32x32", "-o", file});
    expect_refused({"shot", asset("fin.obj"), "--size", "32x32", "--overwrite", "-o", file});
    expect_refused({"shot", asset("cube.obj"), "--size", "320x240", "--compare", right, "--diff", file});
    const std::string script = folder.write("s.txt", "shot " + file + "\n");
    expect_refused({"shot", asset("fin.obj"), "--size", "32x32", "-o", folder.at("o.png"), "--script", script});
    expect_refused({"edit", asset("fin.obj"), "--do", "shot " + file});
  }
  EXPECT_EQ(shot(asset("fin.obj"), folder.at("UPPER.PNG"), {}), 0);
  EXPECT_EQ(shot(asset("fin.obj"), folder.at("no_extension"), {}), 0);
}

// A cube of side 2 s around the origin.
std::string cube_of(const std::string& s) {
  std::string text;
  for (const char* signs : {"---", "+--", "++-", "-+-", "--+", "+-+", "+++", "-++"}) {
    text += "v";
    for (int i = 0; i < 3; ++i) text += std::string(signs[i] == '-' ? " -" : " ") + s;
    text += "\n";
  }
  return text + "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

TEST(shot, a_mesh_looks_the_same_however_large_or_small_it_is) {
  const test::TemporaryFolder folder;
  const std::string one = folder.write("one.obj", cube_of("1")), reference = folder.at("one.png");
  for (const std::vector<std::string>& flags :
       {std::vector<std::string>{}, {"--view", "iso"}, {"--script", folder.write("s", "projection orthographic\n")}}) {
    ASSERT_EQ(shot(one, reference, flags), 0);
    const std::vector<const char*> few{"1e-300", "1e307"}, many{"1e300", "1e-300", "1e200", "1e-200", "1e307"};
    for (const char* size : test::is_long_run() ? many : few) {
      std::vector<std::string> further{"--compare", reference};
      further.insert(further.end(), flags.begin(), flags.end());
      EXPECT_EQ(shot(folder.write("other.obj", cube_of(size)), folder.at("other.png"), further), 0) << size;
    }
  }
}

TEST(shot, a_mesh_as_large_as_numbers_go_is_seen) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(shot(folder.write("none.obj", "v 0 0 0\n"), folder.at("none.png"), {"--show", "none"}), 0);
  const Result<Image> none = read_png(folder.at("none.png"));
  for (const char* size : {"1e308", "1.797e308"}) {
    ASSERT_EQ(shot(folder.write("large.obj", cube_of(size)), folder.at("large.png"), {"--show", "none"}), 0);
    const Result<Image> large = read_png(folder.at("large.png"));
    ASSERT_TRUE(none && large);
    EXPECT_GT(compare(*none, *large)->share, 0.2) << size;
  }
}

TEST(shot, ends_as_the_contract_says) {
  const test::TemporaryFolder folder;
  const std::string mesh = asset("tetrahedron.off"), out = folder.at("o.png");
  EXPECT_EQ(run_program({"shot", mesh}).exit_code, 2);
  EXPECT_EQ(shot(mesh, out, {"--size", "0x7"}), 2);
  EXPECT_EQ(shot(mesh, out, {"--view", "sideways"}), 2);
  EXPECT_EQ(shot(mesh, out, {"--show", "bondary"}), 2);
  EXPECT_EQ(shot(mesh, out, {"--tool", "colapse"}), 2);
  EXPECT_EQ(shot(mesh, out, {"--select", "v99"}), 2);
  EXPECT_EQ(shot(mesh, out, {"--hover", "left"}), 2);
  EXPECT_FALSE(folder.has("o.png"));
  EXPECT_EQ(shot(asset("nosuch.obj"), out, {}), 3);
  EXPECT_EQ(shot(asset("obj_16_text_coord.obj"), out, {}), 4);
  EXPECT_EQ(shot(mesh, folder.at("no/folder/o.png"), {}), 5);
  EXPECT_EQ(shot(folder.copy(mesh, "m.off"), folder.at("m.off"), {}), 5);
  EXPECT_FALSE(folder.has("o.png"));
}

TEST(shot, names_its_output_only_where_it_is_there) {
  const test::TemporaryFolder folder;
  const std::string mesh = asset("tetrahedron.off"), there = folder.at("o.png"), nowhere = folder.at("no/o.png");
  EXPECT_EQ(run_program({"shot", mesh, "-o", there, "--size", "64x64", "--json"}).line()["output"], there);
  const test::ProgramRun run = run_program({"shot", mesh, "-o", nowhere, "--size", "64x64", "--json"});
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_TRUE(run.line()["output"].is_null());
  EXPECT_NE(run.err.find("no such folder"), std::string::npos) << run.err;
}

TEST(shot, makes_the_picture_of_a_refused_click) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> click{"shot", asset("tetrahedron.off"), "--size", "480x360", "--view",          "iso",
                                       "-o",   folder.at("a.png"),       "--json", "--click", "240,338,collapse"};
  const test::ProgramRun run = run_program(click);
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_TRUE(folder.has("a.png"));
  EXPECT_EQ(run.line()["messages"][0]["code"], "refused");
}

TEST(shot, clicks_before_the_picture_is_taken) {
  const test::TemporaryFolder folder;
  const std::string mesh = asset("torus.off");
  EXPECT_EQ(run_program({"shot", mesh, "-o", folder.at("after.png"), "--size", "640x480", "--click", "322,393,split"})
                .exit_code,
            0);
  EXPECT_EQ(run_program({"shot", mesh, "-o", folder.at("same.png"), "--size", "640x480"}).exit_code, 0);
  EXPECT_TRUE(test::read_file(folder.at("after.png")) != test::read_file(folder.at("same.png")));
}

TEST(shot, the_editor_names_it_where_there_is_no_display) {
  const test::ProgramRun run = run_program({asset("cube.obj")});
  EXPECT_EQ(run.exit_code, 7);
  EXPECT_NE(run.err.find("ryosen shot"), std::string::npos);
  EXPECT_EQ(run_program({"view", asset("nosuch.obj")}).exit_code, 3);
}

TEST(shot, cuts_across_the_camera_that_is_asked_for) {
  const test::TemporaryFolder folder;
  const std::string mesh = asset("cube.obj"), script = folder.write("s.txt", "view left\nclip view\n");
  ASSERT_EQ(shot(mesh, folder.at("flags.png"), {"--view", "left", "--clip", "view"}), 0);
  ASSERT_EQ(shot(mesh, folder.at("script.png"), {"--script", script}), 0);
  EXPECT_EQ(test::read_file(folder.at("flags.png")), test::read_file(folder.at("script.png")));
}

}  // namespace
}  // namespace ryosen
