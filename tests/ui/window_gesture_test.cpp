// Moving, turning, scaling and extruding by keys and pointer in the real window: axes, falloff, snapping, giving up;
// held against the file that is saved.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <set>
#include <vector>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/window_hand.h"

namespace ryosen {
namespace {

using test::Frame;
using test::words_of;

class WindowGesture : public test::WindowHand {
 protected:
  // How far each vertex of the file was moved by what is saved now.
  std::vector<glm::dvec3> moved() {
    const Mesh now = saved();
    const Mesh& before = session().mesh();
    EXPECT_EQ(now.vertex_slots(), before.vertex_slots());
    std::vector<glm::dvec3> by(before.vertex_slots(), glm::dvec3(0));
    for (std::uint32_t i = 0; i < std::min(now.vertex_slots(), before.vertex_slots()); ++i)
      by[i] = now.position(Vertex(i)) - before.position(Vertex(i));
    return by;
  }
  // Whether those of these vertices are moved by that, and all others by nothing.
  void expect_moved(const std::set<Vertex>& those, const glm::dvec3& by) {
    const std::vector<glm::dvec3> all = moved();
    for (std::uint32_t i = 0; i < all.size(); ++i)
      EXPECT_LT(glm::distance(all[i], those.contains(Vertex(i)) ? by : glm::dvec3(0)), 1e-9) << "vertex " << i;
  }
  void take_back() {
    xdotool("key ctrl+z");
    ASSERT_TRUE(is_at(0));
  }
  glm::dvec3 normal_of(Face f) {
    const Mesh& m = session().mesh();
    const Halfedge h = m.halfedge(f);
    const glm::dvec3 a = m.position(m.from(h)), b = m.position(m.to(h)), c = m.position(m.to(m.next(h)));
    return glm::normalize(glm::cross(b - a, c - a));
  }
};

TEST_F(WindowGesture, what_is_typed_goes_along_the_normal_or_an_axis_and_extrudes) {
  open_copy("torus.off");
  const OnFace at = on_a_face();
  const Mesh& m = session().mesh();
  std::set<Vertex> corners;
  for (const Vertex v : vertices_around(m, at.face)) corners.insert(v);
  xdotool("key 3");
  click(at.pixel);
  ASSERT_TRUE(has_selected(1));
  xdotool("key g key n type 0.25");
  xdotool("key Return");
  ASSERT_TRUE(is_at(1)) << "nothing was moved";
  expect_moved(corners, 0.25 * normal_of(at.face));
  take_back();
  xdotool("key g key y type 0.25");
  xdotool("key minus key Return");
  ASSERT_TRUE(is_at(1));
  expect_moved(corners, {0, -0.25, 0});
  take_back();
  xdotool("key e type 0.25");
  xdotool("key Return");
  ASSERT_TRUE(is_at(1)) << "E extrudes, in one entry";
  EXPECT_EQ(last().faces, 96 + 3);
  const Mesh extruded = saved();
  for (const Vertex v : corners) {
    EXPECT_TRUE(has_point(extruded, m.position(v)));
    EXPECT_TRUE(has_point(extruded, m.position(v) + 0.25 * normal_of(at.face)));
  }
}

TEST_F(WindowGesture, falloff_takes_along_what_is_near_and_the_wheel_widens_it) {
  open_made({"grid", "--columns", "20", "--rows", "20"});
  const Mesh& m = session().mesh();
  glm::dvec3 middle(0);
  for (const glm::dvec3& p : m.positions()) middle += p / double(m.vertex_slots());
  Vertex held(0);
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i)
    if (glm::distance(m.position(Vertex(i)), middle) < glm::distance(m.position(held), middle)) held = Vertex(i);
  xdotool("key 1");
  click(pixel_of(m.position(held)));
  ASSERT_TRUE(has_selected(1));
  std::size_t before = 1;
  for (const char* const wider : {"", "click --repeat 8 4 "}) {
    xdotool(std::string("key g key o key z ") + wider + "type 0.25");
    xdotool("key Return");
    ASSERT_TRUE(is_at(1));
    const std::vector<glm::dvec3> by = moved();
    EXPECT_LT(glm::distance(by[held.index], glm::dvec3(0, 0, 0.25)), 1e-9);
    std::size_t count = 0;
    double farthest = 0, nearest_left = 1e9;
    for (std::uint32_t i = 0; i < by.size(); ++i) {
      const double far = glm::distance(m.position(Vertex(i)), m.position(held));
      if (by[i] == glm::dvec3(0)) {
        nearest_left = std::min(nearest_left, far);
        continue;
      }
      ++count;
      farthest = std::max(farthest, far);
      EXPECT_TRUE(by[i].z > 0 && (Vertex(i) == held || by[i].z < 0.25)) << by[i].z;
    }
    EXPECT_GT(count, before) << wider;
    EXPECT_LT(count, by.size() / 2);
    EXPECT_LT(farthest, nearest_left + 1e-9) << "what is nearer is left behind";
    before = count;
    take_back();
  }
}

TEST_F(WindowGesture, with_ctrl_a_vertex_lands_on_another_and_turns_and_scales_go_in_steps) {
  open_copy("torus.off");
  const Mesh& m = session().mesh();
  const OnVertex held = on_a_vertex();
  OnVertex target = held;
  for (int i = 1; glm::distance(target.pixel, held.pixel) < 100; ++i) target = on_a_vertex(i);
  xdotool("key 1");
  click(held.pixel);
  ASSERT_TRUE(has_selected(1));
  const std::string there = "mousemove " + words_of(0.5 * (held.pixel + target.pixel)) + " mousemove " +
                            words_of(target.pixel + glm::dvec2(3, 2)) + " click 1";
  xdotool("key g " + test::while_held("ctrl", there));
  ASSERT_TRUE(is_at(1)) << "a click ends it";
  EXPECT_EQ(moved()[held.vertex.index], m.position(target.vertex) - m.position(held.vertex)) << "exactly";
  take_back();
  xdotool("mousemove " + words_of(held.pixel) + " key g " + there);
  ASSERT_TRUE(is_at(1));
  EXPECT_GT(glm::length(moved()[held.vertex.index] - (m.position(target.vertex) - m.position(held.vertex))), 1e-6)
      << "without Ctrl it goes where the pointer is";
  take_back();

  xdotool("key 3 key a");
  ASSERT_TRUE(has_selected(96));
  glm::dvec3 middle(0);
  for (const glm::dvec3& p : m.positions()) middle += p / double(m.vertex_slots());
  const glm::dvec2 centre = pixel_of(middle);
  xdotool("mousemove " + words_of(centre + glm::dvec2(200, 0)) + " key shift+s " +
          test::while_held("ctrl", "mousemove " + words_of(centre + glm::dvec2(228, 3)) + " click 1"));
  ASSERT_TRUE(is_at(1));
  const Mesh scaled = saved();
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i)
    EXPECT_LT(glm::distance(scaled.position(Vertex(i)), middle + 1.1 * (m.position(Vertex(i)) - middle)), 1e-9);
  take_back();
  // From the front, so that the axis of the turn is Z.
  xdotool("key KP_1 mousemove " + words_of(centre + glm::dvec2(200, 0)) + " key r " +
          test::while_held("ctrl", "mousemove " + words_of(centre + glm::dvec2(150, -86)) + " click 1"));
  ASSERT_TRUE(is_at(1));
  const Mesh turned = saved();
  const glm::dvec3 from = m.position(Vertex(0)) - middle, to = turned.position(Vertex(0)) - middle;
  const double deg = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y) * 180 / M_PI;
  EXPECT_GT(deg, 20);
  EXPECT_LT(deg, 40);
  EXPECT_NEAR(deg / 5, std::round(deg / 5), 1e-6) << deg << " degrees";
}

TEST_F(WindowGesture, escape_costs_nothing_whatever_was_begun) {
  open_copy("torus.off");
  const OnFace at = on_a_face();
  xdotool("key 3");
  click(at.pixel);
  ASSERT_TRUE(has_selected(1));
  for (const char* const key : {"g", "r", "shift+s", "e"}) {
    const auto is_moving = [](const Frame& frame) { return frame.is_gesture; };
    ASSERT_TRUE(shows(std::not_fn(is_moving)));
    xdotool("mousemove " + words_of(at.pixel) + " key " + key + " mousemove " +
            words_of(at.pixel + glm::dvec2(60, 20)) + " mousemove " + words_of(at.pixel + glm::dvec2(90, -30)));
    ASSERT_TRUE(shows(is_moving)) << key << " begins nothing";
    if (*key == 'e') {
      ASSERT_TRUE(shows([](const Frame& frame) { return frame.faces > 96; }));
    }
    xdotool("key Escape");
    ASSERT_TRUE(shows(std::not_fn(is_moving))) << "Escape does not end " << key;
    ASSERT_TRUE(has_faces(96)) << key;
    EXPECT_EQ(last().history, 0) << key;
  }
  EXPECT_EQ(last().selected, 1);
  EXPECT_EQ(saved().hash(), session().mesh().hash());
}

}  // namespace
}  // namespace ryosen
