// A highlight is one row: one that this program adds is found, counted, drawn, listed and switched as all others are.
#include <gtest/gtest.h>

#include <cmath>

#include "app/cli/run.h"
#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

// The edges at vertex 0 and the face f0, which it tints.
class ScopedHighlightTest : public testing::Test {
 protected:
  const ScopedHighlight added_{{.id = "first",
                                .name_en = "First elements",
                                .name_ja = "最初の要素",
                                .legend_en = "The first face and the edges at the first vertex.",
                                .legend_ja = "最初の面と、最初の頂点の稜線。",
                                .edge =
                                    [](Neighbourhood& around, Edge e) {
                                      const auto [a, b] = ends(around.mesh(), e);
                                      return a == Vertex(0) || b == Vertex(0);
                                    },
                                .face = [](Neighbourhood&, Face f) { return f == Face(0); },
                                .looks = {0x10F0E0, 0x107060, LineStyle::solid, 5, PointShape::square, 6},
                                .tint = FaceTint{FacePattern::plain, 1}}};
  const HighlightRow& row_ = *find_highlight("first");
};

int count_near(const Image& picture, std::uint32_t colour, int tolerance = 6) {
  const Rgba wanted = rgb(colour);
  int n = 0;
  for (const Rgba& pixel : picture.pixels) {
    bool is_near = true;
    for (std::size_t c = 0; c < 3; ++c) is_near = is_near && std::abs(int{pixel[c]} - int{wanted[c]}) <= tolerance;
    n += is_near;
  }
  return n;
}

std::unique_ptr<Session> open_session(const std::string& name) {
  auto document = Document::open(test::asset(name));
  return document ? std::make_unique<Session>(std::move(document).value()) : nullptr;
}

TEST_F(ScopedHighlightTest, is_found_and_counted_when_it_is_shown) {
  const auto session = open_session("cube.obj");
  EXPECT_FALSE(session->view.highlights.contains("first"));
  EXPECT_FALSE(session->findings().highlights().keeps(row_));
  ASSERT_TRUE(session->run("show first").done());
  EXPECT_EQ(session->findings().highlights().count(row_), 4u) << "three edges and a face";
  ASSERT_TRUE(session->run("poke f0").done());
  EXPECT_EQ(session->findings().highlights().count(row_), 5u) << "one edge more";
  ASSERT_TRUE(session->run("show first off").done());
  EXPECT_NE(session->run("show frist").sentence.en.find("did you mean first"), std::string::npos);
  ASSERT_TRUE(session->run("show all").done());
  EXPECT_TRUE(session->view.highlights.contains("first"));
}

TEST_F(ScopedHighlightTest, is_drawn_in_its_colour_and_tints_its_face) {
  auto headless = Headless::make({.backend = Backend::osmesa, .size = {320, 240}});
  ASSERT_TRUE(headless);
  const auto session = open_session("cube.obj");
  (*headless)->place_view(*session);
  ASSERT_TRUE(session->run("view iso").done());
  const Image without = (*headless)->picture(*session);
  EXPECT_EQ(count_near(without, row_.looks.dark), 0);
  ASSERT_TRUE(session->run("show first").done());
  EXPECT_GT(count_near((*headless)->picture(*session), row_.looks.dark), 100);
  ASSERT_TRUE(session->run("theme light").done());
  EXPECT_GT(count_near((*headless)->picture(*session), row_.looks.light), 100);
  ASSERT_TRUE(session->run("theme dark").done());
  ASSERT_TRUE(session->run("show first off").done());
  EXPECT_EQ((*headless)->picture(*session), without);

  // The face alone: seen from where it lies, more greenish than red.
  const auto greenish = [](const Image& picture) {
    int n = 0;
    for (const Rgba& pixel : picture.pixels) n += int{pixel[1]} > int{pixel[0]} + 60;
    return n;
  };
  int most = 0;
  for (const char* view : {"view front", "view back", "view left", "view right", "view top", "view bottom"}) {
    ASSERT_TRUE(session->run("show first off").done());
    ASSERT_TRUE(session->run(view).done());
    EXPECT_EQ(greenish((*headless)->picture(*session)), 0);
    ASSERT_TRUE(session->run("show first on").done());
    most = std::max(most, greenish((*headless)->picture(*session)));
  }
  EXPECT_GT(most, 15000) << "a face that fills the picture";
}

TEST_F(ScopedHighlightTest, may_mark_a_kind_of_problem_that_another_marks_too) {
  const ScopedHighlight rim({.id = "rim",
                             .name_en = "Rim",
                             .name_ja = "縁",
                             .legend_en = "The boundary once more.",
                             .legend_ja = "もう一つの境界。",
                             .kinds = {ProblemKind::boundary_loop},
                             .looks = {0xF010C0, 0xF010C0, LineStyle::solid, 9, PointShape::disc, 4}});
  const Looks rim_looks = find_highlight("rim")->looks, boundary = find_highlight("boundary")->looks;
  auto headless = Headless::make({.backend = Backend::osmesa, .size = {320, 240}});
  ASSERT_TRUE(headless);
  const auto session = open_session("two_quads.obj");
  (*headless)->place_view(*session);
  const auto seen = [&](const char* line, const Looks& looks) {
    EXPECT_TRUE(session->run(line).done());
    return count_near((*headless)->picture(*session), looks.dark) > 100;
  };
  EXPECT_TRUE(seen("show boundary", boundary));
  EXPECT_TRUE(seen("show rim", boundary)) << "the first of the table lies on top";
  EXPECT_TRUE(seen("show rim", rim_looks)) << "and the wider one beneath is seen beside it";
  EXPECT_FALSE(seen("show boundary off", boundary));
  EXPECT_TRUE(seen("show rim", rim_looks));
  EXPECT_EQ(session->findings().highlights().count(*find_highlight("rim")), 6u);
}

TEST_F(ScopedHighlightTest, has_a_row_in_the_panel_that_switches_it) {
  constexpr Size high{1280, 1000};  // where the panel leaves no row out
  test::Laid laid("cube.obj", high);
  const auto press = [&] { laid.click({16, test::DrawnText(laid.gui).place(row_.name_en).y}); };
  press();
  EXPECT_TRUE(laid.session.view.highlights.contains("first"));
  press();
  EXPECT_FALSE(laid.session.view.highlights.contains("first"));

  auto headless = Headless::make({.backend = Backend::osmesa, .size = high, .panels = true});
  ASSERT_TRUE(headless);
  const auto session = open_session("cube.obj");
  (*headless)->place_view(*session);
  EXPECT_GT(count_near((*headless)->picture(*session), row_.looks.dark, 0), 50) << "its line in the panel";
}

TEST_F(ScopedHighlightTest, is_known_to_shot_and_its_help) {
  const test::TemporaryFolder folder;
  const auto shot = [&](const std::string& id) {
    return cli::run({"shot", test::asset("cube.obj"), "-o", folder.at("a.png"), "--size", "320x240", "--view", "iso",
                     "--show", id, "--backend", "osmesa"});
  };
  EXPECT_EQ(shot("first"), ExitCode::done);
  const Result<Image> picture = read_png(folder.at("a.png"));
  ASSERT_TRUE(picture);
  EXPECT_GT(count_near(*picture, row_.looks.dark), 100);
  EXPECT_EQ(shot("frist"), ExitCode::usage);
  const std::string help = test::run_here({"help", "shot", "--lang", "en"}).out;
  for (const HighlightRow& row : highlight_table()) {
    EXPECT_NE(help.find("  " + std::string(row.id)), std::string::npos) << row.id;
    EXPECT_NE(help.find(row.legend_en), std::string::npos) << row.id;
  }
}

}  // namespace
}  // namespace ryosen
