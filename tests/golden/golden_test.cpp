// Pictures of the program held against those that were looked at and found good. RYOSEN_UPDATE_GOLDEN=1 writes them
// anew; look at each before committing it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/palette.h"
#include "ryosen/scene/highlights/highlight_table.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

// What is drawn: because of the pointer, or as a highlight, which its id names.
struct DrawnColour {
  DrawnColour(Role drawn_role) : role(drawn_role) {}
  DrawnColour(const char* highlight) : row(find_highlight(highlight)), role(Role::hover) {}
  Rgba colour(Theme theme) const { return row ? style(row->looks, theme).colour : style(role, theme).colour; }

  std::string name() const { return row ? std::string(row->id) : "role " + std::to_string(static_cast<int>(role)); }

  const HighlightRow* row = nullptr;
  Role role;
};

// What must be seen: at least this many pixels about as that is coloured.
struct Seen {
  DrawnColour drawn;
  int least;
};

struct Golden {
  std::string name, mesh;
  std::vector<std::string> flags;
  std::vector<Seen> seen = {};
  std::vector<DrawnColour> unseen = {};
  Theme theme = Theme::dark;

  friend void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.name; }
};

const std::string small = "480x360";
const std::string close_to_the_eye =
    R"({"eye":[-0.045,0.155,0.072],"target":[-0.064,0.142,0.03],"up":[0,1,0],"fov_y_deg":35})";

const std::vector<Golden> goldens{
    {"bunny", "stanford_bunny.obj", {"--size", small}, {}, {"nonmanifold", "degenerate"}},
    {"bunny_10000",
     "stanford_bunny.obj",
     {"--size", "640x480", "--show", "none", "--script", RYOSEN_SOURCE_DIR "/tests/golden/bunny_10000.ryosen"}},
    {"bunny_1000",
     "stanford_bunny.obj",
     {"--size", "640x480", "--show", "none", "--script", RYOSEN_SOURCE_DIR "/tests/golden/bunny_1000.ryosen"}},
    {"edge_account",
     "stanford_bunny.obj",
     {"--panels", "--show", "none", "--script", RYOSEN_SOURCE_DIR "/tests/golden/account.ryosen"}},
    {"levels",
     "stanford_bunny.obj",
     {"--panels", "--lang", "ja", "--theme", "light", "--script", RYOSEN_SOURCE_DIR "/tests/golden/levels.ryosen"},
     {},
     {},
     Theme::light},
    {"bunny_boundary", "stanford_bunny.obj", {"--size", small, "--view", "bottom"}, {{"boundary", 400}}},
    {"bunny_legal",
     "stanford_bunny.obj",
     {"--size", small, "--camera", close_to_the_eye, "--tool", "collapse", "--hover", "247,180"},
     {{Role::legal, 30}, {Role::ghost, 15}},
     {Role::refused}},
    {"bunny_selected",
     "stanford_bunny.obj",
     {"--size", small, "--camera", close_to_the_eye, "--click", "247,180", "--hover", "225,150"},
     {{Role::selected, 30}, {Role::hover, 30}},
     {Role::legal, Role::refused}},
    {"boundary", "two_quads.obj", {"--size", small, "--show", "boundary"}, {{"boundary", 1000}}},
    {"nonmanifold_edge", "fin.obj", {"--size", small, "--show", "nonmanifold"}, {{"nonmanifold", 200}}, {"boundary"}},
    {"nonmanifold_vertex",
     "bow_tie.obj",
     {"--size", small, "--show", "nonmanifold"},
     {{"nonmanifold", 40}},
     {"boundary"}},
    {"misoriented", "misoriented.obj", {"--size", small, "--show", "misoriented"}, {{"misoriented", 200}}},
    {"degenerate", "collinear.obj", {"--size", small, "--show", "degenerate"}, {{"degenerate", 250}}},
    {"duplicate", "duplicate_face.obj", {"--size", small, "--show", "duplicate"}, {{"duplicate", 500}}},
    {"hanging", "hanging_pair.obj", {"--size", small, "--show", "hanging"}, {{"hanging", 150}}},
    {"isolated", "isolated_vertex.obj", {"--size", small, "--show", "isolated"}, {{"isolated", 20}}},
    {"wires",
     "two_quads.obj",
     {"--size", small, "--show", "wires,isolated", "--script", RYOSEN_SOURCE_DIR "/tests/golden/wires.ryosen"},
     {{"wires", 150}, {"isolated", 20}}},
    {"creases",
     "cube.obj",
     {"--size", small, "--view", "iso", "--show", "creases", "--script",
      RYOSEN_SOURCE_DIR "/tests/golden/creases.ryosen"},
     {{"creases", 400}}},
    {"seams",
     "seam.obj",
     {"--size", small, "--view", "iso", "--theme", "light", "--show", "seams,boundary"},
     {{"seams", 100}, {"boundary", 500}},
     {"creases"},
     Theme::light},
    {"nothing_shown", "fin.obj", {"--size", small, "--show", "none"}, {}, {"boundary", "nonmanifold", "degenerate"}},
    {"ball_flat", "ball.off", {"--size", small}},
    {"ball_smooth", "ball.off", {"--size", small, "--shading", "smooth"}},
    {"links_fan",
     "fan.obj",
     {"--size", "640x480", "--view", "front", "--links", "all", "--numbers", "all", "--select", "h0", "--show",
      "none"}},
    {"links_hexagon",
     "figures/003-image43.obj",
     {"--size", "640x480", "--theme", "light", "--view", "front", "--links", "all", "--numbers", "corners", "--show",
      "none"},
     {},
     {},
     Theme::light},
    {"links_holed_cube",
     "figures/000-4b.obj",
     {"--size", "640x480", "--view", "iso", "--links", "all", "--numbers", "all", "--select", "f9", "--show", "none"}},
    {"bunny_curvature",
     "stanford_bunny.obj",
     {"--size", small, "--wire", "off", "--show", "none", "--script",
      RYOSEN_SOURCE_DIR "/tests/golden/curvature.ryosen"}},
    {"bunny_remeshed",
     "stanford_bunny.obj",
     {"--size", small, "--show", "none", "--script", RYOSEN_SOURCE_DIR "/tests/golden/remeshed.ryosen"}},
    {"dragon_remeshed",
     "stanford_dragon_20000.ply.gz",
     {"--size", small, "--show", "none", "--script", RYOSEN_SOURCE_DIR "/tests/golden/remeshed_dragon.ryosen"}},
    {"limit",
     "cube.obj",
     {"--size", small, "--view", "iso", "--shading", "smooth", "--script",
      RYOSEN_SOURCE_DIR "/tests/golden/limit.ryosen"}},
    {"limit_creases",
     "tetrahedron.off",
     {"--size", small, "--view", "iso", "--shading", "smooth", "--script",
      RYOSEN_SOURCE_DIR "/tests/golden/limit_creases.ryosen"}},
    {"split_legal",
     "torus.off",
     {"--size", "640x480", "--theme", "light", "--tool", "split", "--hover", "322,393"},
     {{Role::legal, 300}},
     {Role::refused},
     Theme::light},
    {"collapse_refused",
     "tetrahedron.off",
     {"--size", small, "--view", "iso", "--tool", "collapse", "--hover", "240,338"},
     {{Role::refused, 300}},
     {Role::legal, Role::ghost}},
    {"boundary_refused",
     "two_quads.obj",
     {"--size", small, "--theme", "light", "--tool", "swap", "--hover", "320,282"},
     {{Role::refused, 300}},
     {Role::legal},
     Theme::light},
    {"verdicts",
     "moebius.off",
     {"--size", small, "--tool", "swap", "--verdicts", "on"},
     {{Role::legal, 200}, {Role::refused, 200}}},
    {"panels_english",
     "torus.off",
     {"--panels", "--tool", "split", "--hover", "609,560"},
     {{Role::legal, 300}, {"boundary", 60}, {"nonmanifold", 20}}},
    {"panels_japanese",
     "fin.obj",
     {"--panels", "--lang", "ja", "--theme", "light", "--tool", "collapse", "--hover", "610,380"},
     {{"boundary", 1000}, {Role::refused, 300}},
     {Role::legal},
     Theme::light},
    {"panels_narrow",
     "fin.obj",
     {"--panels", "--size", "640x480", "--script", RYOSEN_SOURCE_DIR "/tests/golden/tab.ryosen"},
     {{"boundary", 500}, {"nonmanifold", 20}}},
};

int count_coloured(const Image& picture, Rgba colour) {
  int n = 0;
  for (const Rgba& pixel : picture.pixels) {
    bool is_near = true;
    for (std::size_t c = 0; c < 3; ++c) is_near = is_near && std::abs(int{pixel[c]} - int{colour[c]}) <= 10;
    n += is_near;
  }
  return n;
}

class GoldenTest : public testing::TestWithParam<Golden> {};

void expect_looks(const Golden& golden, const std::string& written) {
  const std::string reference = std::string(RYOSEN_SOURCE_DIR) + "/assets/golden/" + golden.name + ".png";
  const Result<Image> picture = read_png(written);
  ASSERT_TRUE(picture);
  for (const Seen& seen : golden.seen)
    EXPECT_GE(count_coloured(*picture, seen.drawn.colour(golden.theme)), seen.least) << seen.drawn.name();
  for (const DrawnColour& drawn : golden.unseen)
    EXPECT_EQ(count_coloured(*picture, drawn.colour(golden.theme)), 0) << drawn.name();
  if (std::getenv("RYOSEN_UPDATE_GOLDEN")) {
    ASSERT_TRUE(write_png(*picture, reference));
  }
  const Result<Image> expected = read_png(reference);
  ASSERT_TRUE(expected);
  const Result<ImageDifference> difference = compare(*expected, *picture);
  ASSERT_TRUE(difference);
  EXPECT_LE(difference->share, 0.002) << "of the pixels differ";
}

void expect_golden(const Golden& golden) {
  const test::TemporaryFolder folder;
  const std::string written = folder.at("picture.png");
  std::vector<std::string> arguments{"shot", test::asset(golden.mesh), "--backend", "osmesa", "-o", written};
  arguments.insert(arguments.end(), golden.flags.begin(), golden.flags.end());
  const test::ProgramRun run = test::run_program(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_looks(golden, written);
}

TEST_P(GoldenTest, looks_as_it_did) { expect_golden(GetParam()); }

// Its script names a file.
TEST(GoldenBeside, two_meshes_lie_beside_each_other_before_one_camera) {
  const test::TemporaryFolder folder;
  const std::string script =
      folder.write("beside.ryosen", "simplify ratio=0.02\ncompare " + test::asset("stanford_bunny.obj") +
                                        "\ncolours distance\nview front\n");
  expect_golden({"beside", "stanford_bunny.obj", {"--panels", "--show", "none", "--script", script}});
  const std::string plain = folder.write("plain.ryosen", "compare " + test::asset("torus.off") + "\n");
  expect_golden({"beside_plain", "cube.obj", {"--size", small, "--script", plain}});
}

// A step as `steps` draws it, with its caption: what comes, what a link changes at, the point.
TEST(GoldenSteps, look_as_they_did) {
  const std::vector<Golden> steps{
      {"hull_horizon", "ball.off", {"hull", "random", "3", "24"}, {{Role::legal, 3000}, {Role::hover, 1000}}},
      {"hull_coplanar", "cube.obj", {"hull", "as_given", "4"}, {{Role::legal, 3000}, {Role::hover, 1000}}},
      {"hull_plane",
       "ball.off",
       {"hull", "random", "1", "project=z", "10"},
       {{Role::legal, 1000}, {Role::hover, 1000}}},
  };
  for (const Golden& golden : steps) {
    SCOPED_TRACE(golden.name);
    const test::TemporaryFolder folder;
    const std::string written = folder.at("picture.png");
    std::vector<std::string> arguments{"steps"};
    arguments.insert(arguments.end(), golden.flags.begin(), golden.flags.end() - 1);
    arguments.insert(arguments.end(), {test::asset(golden.mesh), "--at", golden.flags.back(), "-o", written});
    const test::ProgramRun run = test::run_program(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    expect_looks(golden, written);
    EXPECT_GE(count_coloured(*read_png(written), style(Role::selected, Theme::dark).colour), 40) << "the point";
  }
}

INSTANTIATE_TEST_SUITE_P(Pictures, GoldenTest, testing::ValuesIn(goldens),
                         [](const auto& test) { return test.param.name; });

TEST(compare, tells_another_picture_from_the_reference) {
  const test::TemporaryFolder folder;
  const std::string reference = std::string(RYOSEN_SOURCE_DIR) + "/assets/golden/nonmanifold_edge.png";
  const std::string mesh = test::asset("fin.obj");
  const auto shot = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(), {"shot", mesh, "--compare", reference, "--size", "480x360"});
    return test::run_program(flags);
  };
  EXPECT_EQ(shot({"--show", "nonmanifold"}).exit_code, 0);
  const test::ProgramRun other = shot({"--show", "none", "--diff", folder.at("difference.png")});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_TRUE(folder.has("difference.png"));
  EXPECT_EQ(shot({"--show", "none", "--tolerance", "100"}).exit_code, 0);
  EXPECT_EQ(test::run_program({"shot", mesh, "--compare", reference, "--size", "300x200"}).exit_code, 1);
  EXPECT_EQ(test::run_program({"shot", mesh, "--compare", folder.at("none.png")}).exit_code, 3);
}

}  // namespace
}  // namespace ryosen
