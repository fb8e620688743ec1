// The edges of faces in the picture of a session: there, or not.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

// Three faces of a cube.
TEST(wire, goes_with_its_key_and_comes_back) {
  Session session(Document::open(test::asset("cube.obj")).value());
  const auto headless = Headless::make({.backend = Backend::osmesa, .size = {320, 240}}).value();
  headless->place_view(session);
  const auto picture = [&](const char* line) {
    EXPECT_TRUE(session.run(line).done()) << line;
    return headless->picture(session);
  };
  const auto colours_amid = [](const Image& image) {
    std::set<Rgba> all;
    for (int y = 90; y < 150; ++y)
      for (int x = 130; x < 190; ++x) all.insert(image.at(x, y));
    return all.size();
  };
  const Image with = picture("view iso"), without = picture("key W");
  EXPECT_GT(colours_amid(with), 20u);
  EXPECT_LE(colours_amid(without), 6u) << "one for each triangle";
  EXPECT_TRUE(picture("wire on") == with);
  EXPECT_TRUE(picture("wire toggle") == without);
  headless->forget();
  EXPECT_TRUE(picture("wire off") == without);
}

// A sheet of squares, n x n, of side 1, in two triangles each; in the middle one that is three times as large where
// asked for, raised at x = 0 and x = n by so much where bent.
std::string sheet(int n, bool has_large) {
  std::string text;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
  const auto corner = [&](int x, int y) { return " " + std::to_string(y * (n + 1) + x + 1); };
  const int low = n / 2 - 1, high = n / 2 + 2;
  const auto patch = [&](int x, int y, int side) {
    text += "f" + corner(x, y) + corner(x + side, y) + corner(x + side, y + side) + "\n";
    text += "f" + corner(x, y) + corner(x + side, y + side) + corner(x, y + side) + "\n";
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      if (!has_large || x < low || x >= high || y < low || y >= high) patch(x, y, 1);
  if (has_large) patch(low, low, 3);
  return text;
}

class WireTest : public testing::Test {
 protected:
  void open(const std::string& text) {
    session_ = std::make_unique<Session>(Document::open(folder_.write("sheet.obj", text)).value());
    headless_ = Headless::make({.backend = Backend::osmesa, .size = {320, 240}}).value();
    headless_->place_view(*session_);
    session_->run("show all off");
  }
  Image picture(const std::string& line) {
    EXPECT_TRUE(session_->run(line).done()) << line;
    return headless_->picture(*session_);
  }
  // How much the wire darkens, in a part of the picture: the mean and the most.
  struct Darkening {
    double mean = 0;
    int most = 0;
  };
  Darkening darkening(const PixelRect& part) {
    const Image with = picture("wire on"), without = picture("wire off");
    Darkening found;
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x) {
        const int by = without.at(x, y)[1] - with.at(x, y)[1];
        found.mean += double(by) / (part.width() * part.height());
        found.most = std::max(found.most, by);
      }
    return found;
  }

  const test::TemporaryFolder folder_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Headless> headless_;
};

// Squares of 4 pixels, of which the wire leaves little, and one of 12 amid them.
TEST_F(WireTest, leaves_no_scratches_at_single_larger_triangles) {
  open(sheet(60, true));
  picture(R"(camera {"eye":[30,30,100],"target":[30,30,0],"up":[0,1,0],"ortho_height":60})");
  const Darkening at_large = darkening({140, 100, 180, 140}), elsewhere = darkening({60, 100, 100, 140});
  EXPECT_GT(elsewhere.most, 4);
  EXPECT_LE(at_large.most, elsewhere.most + 1);
}

TEST_F(WireTest, stays_on_a_triangle_that_is_large_by_itself) {
  open(sheet(60, true));
  picture(R"(camera {"eye":[30.5,30.5,100],"target":[30.5,30.5,0],"up":[0,1,0],"ortho_height":6})");
  EXPECT_GT(darkening({0, 0, 320, 240}).most, 60) << "120 pixels";
}

// The same sheet from the front and almost from the side.
TEST_F(WireTest, does_not_break_where_the_surface_is_seen_from_the_side) {
  open(sheet(24, false));
  picture(R"(camera {"eye":[12,12,100],"target":[12,12,0],"up":[0,1,0],"ortho_height":24})");
  const Darkening front = darkening({130, 90, 190, 150});
  picture(R"(camera {"eye":[12,-87,12],"target":[12,12,0],"up":[0,0,1],"ortho_height":24})");
  const Darkening side = darkening({130, 112, 190, 128});
  EXPECT_GT(front.mean, 4);
  EXPECT_GE(side.mean, front.mean) << "where there are more edges to a pixel";
}

// A few triangles of about the size at which it fades, so that an edit changes how much of it there is.
TEST_F(WireTest, follows_edits_that_change_how_large_triangles_are) {
  open(sheet(4, false));
  picture(R"(camera {"eye":[2,2,100],"target":[2,2,0],"up":[0,1,0],"ortho_height":160})");
  const Image before = headless_->picture(*session_);
  for (const char* const line : {"move_vertex v12 2.2,2.2,0.3", "mode vertex", "select v0..v24",
                                 "scale factor=3 elements=selected", "collapse 6-7", "undo", "undo"}) {
    const bool is_done = session_->run(line).done();
    const Image followed = headless_->picture(*session_);
    EXPECT_TRUE(followed == headless_->view_drawn_again()) << line << (is_done ? "" : " was refused");
  }
}

}  // namespace
}  // namespace ryosen
