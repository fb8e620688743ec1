// Smooth shading of a session: it looks round, and follows edits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class ShadingTest : public testing::Test {
 protected:
  ShadingTest() {
    headless_ = Headless::make({.backend = Backend::osmesa, .size = {320, 240}, .transparent = true}).value();
    open(test::asset("ball.off"));
  }
  void open(const std::string& file) {
    auto document = Document::open(file);
    session_.set_document(std::move(document).value());
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

// The colours of pixels that the surface covers whole.
std::set<Rgba> surface_colours(const Image& picture) {
  std::set<Rgba> all;
  for (const Rgba& pixel : picture.pixels)
    if (pixel[3] == 255) all.insert(pixel);
  return all;
}

TEST_F(ShadingTest, gives_a_planar_polygon_one_tone) {
  test::TemporaryFolder folder;
  open(folder.write("comb.obj",
                    "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 3 3 0\nv 3 1 0\nv 2.5 1 0\nv 2.5 2.5 0\nv 1.5 2.5 0\nv 1.5 1 0\n"
                    "v 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n"));
  for (const char* const line :
       {"wire off", "show boundary off",
        R"(camera {"eye":[5,-1,0.8],"target":[2,1.5,0],"up":[0,0,1],"fov_y_deg":60,"ortho_height":null})"})
    ASSERT_TRUE(session_.run(line).done()) << line;
  EXPECT_EQ(surface_colours(picture("theme dark")).size(), 1u);
  EXPECT_EQ(surface_colours(picture("theme light")).size(), 1u);
}

constexpr const char* coloured_square =
    "COFF\n5 2 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n1 1 0 255 0 0 255\n0 1 0 255 0 0 255\n2 0 0 255 0 0 255\n"
    "4 0 1 2 3 0 0 255\n3 1 4 2\n";

bool is_mostly(const std::set<Rgba>& colours, std::size_t channel) {
  return std::all_of(colours.begin(), colours.end(), [&](const Rgba& colour) {
    return colour[channel] > 2 * colour[(channel + 1) % 3] && colour[channel] > 2 * colour[(channel + 2) % 3];
  });
}

TEST_F(ShadingTest, shows_the_colours_of_the_file) {
  test::TemporaryFolder folder;
  open(folder.write("square.off", coloured_square));
  for (const char* const line : {"wire off", "show boundary off", "view front"})
    ASSERT_TRUE(session_.run(line).done()) << line;
  EXPECT_TRUE(is_mostly(surface_colours(picture("file_colours vertices")), 0));
  const std::set<Rgba> of_faces = surface_colours(picture("file_colours faces"));
  EXPECT_EQ(of_faces.size(), 2u);  // a blue one, and one without a colour
  const std::set<Rgba> both = surface_colours(picture("file_colours on"));
  EXPECT_EQ(both.size(), 2u);  // the blue one, and the other in the red of its corners
  EXPECT_FALSE(is_mostly(both, 0) || is_mostly(both, 2));
  const std::set<Rgba> bare = surface_colours(picture("file_colours off"));
  EXPECT_EQ(bare.size(), 1u);
  EXPECT_FALSE(is_mostly(bare, 0) || is_mostly(bare, 2));
  const Image seen_through = picture("xray on");
  EXPECT_FALSE(picture("file_colours on") == seen_through) << "also where one sees through";
}

TEST_F(ShadingTest, takes_the_normals_of_the_file_until_an_edit_reaches_them) {
  test::TemporaryFolder folder;
  const std::string places = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  open(folder.write("plain.obj", places + "f 1 2 3 4\n"));
  const auto picture_of_square = [&](const char* line) {
    for (const char* const before : {"wire off", "show boundary off", "view front", "shading smooth"})
      EXPECT_TRUE(session_.run(before).done()) << before;
    return picture(line);
  };
  const Image plain = picture_of_square("frame all");
  open(folder.write("leaning.obj", places + "vn 0.8 0 0.6\nf 1//1 2//1 3//1 4//1\n"));
  const Image leaning = picture_of_square("frame all");
  EXPECT_FALSE(leaning == plain);
  ASSERT_TRUE(session_.run("move_vertex v0 0.1,0.1,0").done());
  EXPECT_TRUE(picture_of_square("undo") == plain) << "the surface that is there, not what was said of another one";
}

TEST_F(ShadingTest, keeps_edges_sharp_above_an_angle_that_can_be_set) {
  const Image smooth = picture("shading smooth");
  const Image sharp = picture("prefer crease_angle 1");
  EXPECT_LT(colours(sharp), colours(smooth) / 2);
  EXPECT_TRUE(picture("prefer crease_angle initial") == smooth);
  for (const char* const wrong : {"prefer crease_angle -1", "prefer crease_angle 181", "prefer crease_angle x"})
    EXPECT_FALSE(session_.run(wrong).done()) << wrong;
}

TEST_F(ShadingTest, draws_normals_as_lines_that_follow_edits) {
  const auto is_as_drawn_anew = [&](const Image& followed) { return followed == headless_->view_drawn_again(); };
  const Image bare = picture("normals off");
  for (const char* const which : {"normals vertices", "normals faces"}) {
    const Image lines = picture(which);
    EXPECT_FALSE(lines == bare) << which;
    for (const char* const line : {"move_vertex v46 0.3,0.3,0.9", "collapse 46-47", "hide f20..f40", "undo", "undo",
                                   "unhide", "theme light", "theme dark"}) {
      EXPECT_TRUE(is_as_drawn_anew(picture(line))) << which << ", " << line;
    }
    EXPECT_TRUE(picture(which) == lines) << which;
  }
  EXPECT_TRUE(picture("normals off") == bare);
}

// Two triangles back to back in one place: from wherever they are seen one shows its front.
TEST_F(ShadingTest, shows_the_front_where_a_front_and_a_back_lie_in_one_place) {
  const test::TemporaryFolder folder;
  open(folder.write("both.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n"));
  std::size_t fronts = 0, backs = 0;
  for (int i = 0; i < 60; ++i) {
    const double turn = 2.4 * i, lean = std::cos(1.7 * i), away = 2 + i % 7;
    session_.view.camera.target = {0.3, 0.3, 0};
    session_.view.camera.eye = session_.view.camera.target + away * glm::dvec3(std::cos(turn), std::sin(turn), lean);
    const Image picture = headless_->picture(session_);
    for (int y = 0; y < picture.size.height; ++y)
      for (int x = 0; x < picture.size.width; ++x) {
        const Rgba at = picture.at(x, y);
        if (at[3] == 255) ++(at[0] > at[2] + 25 ? backs : fronts);
      }
  }
  EXPECT_GT(fronts, 100000u);
  EXPECT_EQ(backs, 0u);
}

}  // namespace
}  // namespace ryosen
