// What keys and the right button do with a selection in the real window: welding, dividing and joining, faces, hiding;
// and what they do in the other presets.
#include <glm/geometric.hpp>
#include <vector>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/all.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/window_hand.h"

namespace ryosen {
namespace {

using test::Frame;
using test::words_of;

class WindowKeys : public test::WindowHand {
 protected:
  // One after the other, and nothing else.
  void select(const std::vector<glm::dvec2>& pixels) {
    xdotool("key ctrl+shift+a");
    for (const glm::dvec2& pixel : pixels) click(pixel, "shift");
    ASSERT_TRUE(has_selected(static_cast<long>(pixels.size())));
  }
  bool has_vertices(long n) {
    return shows([n](const Frame& frame) { return frame.vertices == n; });
  }
  bool has_edges(long n) {
    return shows([n](const Frame& frame) { return frame.edges == n; });
  }
  void take_back(long entry) {
    xdotool("key ctrl+z");
    ASSERT_TRUE(is_at(entry));
  }
  glm::dvec3 middle_of_all() {
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : session().mesh().positions()) sum += p;
    return sum / double(session().mesh().vertex_slots());
  }
};

TEST_F(WindowKeys, weld_divide_join_and_make_a_face_of_selected_vertices) {
  open_copy("cube.obj");
  const OnEdge edge = on_edge(0.5);
  xdotool("key 1");
  select({pixel_of(edge.from), pixel_of(edge.to)});
  xdotool("key m");
  ASSERT_TRUE(has_vertices(7)) << "M welds";
  const Mesh welded = saved();
  EXPECT_TRUE(has_point(welded, edge.to)) << "into the last one";
  EXPECT_FALSE(has_point(welded, edge.from));
  take_back(0);
  ASSERT_TRUE(has_selected(2));
  xdotool("key shift+m");
  ASSERT_TRUE(has_vertices(7)) << "Shift+M welds";
  EXPECT_TRUE(has_point(saved(), 0.5 * (edge.from + edge.to))) << "in the middle";
  take_back(0);

  const OnFace face = on_a_face();
  std::vector<glm::dvec2> corners;
  for (const Vertex v : vertices_around(session().mesh(), face.face))
    corners.push_back(pixel_of(session().mesh().position(v)));
  ASSERT_EQ(corners.size(), 4u);
  select({corners[0], corners[2]});
  xdotool("key j");
  ASSERT_TRUE(has_faces(7)) << "J divides their face";
  EXPECT_EQ(last().edges, 13);
  take_back(0);
  xdotool("key 3");
  select({face.pixel});
  xdotool("key x");
  ASSERT_TRUE(has_faces(5));
  xdotool("key 1");
  select({corners[0], corners[2]});
  xdotool("key j");
  ASSERT_TRUE(has_edges(13)) << "J joins them where no face is";
  EXPECT_EQ(last().faces, 5);
  take_back(1);
  select(corners);
  xdotool("key f");
  ASSERT_TRUE(has_faces(6)) << "F makes a face on them";
  EXPECT_EQ(last().history, 2);
  EXPECT_EQ(last().edges, 12);
}

// The entry where a session with the same panels has it.
TEST_F(WindowKeys, isolate_show_all_and_take_the_others_and_the_menu_of_the_element_does_what_it_says) {
  open_copy("torus.off");
  const glm::dvec2 at = on_face();
  xdotool("key 3");
  select({at});
  xdotool("key i");
  ASSERT_TRUE(has_selected(95)) << "I takes the others";
  select({at});
  xdotool("key shift+h key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0));
  xdotool("key a");
  ASSERT_TRUE(has_selected(1)) << "Shift+H leaves it alone";
  xdotool("key ctrl+h key a");
  ASSERT_TRUE(has_selected(96)) << "Ctrl+H shows all again";
  xdotool("key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0));

  click(at, "", 3);
  ASSERT_TRUE(has_selected(1)) << "what the menu is about";
  ASSERT_TRUE(session().run("mode face").done());
  beside().gui.pointer(at);
  session().pointing.select_for_menu(at);
  beside().gui.open_element_menu();
  beside().frames(4);
  const glm::dvec2 entry = test::DrawnText(beside().gui).last_place(find_op("detach")->name_en);
  ASSERT_GT(entry.x, 0) << "the menu has no such entry";
  click(entry + glm::dvec2(8, 0));
  ASSERT_TRUE(has_vertices(51)) << "the entry does nothing";
  EXPECT_EQ(last().history, 1);
}

TEST_F(WindowKeys, the_preset_blender_scales_by_s_swaps_by_shift_s_selects_by_left_and_turns_by_middle) {
  open_copy("torus.off");
  say("preset blender");
  const auto [low, high] = around_all();
  const glm::dvec3 eye = last().eye;
  xdotool("key 3");
  drag(low, high);
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.selected > 0; })) << "a drag selects";
  EXPECT_LT(last().selected, 96);
  EXPECT_EQ(last().eye, eye) << "and turns nothing";
  xdotool("key a key s type 2");
  xdotool("key Return");
  ASSERT_TRUE(is_at(1)) << "S scales";
  const Mesh scaled = saved();
  const glm::dvec3 middle = middle_of_all();
  for (std::uint32_t i = 0; i < scaled.vertex_slots(); ++i)
    EXPECT_LT(glm::distance(scaled.position(Vertex(i)), 2.0 * session().mesh().position(Vertex(i)) - middle), 1e-9);
  take_back(0);
  const OnEdge edge = on_edge(0.5);
  xdotool("key alt+a key shift+s");
  click(edge.pixel);
  ASSERT_TRUE(is_at(1)) << "Shift+S swaps";
  const Mesh swapped = saved();
  EXPECT_EQ(swapped.live().edges, 144u);
  const auto [a, b] = ends(session().mesh(), edge.edge);
  EXPECT_FALSE(find_halfedge(swapped, a, b)) << "the edge is still there";
  xdotool("key Escape");
  const long selected = last().selected;
  drag(on_face(), on_face() + glm::dvec2(60, 20), "", 2);
  ASSERT_TRUE(shows([&](const Frame& frame) { return frame.eye != eye; })) << "the middle button turns";
  EXPECT_EQ(last().selected, selected);
}

TEST_F(WindowKeys, the_preset_meshlab_turns_by_left_pans_by_ctrl_zooms_by_shift_and_boxes_by_both) {
  open_copy("torus.off");
  say("preset meshlab");
  const auto [low, high] = around_all();
  const glm::dvec2 at = on_face(), by(70, 30);
  const glm::dvec3 place = session().pointing.pick(at, PickMode::face)->place;
  xdotool("key 3");
  drag(low, high, "ctrl shift");
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.selected > 0; })) << "both select by a box";
  xdotool("key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0));
  const Camera first = camera();
  const auto is_panned = [&](const Frame&) { return glm::distance(pixel_of(place, camera()), at + by) < 2; };
  drag(at, at + by, "ctrl");
  EXPECT_TRUE(shows(is_panned)) << "Ctrl pans";
  xdotool("key Home");
  ASSERT_TRUE(shows([&](const Frame& frame) { return glm::distance(frame.eye, first.eye) < 1e-4; }));
  drag(at, at + by, "shift");
  ASSERT_TRUE(shows([&](const Frame& frame) { return glm::distance(frame.eye, first.eye) > 0.1; })) << "Shift zooms";
  EXPECT_LT(glm::length(glm::cross(glm::normalize(last().eye - place), glm::normalize(first.eye - place))), 1e-4);
  xdotool("key Home");
  ASSERT_TRUE(shows([&](const Frame& frame) { return glm::distance(frame.eye, first.eye) < 1e-4; }));
  drag(at, at + by);
  ASSERT_TRUE(shows([&](const Frame& frame) { return glm::distance(frame.eye, first.eye) > 0.1; })) << "it turns";
  EXPECT_NEAR(glm::distance(last().eye, place), glm::distance(first.eye, place), 1e-3);
  EXPECT_EQ(last().selected, 0);
}

}  // namespace
}  // namespace ryosen
