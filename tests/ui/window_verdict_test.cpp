// Verdicts in the real window: one that is held is there until the pointer has reached its remedy; and where on an edge
// a click with a tool is taken to be.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/camera/camera_text.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/window_hand.h"

namespace ryosen {
namespace {

using test::Frame;
using test::words_of;

class WindowVerdict : public test::WindowHand {};

TEST_F(WindowVerdict, a_held_one_waits_until_the_pointer_has_pressed_the_button_of_a_remedy) {
  open_copy("tetrahedron.off");
  const OnEdge edge = on_edge(0.5), other = on_edge(0.5, 1);
  xdotool("key c");
  click(edge.pixel);
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.is_held; })) << "the click was not refused";
  EXPECT_EQ(last().history, 0);
  EXPECT_FALSE(last().said.empty()) << "nobody says why";
  ASSERT_TRUE(session().run("tool collapse").done());
  beside().gui.pointer(edge.pixel);
  ASSERT_EQ(session().pointing.click(edge.pixel, "collapse").kind, Outcome::Kind::refused);
  const std::vector<std::string> remedy = session().selecting.hover_remedy();
  ASSERT_FALSE(remedy.empty());
  beside().frames(3);
  const glm::dvec2 button = test::DrawnText(beside().gui).place(remedy.back());
  ASSERT_GT(button.x, session().view.origin.x + session().view.size.width) << "it has no button in the column";

  const std::string held = last().hover;
  std::string way = "mousemove " + words_of(other.pixel);  // over another edge, across the view, onto the panel
  for (const double share : {0.3, 0.6, 0.9})
    way += " mousemove " + words_of(other.pixel + share * (button - other.pixel));
  const long before = last().number;
  xdotool(way + " mousemove " + words_of(button));
  test::wait_for([&] { return last().number > before; }, std::chrono::seconds(2));
  EXPECT_TRUE(last().is_held);
  EXPECT_EQ(last().hover, held);
  xdotool("click 1");
  ASSERT_TRUE(is_at(1)) << "the button does nothing";
  ASSERT_TRUE(session().run(remedy.back()).done());
  EXPECT_EQ(last().vertices, session().mesh().live().vertices) << remedy.back();
  EXPECT_EQ(last().edges, session().mesh().live().edges);
  EXPECT_EQ(last().faces, session().mesh().live().faces);
}

TEST_F(WindowVerdict, shift_frees_a_split_from_tenths_and_what_is_small_collapses_to_its_middle) {
  open_copy("cube.obj");
  const OnEdge at = on_edge(0.337);
  const auto picked = session().pointing.pick(at.pixel, PickMode::edge);
  ASSERT_GT(std::abs(10 * picked->along - std::round(10 * picked->along)), 0.1) << "it cannot be told from a tenth";
  const Mesh& m = session().mesh();
  const glm::dvec3 from = m.position(m.from(picked->halfedge)), to = m.position(m.to(picked->halfedge));
  xdotool("key d");
  click(at.pixel, "shift");
  ASSERT_TRUE(is_at(1)) << "nothing was split";
  const double less_than_a_pixel = 0.001 * glm::distance(from, to);
  EXPECT_TRUE(has_point(saved(), from + picked->along * (to - from), less_than_a_pixel)) << "where the pointer is";
  xdotool("key Escape key ctrl+z");
  ASSERT_TRUE(is_at(0));

  // So far away that the edges are short, but can be told apart.
  const auto longest_px = [&] {
    double longest = 0;
    for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
      const auto [a, b] = ends(m, Edge(i));
      longest = std::max(longest, glm::distance(pixel_of(m.position(a)), pixel_of(m.position(b))));
    }
    return longest;
  };
  const glm::dvec2 middle =
      session().view.origin + 0.5 * glm::dvec2(session().view.size.width, session().view.size.height);
  const std::string at_middle = format_pixel(middle);
  int notches = 0;
  for (; longest_px() > 23; ++notches) ASSERT_TRUE(session().run("wheel -1 " + at_middle).done());
  xdotool("mousemove " + words_of(middle) + " click --repeat " + std::to_string(notches) + " --delay 1 5");
  ASSERT_TRUE(shows([&](const Frame& frame) { return glm::distance(frame.eye, session().view.camera.eye) < 1e-3; }));
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
    const auto [a, b] = ends(m, Edge(i));
    const glm::dvec2 near_end = pixel_of(m.position(a) + 0.2 * (m.position(b) - m.position(a)));
    const auto small = session().pointing.pick(near_end, PickMode::edge);
    if (!small || small->element != Element(Edge(i)) || std::abs(small->along - 0.5) < 0.2) continue;
    xdotool("key c");
    click(near_end);
    ASSERT_TRUE(is_at(1)) << "nothing was collapsed";
    EXPECT_TRUE(has_point(saved(), 0.5 * (m.position(a) + m.position(b)))) << "not to the middle";
    return;
  }
  ADD_FAILURE() << "no end of a short edge can be pointed at";
}

}  // namespace
}  // namespace ryosen
