// What is hidden in the picture of a session: what is redrawn is what is drawn anew.
#include <gtest/gtest.h>

#include <random>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

class HidingTest : public testing::Test {
 protected:
  HidingTest() { headless_ = Headless::make({.backend = Backend::osmesa, .size = {320, 240}}).value(); }
  void open(const char* asset) {
    session_.set_document(Document::open(test::asset(asset)).value());
    headless_->place_view(session_);
    session_.framing.frame_all();
  }
  Image picture(const char* line) {
    EXPECT_TRUE(session_.run(line).done()) << line;
    return headless_->picture(session_);
  }

  Session session_{std::make_unique<Document>()};
  std::unique_ptr<Headless> headless_;
};

TEST_F(HidingTest, is_redrawn_as_it_is_drawn_anew) {
  std::size_t at = 0;
  for (const char* asset : {"torus.off", "fin.obj", "bow_tie.obj", "ball.off", "klein_bottle.off"}) {
    if (at++ % 2 == 1 && !test::is_long_run()) continue;
    open(asset);
    const Image whole = picture("show all");
    EXPECT_FALSE(picture("hide f1..f2") == whole) << asset;
    for (const char* line : {"select f0..f3", "key Shift+H", "hide v1", "unhide", "hide f0", "mode vertex",
                             "select all", "key H", "key Ctrl+H", "isolate f0..f1", "shading smooth", "shading flat",
                             "delete f0", "undo", "redo", "unhide", "undo", "select none", "mode edge"}) {
      const Image followed = picture(line);
      headless_->forget();
      EXPECT_TRUE(followed == headless_->picture(session_)) << asset << ": " << line;
    }
    EXPECT_TRUE(picture("unhide") == whole) << asset;
  }
}

TEST_F(HidingTest, is_redrawn_through_edits_as_it_is_drawn_anew) {
  std::mt19937 random(7);
  const char* const verbs[] = {"hide f", "hide v", "hide e", "isolate f", "select f", "delete f", "poke f", "split e"};
  int done = 0;
  const int steps = test::is_long_run() ? 60 : 25;
  for (const char* asset : {"three_tri_edge.off", "bow_tie.obj", "torus.off", "fan.obj"}) {
    open(asset);
    EXPECT_TRUE(session_.run("show all").done());
    for (int step = 0; step < steps; ++step) {
      const std::string other = random() % 3 == 0 ? "unhide" : random() % 2 == 0 ? "undo" : "redo";
      const std::string number = std::to_string(random() % session_.mesh().face_slots());
      const std::string line = random() % 4 == 0 ? other : verbs[random() % std::size(verbs)] + number;
      done += session_.run(line).done();
      const Image followed = headless_->picture(session_);
      headless_->forget();
      ASSERT_TRUE(followed == headless_->picture(session_)) << asset << " step " << step << ": " << line;
    }
  }
  EXPECT_GT(done, 2 * steps - 20);
}

TEST_F(HidingTest, leaves_nothing_of_what_is_hidden) {
  open("cube.obj");
  EXPECT_TRUE(session_.run("show all").done());
  const Image nothing = picture("hide f0..f99");
  for (const Rgba& pixel : nothing.pixels) EXPECT_LT(pixel[0], 70) << "only the ground";
}

TEST(hidden_note, shows_all_again_when_it_is_pressed) {
  test::Laid laid("torus.off");
  EXPECT_TRUE(laid.session.run("hide f0 f1").done());
  laid.frames(3);
  const Session& session = laid.session;
  const double y = session.view.origin.y + session.view.size.height - 28;
  for (double x = session.view.origin.x + 20; x < session.view.origin.x + 420 && !session.findings().hidden().empty();
       x += 20)
    laid.click({x, y});
  EXPECT_TRUE(session.findings().hidden().empty());
}

}  // namespace
}  // namespace ryosen
