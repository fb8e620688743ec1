// Seeing and picking through the surface.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "render/palette.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class XrayTest : public testing::Test {
 protected:
  XrayTest() {
    session_.set_document(Document::open(test::asset("torus.off")).value());
    headless_ = Headless::make({.backend = Backend::osmesa, .size = {320, 240}}).value();
    headless_->place_view(session_);
    session_.framing.frame_all();
  }
  Image picture(const std::string& line) {
    EXPECT_TRUE(session_.run(line).done()) << line;
    return headless_->picture(session_);
  }
  // How many vertices are picked where they are.
  std::size_t vertices_met() {
    std::size_t met = 0;
    for (std::uint32_t i = 0; i < session_.mesh().vertex_slots(); ++i) {
      const auto at = project(session_.view.camera, session_.view.size, session_.mesh().position(Vertex(i)));
      const auto picked = session_.pointing.pick(at->pixel + session_.view.origin, PickMode::vertex);
      met += picked && picked->element == Element(Vertex(i));
    }
    return met;
  }

  Session session_{std::make_unique<Document>()};
  std::unique_ptr<Headless> headless_;
};

TEST_F(XrayTest, goes_by_its_key_and_shows_what_is_behind) {
  const Image solid = picture("select none");
  const Image through = picture("key Z");
  EXPECT_FALSE(through == solid);
  EXPECT_TRUE(picture("key Z") == solid);
  // One vertex on the near side and one on the far side: with X-ray both are drawn in full.
  for (const char* theme : {"theme dark", "theme light"}) {
    EXPECT_TRUE(session_.run(theme).done());
    const Rgba selected = style(Role::selected, session_.view.settings.theme).colour;
    for (const char* on : {"xray on", "xray off"}) {
      int shown = 0;
      EXPECT_TRUE(session_.run(on).done());
      for (std::uint32_t i = 0; i < session_.mesh().vertex_slots(); ++i) {
        const Image image = picture("select v" + std::to_string(i));
        const auto at = project(session_.view.camera, session_.view.size, session_.mesh().position(Vertex(i)))->pixel;
        const Rgba there = image.at(static_cast<int>(at.x), static_cast<int>(at.y));
        shown += there == selected;
      }
      const auto all = static_cast<int>(session_.mesh().vertex_slots());
      if (session_.view.settings.xray == Xray::on)
        EXPECT_EQ(shown, all) << theme;
      else
        EXPECT_LT(shown, all) << theme;
    }
  }
}

// Edits put triangles behind all others, and drawing anew sorts them: the order does not matter.
TEST_F(XrayTest, is_redrawn_as_it_is_drawn_anew) {
  for (const char* theme : {"theme dark", "theme light"}) {
    picture("xray on");
    for (const std::string line : {theme,
                                   "select f3 f9",
                                   "hide f9",
                                   "poke f3",
                                   "show all",
                                   "split e5",
                                   "move_vertex v7 0.1,0.2,0.3",
                                   "unhide",
                                   "undo",
                                   "mode vertex",
                                   "select all",
                                   "isolate f1..f20",
                                   "mode edge",
                                   "wire off",
                                   "dots always",
                                   "unhide",
                                   "wire on",
                                   "dots picked",
                                   "show all off",
                                   "show boundary",
                                   "undo 2",
                                   "select none"}) {
      const Image followed = picture(line);
      headless_->forget();
      EXPECT_TRUE(followed == headless_->picture(session_)) << line;
    }
  }
}

TEST_F(XrayTest, is_picked_through) {
  const std::size_t all = session_.mesh().live().vertices, seen = vertices_met();
  EXPECT_LT(seen, all);
  EXPECT_TRUE(session_.run("xray on").done());
  EXPECT_EQ(vertices_met(), all);
  EXPECT_TRUE(session_.run("mode vertex").done());
  EXPECT_TRUE(session_.run("box 0,0 320,240").done());
  EXPECT_EQ(session_.selecting.selection.size(), all);
  EXPECT_TRUE(session_.run("xray off").done());
  EXPECT_TRUE(session_.run("box 0,0 320,240").done());
  EXPECT_LT(session_.selecting.selection.size(), all);
}

// What is nearer on the screen comes before what is nearer to the eye.
TEST_F(XrayTest, prefers_what_is_in_front_at_one_distance_on_the_screen) {
  Session cube(Document::open(test::asset("cube.obj")).value());
  cube.view.size = {320, 240};
  for (const char* line : {"view front", "projection orthographic", "xray on"}) EXPECT_TRUE(cube.run(line).done());
  for (std::uint32_t i = 0; i < 8; ++i) {
    const glm::dvec3 place = cube.mesh().position(Vertex(i));
    const auto picked = cube.pointing.pick(project(cube.view.camera, cube.view.size, place)->pixel, PickMode::vertex);
    ASSERT_TRUE(picked);
    EXPECT_GT(cube.mesh().position(picked->element.vertex()).z, 0) << i;
  }
}

}  // namespace
}  // namespace ryosen
