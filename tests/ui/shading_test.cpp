// Smooth shading of a session: it looks round, and follows edits.
#include <gtest/gtest.h>

#include <set>

#include "app/ui/headless.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class ShadingTest : public testing::Test {
 protected:
  ShadingTest() {
    auto document = Document::open(test::asset("ball.off"));
    session_.set_document(std::move(document).value());
    headless_ = Headless::make({.backend = Backend::osmesa, .size = {320, 240}}).value();
    headless_->place_view(session_);
  }
  Image picture(const char* line) {
    EXPECT_TRUE(session_.run(line).done()) << line;
    return headless_->picture(session_);
  }

  Session session_{std::make_unique<Document>()};
  std::unique_ptr<Headless> headless_;
};

// How many colours there are amid the picture, where the ball is.
std::size_t colours(const Image& picture) {
  std::set<Rgba> all;
  for (int y = 70; y < 170; ++y)
    for (int x = 110; x < 210; ++x) all.insert(picture.at(x, y));
  return all.size();
}

TEST_F(ShadingTest, goes_over_from_face_to_face_or_is_one_light_for_each) {
  const Image flat = picture("shading flat"), smooth = picture("shading smooth");
  EXPECT_GT(colours(smooth), colours(flat) + 300);
  EXPECT_TRUE(picture("key Shift+W") == flat);
  EXPECT_TRUE(picture("key Shift+W") == smooth);
}

TEST_F(ShadingTest, follows_edits_undo_and_what_is_edited_while_it_is_flat) {
  const Image smooth = picture("shading smooth");
  const auto is_as_drawn_anew = [&](const Image& followed) {
    headless_->forget();
    return followed == headless_->picture(session_);
  };
  const Image moved = picture("move_vertex v46 0.3,0.3,0.6");
  EXPECT_FALSE(moved == smooth);
  EXPECT_TRUE(is_as_drawn_anew(moved));
  EXPECT_TRUE(picture("undo") == smooth);
  // What is edited while it is flat, drawn meanwhile or not.
  picture("shading flat");
  picture("redo");
  EXPECT_TRUE(picture("shading smooth") == moved);
  EXPECT_TRUE(session_.run("shading flat").done() && session_.run("undo").done());
  EXPECT_TRUE(picture("shading smooth") == smooth);
}

}  // namespace
}  // namespace ryosen
