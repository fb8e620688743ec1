#include "app/ui/viewport.h"

#include <gtest/gtest.h>

#include <random>

#include "render/context/context.h"
#include "tests/support/app/program.h"

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

TEST(viewport, what_follows_edits_looks_like_what_is_drawn_anew) {
  auto context = make_headless_context(Backend::osmesa);
  ASSERT_TRUE(context);
  auto made = Viewport::make();
  ASSERT_TRUE(made);
  Viewport& viewport = **made;
  std::mt19937 random(5);
  int edits = 0;
  const char* const names[] = {"fin.obj",     "moebius.off",      "torus.off",     "ball.off",
                               "bow_tie.obj", "hanging_pair.obj", "two_quads.obj", "klein_bottle.off"};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    const std::string name = names[i];
    auto document = Document::open(test::asset(name));
    ASSERT_TRUE(document);
    Session session(std::move(document).value());
    session.view = {320, 240};
    session.frame_all();
    ASSERT_TRUE(session.run("show all").done());
    ASSERT_TRUE(session.run(i % 2 == 0 ? "shading flat" : "shading smooth").done());
    const auto picture = [&](const char* show) {
      EXPECT_TRUE(session.run(show).done());
      viewport.follow(session);
      viewport.draw();
      return viewport.view().read_pixels();
    };
    viewport.forget();
    picture("show all");
    for (int step = 0; step < 60; ++step) {
      // What is hidden, changed and shown again without a picture between is not the same any more.
      if (step % 6 == 2) {
        EXPECT_TRUE(session.run("show creases off").done());
      }
      edits += session.run(random_line(session, random)).done();
      const Image followed = picture("show all");
      if (step % 6 != 5) continue;
      const Image bare = picture("show all off");
      viewport.forget();
      const Image bare_anew = picture("show all off");
      ASSERT_LE(different_pixels(followed, bare, picture("show all"), bare_anew), 20) << name << " step " << step;
    }
  }
  EXPECT_GT(edits, 100);
}

TEST(viewport, a_log_that_is_replayed_gives_the_same_hash_and_the_same_final_picture) {
  auto context = make_headless_context(Backend::osmesa);
  ASSERT_TRUE(context);
  auto made = Viewport::make();
  ASSERT_TRUE(made);
  Viewport& viewport = **made;
  std::mt19937 random(11);
  for (const char* const name : {"fin.obj", "torus.off", "ball.off"}) {  // whose faces lie apart
    const auto begun = [&] {
      auto session = std::make_unique<Session>(Document::open(test::asset(name)).value());
      session->view = {320, 240};
      session->frame_all();
      return session;
    };
    const auto picture = [&](Session& session) {
      viewport.follow(session);
      viewport.draw();
      return viewport.view().read_pixels();
    };
    const auto session = begun();
    viewport.forget();
    int edits = 0;
    for (int step = 0; step < 40; ++step) {
      edits += session->run(random_line(*session, random)).done();
      picture(*session);
    }
    EXPECT_GT(edits, 15) << name;
    const Image last = picture(*session);
    const auto again = begun();
    for (const std::string& line : session->log()) ASSERT_TRUE(again->run(line).done()) << name << ": " << line;
    EXPECT_EQ(again->mesh().hash(), session->mesh().hash()) << name;
    viewport.forget();
    const Image replayed = picture(*again);
    int different = 0;  // an edit may lay faces in one place, where the first one drawn is seen
    for (std::size_t i = 0; i < last.pixels.size(); ++i) different += last.pixels[i] != replayed.pixels[i];
    EXPECT_LE(different, 20) << name;
  }
}

TEST(viewport, a_coloured_surface_follows_edits_as_if_drawn_anew) {
  auto context = make_headless_context(Backend::osmesa);
  ASSERT_TRUE(context);
  auto made = Viewport::make();
  ASSERT_TRUE(made);
  Viewport& viewport = **made;
  std::mt19937 random(7);
  for (const char* const map : {"edge_length", "valence", "dihedral", "area", "sides"}) {
    auto document = Document::open(test::asset("ball.off"));
    ASSERT_TRUE(document);
    Session session(std::move(document).value());
    session.view = {240, 200};
    session.frame_all();
    const auto picture = [&] {
      viewport.follow(session);
      viewport.draw();
      return viewport.view().read_pixels();
    };
    ASSERT_TRUE(session.run("show all off").done());
    const Image bare = picture();
    ASSERT_TRUE(session.run(std::string("colours ") + map).done());
    EXPECT_NE(picture().pixels, bare.pixels) << map;
    int edits = 0;
    for (int step = 0; step < 25; ++step) {
      edits += session.run(random_line(session, random)).done();
      const Image followed = picture();
      viewport.forget();
      ASSERT_EQ(followed.pixels, picture().pixels) << map << " step " << step;
    }
    EXPECT_GT(edits, 5);
    ASSERT_TRUE(session.run("colours off").done());
    const Image off = picture();
    viewport.forget();
    EXPECT_EQ(off.pixels, picture().pixels);
  }
}

TEST(viewport, handles_and_guides_that_come_and_go_are_drawn_as_in_a_full_redraw) {
  auto context = make_headless_context(Backend::osmesa);
  ASSERT_TRUE(context);
  auto made = Viewport::make();
  ASSERT_TRUE(made);
  Viewport& viewport = **made;
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  session.view = {320, 240};
  session.frame_all();
  const auto picture = [&] {
    viewport.follow(session);
    viewport.draw();
    return viewport.view().read_pixels();
  };
  for (const char* line : {"mode vertex", "select v0 v1 v7"}) ASSERT_TRUE(session.run(line).done());
  const Image bare = picture();
  ASSERT_TRUE(session.run("gizmo move").done());
  EXPECT_TRUE(picture().pixels != bare.pixels) << "handles are drawn";
  const auto middle = project(session.camera, session.view, session.gizmo()->middle);
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
    const Image followed = picture();
    viewport.view().draw(PixelRect::all(session.view));
    EXPECT_TRUE(followed.pixels == viewport.view().read_pixels().pixels) << line;
  }
}

}  // namespace
}  // namespace ryosen
