#include "app/ui/viewport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "app/editor/session/session.h"
#include "render/context/context.h"
#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

// Pixels where two pictures differ although the surface below looks the same in both. Where faces lie in one place, it
// may not: the first one drawn is seen.
int different_pixels(const Image& a, const Image& bare_a, const Image& b, const Image& bare_b) {
  int n = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    n += a.pixels[i] != b.pixels[i] && bare_a.pixels[i] == bare_b.pixels[i];
  return n;
}

class ViewportTest : public testing::Test {
 protected:
  ViewportTest() : context_(make_headless_context(Backend::osmesa).value()), viewport_(Viewport::make().value()) {}

  static std::unique_ptr<Session> opened(const std::string& asset, Size size = {320, 240}) {
    auto session = std::make_unique<Session>(Document::open(test::asset(asset)).value());
    session->view.size = size;
    session->framing.frame_all();
    return session;
  }
  // What follows the session from the last picture.
  Image picture(Session& session) {
    viewport_->follow(session);
    viewport_->draw();
    return viewport_->renderer().read_pixels();
  }
  Image picture(Session& session, const std::string& line) {
    EXPECT_TRUE(session.run(line).done()) << line;
    return picture(session);
  }

  std::unique_ptr<Context> context_;
  std::unique_ptr<Viewport> viewport_;
};

// What is listed is also drawn, where several marks lie on one edge too: each leaves pixels of its colour.
TEST_F(ViewportTest, each_of_the_problems_at_one_edge_is_seen) {
  const test::TemporaryFolder folder;
  const std::string mix = folder.write("mix.off",
                                       "OFF\n9 5 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n5 5 5\n.1 .1 .1\n.2 .2 .2\n"
                                       ".3 .3 .3\n0 0 0\n3 0 1 2\n3 0 0 3\n3 0 1 3\n3 5 6 7\n3 0 8 3\n");
  Session session(Document::open(mix).value());
  session.view.size = {640, 480};
  session.framing.frame_all();
  for (const Theme theme : {Theme::dark, Theme::light}) {
    session.view.settings.theme = theme;
    const std::vector<Rgba> pixels = picture(session).pixels;
    for (const char* id : {"boundary", "misoriented", "degenerate"}) {
      const HighlightRow& row = *find_highlight(id);
      const Rgba colour = rgb(theme == Theme::dark ? row.looks.dark : row.looks.light);
      EXPECT_GT(std::count(pixels.begin(), pixels.end(), colour), 150) << id;
    }
  }
}

// A random operator line, an undo or a redo.
std::string random_line(const Session& session, std::mt19937& random) {
  if (random() % 5 == 0) return "undo";
  if (random() % 8 == 0) return "redo";
  const Mesh& mesh = session.mesh();
  Halfedge h;
  do h = Halfedge(static_cast<std::uint32_t>(random() % mesh.halfedge_slots()));
  while (!mesh.is_alive(h));
  const AnyOp ops[] = {CollapseEdge{h, CollapseEdge::Place::middle}, SwapEdge{h}, SplitEdge{h, 0.25}};
  return command_of(mesh, ops[random() % 3]);
}

TEST_F(ViewportTest, what_follows_edits_looks_like_what_is_drawn_anew) {
  std::mt19937 random(5);
  int edits = 0;
  const int steps = test::is_long_run() ? 60 : 18;
  const char* const names[] = {"fin.obj",     "moebius.off",      "torus.off",     "ball.off",
                               "bow_tie.obj", "hanging_pair.obj", "two_quads.obj", "klein_bottle.off"};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    const std::string name = names[i];
    const std::unique_ptr<Session> opened_session = opened(name);
    Session& session = *opened_session;
    ASSERT_TRUE(session.run(i % 2 == 0 ? "shading flat" : "shading smooth").done());
    viewport_->forget();
    picture(session, "show all");
    for (int step = 0; step < steps; ++step) {
      // What is hidden, changed and shown again without a picture between is not the same any more.
      if (step % 6 == 2) {
        EXPECT_TRUE(session.run("show creases off").done());
      }
      edits += session.run(random_line(session, random)).done();
      const Image followed = picture(session, "show all");
      if (step % 6 != 5) continue;
      const Image bare = picture(session, "show all off");
      viewport_->forget();
      const Image bare_anew = picture(session, "show all off");
      ASSERT_LE(different_pixels(followed, bare, picture(session, "show all"), bare_anew), 20)
          << name << " step " << step;
    }
  }
  EXPECT_GT(edits, 4 * steps);
}

// A small edit, an undo, a movement by hand that ends or is given up, or something hidden.
void change_a_little(Session& session, std::mt19937& random) {
  const auto kind = random() % 10;
  if (kind < 7) {
    session.run(random_line(session, random));
    return;
  }
  const std::uint32_t slots = session.mesh().vertex_slots();
  session.run("select v" + std::to_string(random() % slots));
  if (kind == 7) {
    session.run("hide selected");
    session.run("unhide");
    return;
  }
  if (!session.run("gesture move").done()) return;
  session.gesturing.follow({100 + static_cast<int>(random() % 120), 80 + static_cast<int>(random() % 80)}, {});
  session.run(kind == 8 ? "key Enter" : "key Escape");
}

// Each follows at its own pace: one every change, one every seventh, one that comes late.
TEST_F(ViewportTest, several_on_one_session_draw_the_same) {
  const auto session = opened("torus.off");
  for (const char* const line : {"show all", "shading smooth"}) ASSERT_TRUE(session->run(line).done());
  const auto second = Viewport::make().value();
  std::unique_ptr<Viewport> third;
  std::mt19937 random(17);
  const int steps = test::is_long_run() ? 1000 : 500;
  std::map<const Viewport*, std::size_t> rebuilt;  // by small changes
  const auto follow = [&](Viewport& viewport, bool is_small) {
    const std::size_t before = viewport.rebuilds();
    viewport.follow(*session);
    if (is_small) rebuilt[&viewport] += viewport.rebuilds() - before;
  };
  follow(*viewport_, false);
  follow(*second, false);
  const auto all = [&] {
    std::vector<Image> images;
    for (Viewport* const each : {viewport_.get(), second.get(), third.get()}) {
      if (!each) continue;
      each->draw();
      images.push_back(each->renderer().read_pixels());
    }
    return images;
  };
  for (int step = 1; step <= steps; ++step) {
    if (step == steps / 2) {
      third = Viewport::make().value();
      follow(*third, false);
    }
    const bool is_trial = step % 100 == 0;
    if (is_trial) {
      for (const char* const line : {"levels", "levels at 40"}) session->run(line);
    } else {
      change_a_little(*session, random);
    }
    follow(*viewport_, !is_trial);
    if (is_trial || step % 7 == 0) follow(*second, !is_trial);
    if (third && (is_trial || step % 7 == 0)) follow(*third, !is_trial);
    if (step % 49 == 0 || is_trial) {
      const std::vector<Image> images = all();
      for (std::size_t i = 1; i < images.size(); ++i) {
        int different = 0;
        for (std::size_t k = 0; k < images[0].pixels.size(); ++k)
          different += images[0].pixels[k] != images[i].pixels[k];
        ASSERT_LE(different, 20) << "step " << step << ", reader " << i;
      }
    }
    if (is_trial) {
      session->run("levels close");
      for (Viewport* const each : {viewport_.get(), second.get(), third.get()})
        if (each) follow(*each, false);
    }
  }
  EXPECT_EQ(rebuilt.size(), 3u);
  for (const auto& [viewport, count] : rebuilt) EXPECT_LE(count, 10u);
}

TEST_F(ViewportTest, a_log_that_is_replayed_gives_the_same_hash_and_the_same_final_picture) {
  std::mt19937 random(11);
  for (const char* const name : {"fin.obj", "torus.off", "ball.off", "klein_bottle.off", "moebius.off"}) {
    const auto session = opened(name);
    viewport_->forget();
    int edits = 0;
    for (int step = 0; step < 40; ++step) {
      edits += session->run(random_line(*session, random)).done();
      picture(*session);
    }
    EXPECT_GT(edits, 15) << name;
    const Image last = picture(*session), bare = picture(*session, "show all off");
    const auto again = opened(name);
    for (const std::string& line : session->log()) ASSERT_TRUE(again->run(line).done()) << name << ": " << line;
    EXPECT_EQ(again->mesh().hash(), session->mesh().hash()) << name;
    viewport_->forget();
    const Image replayed = picture(*again);
    EXPECT_LE(different_pixels(last, bare, replayed, picture(*again, "show all off")), 20) << name;
  }
}

TEST_F(ViewportTest, a_coloured_surface_follows_edits_as_if_drawn_anew) {
  std::mt19937 random(7);
  for (const char* const map : {"edge_length", "valence", "dihedral", "area", "sides"}) {
    const std::unique_ptr<Session> opened_session = opened("ball.off", {240, 200});
    Session& session = *opened_session;
    viewport_->forget();
    const Image bare = picture(session, "show all off");
    EXPECT_NE(picture(session, std::string("colours ") + map).pixels, bare.pixels) << map;
    int edits = 0;
    for (int step = 0; step < (test::is_long_run() ? 25 : 12); ++step) {
      edits += session.run(random_line(session, random)).done();
      const Image followed = picture(session);
      viewport_->forget();
      ASSERT_EQ(followed.pixels, picture(session).pixels) << map << " step " << step;
    }
    EXPECT_GT(edits, 5);
    const Image off = picture(session, "colours off");
    viewport_->forget();
    EXPECT_EQ(off.pixels, picture(session).pixels);
  }
}

TEST_F(ViewportTest, verdicts_on_all_edges_follow_the_tool_edits_and_what_is_hidden) {
  const auto session = opened("moebius.off");
  Image last = picture(*session, "tool swap");
  for (const char* line : {"key V", "tool collapse", "poke f5", "undo", "hide f3", "theme light", "unhide", "tool poke",
                           "tool split", "key V"}) {
    const Image followed = picture(*session, line);
    EXPECT_TRUE(followed.pixels != last.pixels) << line;
    viewport_->forget();
    last = picture(*session);
    EXPECT_TRUE(followed.pixels == last.pixels) << line;
  }
  EXPECT_EQ(session->selecting.tool_verdicts(), nullptr);
  EXPECT_TRUE(last.pixels == picture(*session, "tool none").pixels) << "the tool alone shows nothing";
}

TEST_F(ViewportTest, handles_and_guides_that_come_and_go_are_drawn_as_in_a_full_redraw) {
  const std::unique_ptr<Session> opened_session = opened("torus.off");
  Session& session = *opened_session;
  for (const char* line : {"mode vertex", "select v0 v1 v7"}) ASSERT_TRUE(session.run(line).done());
  const Image bare = picture(session);
  ASSERT_TRUE(session.run("gizmo move").done());
  EXPECT_TRUE(picture(session).pixels != bare.pixels) << "handles are drawn";
  const auto middle = project(session.view.camera, session.view.size, session.pointing.gizmo()->middle);
  const auto at = [&](double x, double y) {
    return std::to_string(middle->pixel.x + x) + "," + std::to_string(middle->pixel.y + y);
  };
  const std::string lines[] = {"move " + at(0, 0),
                               "move " + at(2, -50),
                               "press left " + at(2, -50),
                               "move " + at(20, -70),
                               "key O",
                               "wheel 3 " + at(20, -70),
                               "move " + at(40, 10) + " Ctrl",
                               "key Shift+X",
                               "release left " + at(40, 10),
                               "undo",
                               "gizmo turn",
                               "gizmo scale",
                               "move " + at(1, 1),
                               "tool split",
                               "tool none",
                               "select add v20",
                               "gizmo off"};
  for (const std::string& line : lines) {
    EXPECT_TRUE(session.run(line).done()) << line;
    const Image followed = picture(session);
    viewport_->renderer().draw(PixelRect::all(session.view.size));
    EXPECT_TRUE(followed.pixels == viewport_->renderer().read_pixels().pixels) << line;
  }
}

}  // namespace
}  // namespace ryosen
