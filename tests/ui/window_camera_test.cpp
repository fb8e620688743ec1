// The camera in the real window: what the wheel, drags and double clicks hold on to, by the eye that a picture tells
// of.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/analysis/problems.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/names.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/window_hand.h"

namespace ryosen {
namespace {

using test::Frame;

constexpr double told = 1e-4;  // as far as places in the picture's account can be told apart, on a mesh of some units

class WindowCamera : public test::WindowHand {
 protected:
  // Once the picture says that the eye is there.
  bool eye_is(const glm::dvec3& place) {
    return shows([&](const Frame& frame) { return glm::distance(frame.eye, place) < told; });
  }
  bool has_moved(const Camera& from) {
    return shows([&](const Frame& frame) { return glm::distance(frame.eye, from.eye) > told; });
  }
  // As it was at first, all in view.
  Camera home() {
    xdotool("key Home");
    EXPECT_TRUE(eye_is(session().view.camera.eye));
    return camera();
  }
  // Where a place is seen by the window's camera, as near as the account is exact.
  bool is_seen_at(const glm::dvec3& place, glm::dvec2 pixel) {
    return glm::distance(pixel_of(place, camera()), pixel) < 2;
  }
  glm::dvec3 place_under(glm::dvec2 pixel) { return session().pointing.pick(pixel, PickMode::face)->place; }
};

TEST_F(WindowCamera, the_wheel_goes_a_constant_share_of_the_way_to_the_point_under_it_and_never_through) {
  open_copy("torus.off");
  const glm::dvec2 at = on_face();
  const glm::dvec3 place = place_under(at), from = last().eye - place;
  click(at, "", 4);
  ASSERT_TRUE(has_moved(session().view.camera)) << "the wheel does nothing";
  const double share = glm::length(last().eye - place) / glm::length(from);
  EXPECT_LT(share, 0.95);
  EXPECT_GT(share, 0.5);
  int notches = 1;
  for (const int more : {1, 8, 50}) {
    xdotool("click --repeat " + std::to_string(more) + " --delay 1 4");
    const double left = std::pow(share, notches += more);
    ASSERT_TRUE(eye_is(place + left * from))
        << notches << " notches: " << glm::length(last().eye - place) << ", not " << left * glm::length(from);
  }
  EXPECT_GT(glm::dot(last().eye - place, from), 0) << "it is behind the surface";
  xdotool("click --repeat " + std::to_string(notches) + " --delay 1 5");
  EXPECT_TRUE(eye_is(place + from)) << "out again it is as it was";
}

// The nearest of a surface of flat faces is one of its vertices.
TEST_F(WindowCamera, over_the_background_the_wheel_goes_as_deep_as_the_nearest_that_is_seen) {
  open_copy("torus.off");
  const Camera before = home();
  const glm::dvec2 face = on_face(), beside = session().view.origin + glm::dvec2(60, 60);
  for (const PickMode what : {PickMode::vertex, PickMode::edge, PickMode::face})
    ASSERT_FALSE(session().pointing.pick(beside, what)) << "there is no background";
  const glm::dvec3 place = place_under(face);
  click(face, "", 4);
  ASSERT_TRUE(has_moved(before));
  const double share = 1 - glm::length(last().eye - place) / glm::length(before.eye - place);
  home();
  click(beside, "", 4);
  ASSERT_TRUE(has_moved(before));
  const glm::dvec3 moved = last().eye - before.eye;
  const glm::dvec3 along =
      unit_vector(ray_through(before, session().view.size, beside - session().view.origin).direction);
  EXPECT_LT(glm::length(moved - glm::dot(moved, along) * along), told) << "not towards the pointer";
  const double depth = glm::dot(moved, axes(before).forward) / share;
  double nearest = 1e9, farthest = 0;
  for (const glm::dvec3& p : session().mesh().positions()) {
    nearest = std::min(nearest, depth_of(before, p));
    farthest = std::max(farthest, depth_of(before, p));
  }
  EXPECT_GT(depth, nearest - 0.01 * (farthest - nearest));
  EXPECT_LT(depth, nearest + 0.2 * (farthest - nearest));
}

TEST_F(WindowCamera, drags_keep_the_point_that_was_pressed_and_clicks_make_it_the_centre_or_edit) {
  open_copy("torus.off");
  const glm::dvec2 at = on_face(), by(90, 40);
  const glm::dvec3 place = place_under(at);
  const Camera first = home();
  ASSERT_GT(glm::distance(place, first.target), 100 * told);
  for (const auto& [keys, button] : {std::pair("shift", 1), std::pair("", 3)}) {
    drag(at, at + by, keys, button);
    EXPECT_TRUE(shows([&](const Frame&) { return is_seen_at(place, at + by); })) << "the hand slips, button " << button;
    EXPECT_LT(glm::distance(camera().target - camera().eye, first.target - first.eye), told) << "panning turns nothing";
    home();
  }
  // A machine that is busy may take the two for clicks far apart.
  const auto is_centre = [&] { return glm::distance(last().target, place) < told; };
  for (int i = 0; i < 10 && !is_centre(); ++i) {
    xdotool("key ctrl+shift+a mousemove " + test::words_of(at) + " click --repeat 2 --delay 1 1");
    test::wait_for(is_centre, std::chrono::seconds(2));
  }
  ASSERT_TRUE(is_centre()) << "a double click with Select";
  EXPECT_LT(std::abs(glm::dot(last().eye - first.eye, axes(first).forward)), told) << "parallel to the screen";
  EXPECT_LT(
      glm::distance(last().target - last().eye, glm::dot(place - first.eye, axes(first).forward) * axes(first).forward),
      told)
      << "it does not turn";
  EXPECT_EQ(last().history, 0);

  home();
  const OnEdge edge = on_edge(0.31);
  xdotool("mousemove " + test::words_of(edge.pixel) + " key d click --repeat 2 --delay 1 1");
  ASSERT_TRUE(is_at(2)) << "two quick clicks with a tool are two edits";
  EXPECT_LT(glm::distance(last().eye, first.eye), told);

  xdotool("key Escape");
  home();
  drag(at, at + by);
  ASSERT_TRUE(has_moved(first));
  EXPECT_TRUE(is_seen_at(place, at)) << "it turns about another point";
  EXPECT_NEAR(glm::distance(last().eye, place), glm::distance(first.eye, place), told);
  EXPECT_GT(std::abs(glm::distance(last().eye, first.target) - glm::distance(first.eye, first.target)), 10 * told);
  say("orbit centre");
  const Camera turned = camera();
  // Where a machine is busy a drag may begin before the line has left the window.
  for (int i = 0; i < 3 && last().eye == turned.eye; ++i) {
    drag(at, at + by);
    test::wait_for([&] { return last().eye != turned.eye; }, std::chrono::seconds(5));
  }
  ASSERT_TRUE(has_moved(turned));
  EXPECT_LT(glm::distance(last().target, turned.target), told);
  EXPECT_NEAR(glm::distance(last().eye, turned.target), glm::distance(turned.eye, turned.target), told);
}

// Of the torus, as it is seen at first.
std::string name_of_farthest_face() {
  test::Laid laid("torus.off", {1280, 800});
  const Session& session = laid.session;
  const auto depth = [&](std::uint32_t i) { return depth_of(session.view.camera, middle_of(session.mesh(), Face(i))); };
  std::uint32_t farthest = 0;
  for (std::uint32_t i = 0; i < session.mesh().face_slots(); ++i)
    if (depth(i) > depth(farthest)) farthest = i;
  return "f" + std::to_string(farthest);
}

TEST_F(WindowCamera, a_problem_of_the_list_is_flown_to_and_its_loop_selected_with_all_that_is_around_in_view) {
  open_made({"edit", test::asset("torus.off"), "--do", "delete " + name_of_farthest_face()});
  const Mesh& m = session().mesh();
  std::vector<Edge> loop;
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i)
    if (m.is_alive(Edge(i)) && (!m.face(halfedge(Edge(i), 0)) || !m.face(halfedge(Edge(i), 1)))) loop.emplace_back(i);
  ASSERT_EQ(loop.size(), 3u);
  const auto is_seen = [&](Edge e) {
    const auto [a, b] = ends(m, e);
    const auto picked = session().pointing.pick(pixel_of(0.5 * (m.position(a) + m.position(b))), PickMode::edge);
    return picked && picked->element == Element(e);
  };
  beside().frames(3);
  const glm::dvec2 header = test::DrawnText(beside().gui).place("Inspector");
  click(header);  // folds it: room for the list below
  beside().click(header);
  const glm::dvec2 kind = test::DrawnText(beside().gui).place("1boundaryloop");
  ASSERT_GT(kind.x, 0);
  click(kind);
  beside().click(kind);
  const std::string name = name_on_points(m, loop[0]);
  const glm::dvec2 row = test::DrawnText(beside().gui).last_place(name);
  ASSERT_GT(row.x, 0) << name;
  const Camera before = camera();
  for (const Edge e : loop) ASSERT_FALSE(is_seen(e)) << "it is in view at first";
  click(row);
  ASSERT_TRUE(has_selected(3)) << "the whole loop";
  ASSERT_TRUE(has_moved(before)) << "nobody flies there";
  session().view.camera = camera();
  for (const Edge e : loop) EXPECT_TRUE(is_seen(e)) << "from the side where it is seen";
  for (const Edge e : loop)
    for (const Vertex v : neighbours(m, ends(m, e).first)) {
      const glm::dvec2 pixel = pixel_of(m.position(v)) - session().view.origin;
      EXPECT_TRUE(pixel.x > 0 && pixel.y > 0 && pixel.x < session().view.size.width &&
                  pixel.y < session().view.size.height)
          << name_of(m, v) << " is cut off";
    }
}

}  // namespace
}  // namespace ryosen
