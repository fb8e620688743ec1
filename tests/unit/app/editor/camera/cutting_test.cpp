// What the clipping plane cuts off is not picked, and hides nothing.
#include "app/editor/camera/cutting.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/find_element.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class CuttingTest : public testing::Test {
 protected:
  explicit CuttingTest(const std::string& name = "cube.obj") : session_(Document::open(test::asset(name)).value()) {
    session_.framing.frame_all();
  }
  void run(const std::string& line) {
    const Outcome outcome = session_.run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
  }
  glm::dvec2 middle() const { return {0.5 * session_.view.size.width, 0.5 * session_.view.size.height}; }
  glm::dvec3 place_of(Vertex v) const { return session_.mesh().position(v); }
  // The mean height along an axis of the corners of the face at the middle of the view.
  double along(int axis) {
    const auto picked = session_.pointing.pick(middle(), PickMode::face);
    if (!picked) return std::nan("");
    double sum = 0, corners = 0;
    for (const Vertex v : vertices_around(session_.mesh(), picked->face)) sum += place_of(v)[axis], ++corners;
    return sum / corners;
  }

  Session session_;
};

TEST_F(CuttingTest, what_is_cut_off_is_not_picked_and_hides_nothing) {
  run("view front");
  const double front = along(2);
  run("clip z");
  const double back = along(2);
  EXPECT_LT(back, front) << "through where the front was, the inner side of the back";
  run("clip -z");
  EXPECT_EQ(along(2), front) << "the back is cut off, which is not seen from here";
  run("clip off");
  EXPECT_EQ(along(2), front);
}

TEST_F(CuttingTest, vertices_and_boxes_are_taken_on_this_side_alone) {
  run("view front");
  run("mode vertex");
  run("xray on");
  run("box 0,0 1279,719");
  const std::size_t all = session_.selecting.selection.size();
  run("clip z");
  run("box 0,0 1279,719");
  EXPECT_EQ(2 * session_.selecting.selection.size(), all);
  const ClipPlane plane = *session_.view.clip_plane();
  for (const Element& e : session_.selecting.selection) EXPECT_FALSE(plane.cuts(place_of(e.vertex())));
  run("mode face");
  run("box 0,0 1279,719");
  EXPECT_EQ(session_.selecting.selection.size(), 1u) << "whole faces";
}

// The edges along Z are cut in the middle: the near half cannot be picked, the far one can.
TEST_F(CuttingTest, of_an_edge_the_part_is_picked_that_is_left) {
  run(R"(camera {"eye":[6,0.8,0.5],"target":[0.5,0.5,0.5],"up":[0,1,0],"ortho_height":null})");
  run("clip z");
  const ClipPlane plane = *session_.view.clip_plane();
  int picked_kept = 0, picked_cut = 0;
  for (std::uint32_t i = 0; i < session_.mesh().edge_slots(); ++i) {
    const auto [a, b] = ends(session_.mesh(), Edge(i));
    if (place_of(a).x < 0.5 || place_of(b).x < 0.5 || std::abs((place_of(a) - place_of(b)).z) < 0.1) continue;
    for (const double share : {0.1, 0.3, 0.7, 0.9}) {
      const glm::dvec3 place = glm::mix(place_of(a), place_of(b), share);
      const auto picked =
          session_.pointing.pick(project(session_.view.camera, session_.view.size, place)->pixel, PickMode::edge);
      if (plane.cuts(place)) {
        picked_cut += picked && picked->element == Element(Edge(i));
      } else {
        ASSERT_TRUE(picked);
        picked_kept += picked->element == Element(Edge(i));
        EXPECT_NEAR(glm::length(picked->place - place), 0, 1e-6);
        const glm::dvec3 said = glm::mix(place_of(session_.mesh().from(picked->halfedge)),
                                         place_of(session_.mesh().to(picked->halfedge)), picked->along);
        EXPECT_NEAR(glm::length(said - place), 0, 1e-6) << "the share is that of the whole edge";
      }
    }
  }
  EXPECT_EQ(picked_kept, 4);
  EXPECT_EQ(picked_cut, 0);
}

TEST_F(CuttingTest, moves_by_shares_and_steps_and_stays_through_edits) {
  EXPECT_EQ(session_.run("clip_at 0.3").exit_code, ExitCode::refused) << "there is none yet";
  run("clip x");
  const auto [low, high] =
      std::pair(bounds_of(session_.mesh().positions()).lowest.x, bounds_of(session_.mesh().positions()).highest.x);
  const auto offset = [&] { return session_.view.clip_plane()->offset; };
  EXPECT_DOUBLE_EQ(offset(), 0.5 * (low + high));
  run("clip_at 0.25");
  EXPECT_DOUBLE_EQ(offset(), low + 0.25 * (high - low));
  run("clip_at +0.5");
  EXPECT_DOUBLE_EQ(offset(), low + 0.75 * (high - low));
  run("key PageDown");
  EXPECT_DOUBLE_EQ(offset(), low + 0.73 * (high - low));
  run("clip_at +1");
  EXPECT_DOUBLE_EQ(offset(), high) << "and no farther";
  run("clip -x");
  EXPECT_DOUBLE_EQ(offset(), -0.5 * (low + high));
  run("move_vertex v0 9,9,9");
  EXPECT_DOUBLE_EQ(offset(), -0.5 * (low + high));
  for (const char* const wrong : {"clip_at", "clip_at x", "clip_at 2", "clip_at 0.1 0.2"})
    EXPECT_EQ(session_.run(wrong).exit_code, ExitCode::usage) << wrong;
  session_.set_document(std::make_unique<Document>());
  EXPECT_FALSE(session_.view.cut);
}

TEST_F(CuttingTest, across_the_line_of_sight_it_takes_the_nearer_half) {
  run("view iso");
  run("clip view");
  const ClipPlane plane = *session_.view.clip_plane();
  EXPECT_TRUE(plane.cuts(session_.view.camera.eye));
  EXPECT_FALSE(plane.cuts(session_.view.camera.target + 1e-6 * axes(session_.view.camera).forward));
}

}  // namespace
}  // namespace ryosen
