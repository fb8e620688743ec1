// Each gesture of the hand in the real window: where on an edge, the table of input, moving; by mouse and keys, and
// what came of it in the picture's account and in the file that is saved.
#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/names.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/window_hand.h"

namespace ryosen {
namespace {

using test::Frame;
using test::WindowHand;
using test::words_of;

TEST_F(WindowHand, a_split_is_where_the_pointer_is_and_a_collapse_goes_to_the_end_whose_third_it_is) {
  open_copy("cube.obj");
  const OnEdge at = on_edge(0.31);
  xdotool("mousemove 640 100 key d mousemove " + words_of(at.pixel) + " click 1");
  ASSERT_TRUE(is_at(1)) << "nothing was split";
  const Mesh split = saved();
  EXPECT_EQ(split.live().vertices, 9u);
  const bool is_there = has_point(split, at.from + 0.3 * (at.to - at.from));
  EXPECT_TRUE(is_there) << "at the tenth that is nearest";
  xdotool("key ctrl+z");
  ASSERT_TRUE(is_at(0));

  const OnEdge end = on_edge(0.2);
  xdotool("key c mousemove " + words_of(end.pixel + glm::dvec2(1, 0)) + " mousemove " + words_of(end.pixel) +
          " click 1");
  ASSERT_TRUE(is_at(1)) << "nothing was collapsed";
  const Mesh to_end = saved();
  EXPECT_EQ(to_end.live().vertices, 7u);
  EXPECT_TRUE(has_point(to_end, end.from)) << "the end that is pointed at stays";
  EXPECT_FALSE(has_point(to_end, end.to));
  xdotool("key ctrl+z");
  ASSERT_TRUE(is_at(0));

  const OnEdge middle = on_edge(0.5);
  xdotool("mousemove " + words_of(middle.pixel) + " click 1");
  ASSERT_TRUE(is_at(1));
  EXPECT_TRUE(has_point(saved(), 0.5 * (middle.from + middle.to))) << "over the middle third it is the middle";
}

// Each step is looked up in the mesh; the same steps beside the window say where the eye has to be.
TEST_F(WindowHand, halfedges_are_clicked_walked_by_arrows_and_followed_by_links_and_the_camera) {
  open_copy("torus.off");
  const Mesh& m = session().mesh();
  const auto is_first = [&](Halfedge h) {
    return shows([name = name_of(m, h)](const Frame& frame) { return frame.first == name && frame.selected == 1; });
  };
  const glm::dvec2 at = on_edge(0.5).pixel + glm::dvec2(0, 3);
  const auto picked = session().pointing.pick(at, PickMode::halfedge);
  ASSERT_TRUE(picked && picked->element.kind == Element::Kind::halfedge);
  Halfedge h = picked->element.halfedge();
  xdotool("key 4 mousemove " + words_of(at) + " click 1");
  ASSERT_TRUE(is_first(h)) << "not the one that was clicked, but " << last().first;
  for (const std::string& line : {std::string("mode halfedge"), "select h" + std::to_string(h.index)})
    ASSERT_TRUE(session().run(line).done()) << line;

  const auto walk = [&](const char* key, Halfedge to) {
    xdotool(std::string("key ") + key);
    ASSERT_TRUE(session().run(std::string("key ") + key).done());
    h = to;
    ASSERT_TRUE(is_first(h)) << key << " leads to " << last().first;
  };
  walk("Right", m.next(h));
  walk("Left", m.prev(h));
  walk("Up", twin(h));
  walk("Down", m.counter_clockwise(h));

  // What stands behind the word in the panel.
  beside().frames(3);
  const glm::dvec2 word = test::DrawnText(beside().gui).place("twin" + name_of(m, twin(h)));
  ASSERT_GT(word.x, 0) << "the panel has no such link";
  const double behind_the_word = 90;
  xdotool("mousemove " + words_of(word + glm::dvec2(behind_the_word, 0)) + " click 1");
  ASSERT_TRUE(is_first(twin(h))) << "the link does not select";
  h = twin(h);

  const glm::dvec3 eye = last().eye;
  for (int i = 0; i < 20 && last().eye == eye; ++i) {  // along a strip of triangles
    walk("Right", m.next(h));
    walk("Up", twin(h));
    walk("Left", m.prev(h));
    walk("Up", twin(h));
  }
  EXPECT_NE(last().eye, eye) << "the camera does not follow to where the next one is hidden";
}

TEST_F(WindowHand, drags_turn_pan_and_select_whatever_comes_behind_them_at_once) {
  open_copy("torus.off");
  const auto [low, high] = around_all();
  const auto is_turned = [&](glm::dvec3 eye) { return shows([eye](const Frame& frame) { return frame.eye != eye; }); };
  const glm::dvec2 at = on_face();
  const glm::dvec3 eye = last().eye;
  drag(at, at + glm::dvec2(80, 20));
  ASSERT_TRUE(is_turned(eye)) << "a drag turns";
  EXPECT_EQ(last().selected, 0);
  double far = 40;  // each time another way, so that no frame shows the place of the drag before
  for (const auto& [keys, button] : {std::pair("shift", 1), std::pair("", 3), std::pair("shift", 2)}) {
    xdotool("key Home");
    const glm::dvec3 before = last().eye;
    drag(at, at + glm::dvec2(far += 20, 10), keys, button);
    ASSERT_TRUE(is_turned(before)) << keys << " and button " << button;
    EXPECT_EQ(last().selected, 0) << keys << " and button " << button;
  }
  xdotool("key Home key 3");
  // The pointer has gone on before the window looks at the press: several times, since that is a race.
  for (int i = 0; i < 6; ++i) {
    xdotool("key Home key ctrl+shift+a");
    ASSERT_TRUE(has_selected(0));
    drag(low, high, "ctrl shift");
    ASSERT_TRUE(shows([](const Frame& frame) { return frame.selected > 0; })) << "the box selected nothing, time " << i;
    EXPECT_LT(last().selected, 96) << "what is behind is not";
  }
  drag(low, high, "ctrl shift alt");
  ASSERT_TRUE(has_selected(96)) << "with Alt through the surface";
  xdotool("key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0));
  xdotool("key b mousemove " + words_of(low) + " mousedown 1 mousemove " + words_of({high.x, low.y}) + " mousemove " +
          words_of(high) + " keydown alt mouseup 1 keyup alt");
  ASSERT_TRUE(has_selected(96)) << "with Alt pressed before the end too";
  xdotool("key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0)) << "no menu has the keys";
  xdotool("key b");
  drag(low, high);
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.selected > 0; })) << "B and a drag";
  xdotool("key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0));
  xdotool("key shift+b mousemove " + words_of(low) + " mousedown 1 mousemove " + words_of({high.x, low.y}) +
          " mousemove " + words_of(high) + " mousemove " + words_of({low.x, high.y}) + " mouseup 1");
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.selected > 0; })) << "a lasso";
  EXPECT_EQ(last().history, 0);
  xdotool("key z");
  xdotool("key w");
  xdotool("key Escape");
  EXPECT_TRUE(has_selected(0)) << "Esc at last selects nothing";
}

TEST_F(WindowHand, keys_delete_dissolve_weld_fill_and_hide_what_is_selected) {
  open_copy("torus.off");
  const std::string face = words_of(on_face());
  xdotool("key 3 mousemove " + face + " click 1");
  ASSERT_TRUE(has_selected(1));
  xdotool("key x");
  ASSERT_TRUE(has_faces(95)) << "X deletes";
  EXPECT_EQ(last().history, 1);
  xdotool("key ctrl+z");
  ASSERT_TRUE(has_faces(96));
  EXPECT_TRUE(has_selected(1)) << "undo brings the selection back";
  xdotool("key Delete");
  ASSERT_TRUE(has_faces(95)) << "Delete deletes";
  xdotool("key ctrl+z");
  ASSERT_TRUE(has_faces(96));
  ASSERT_TRUE(has_selected(1));
  xdotool("key h");
  ASSERT_TRUE(has_selected(0)) << "H hides it";
  xdotool("key ctrl+h");
  const OnEdge edge = on_edge(0.5);
  xdotool("key 2 mousemove " + words_of(edge.pixel) + " click 1");
  ASSERT_TRUE(has_selected(1));
  xdotool("key shift+x");
  ASSERT_TRUE(has_faces(95)) << "Shift+X dissolves the edge";
  xdotool("key ctrl+z");
  ASSERT_TRUE(has_faces(96));
  // A vertex of a hole's two sides: the hole is made by deleting a face, and filled again.
  xdotool("key 3 mousemove " + face + " click 1");
  ASSERT_TRUE(has_selected(1));
  xdotool("key ctrl+2");
  ASSERT_TRUE(has_selected(3)) << "its edges";
  xdotool("key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0)) << "the handles of the selection would be clicked";
  xdotool("key 3 mousemove " + face + " click 1 key x");
  ASSERT_TRUE(has_faces(95));
  xdotool("key 2");
  type("select boundary_loop");
  ASSERT_TRUE(has_selected(3));
  xdotool("mousemove 640 60 key f");
  ASSERT_TRUE(has_faces(96)) << "F fills the hole";
}

TEST_F(WindowHand, typed_numbers_move_turn_and_scale_exactly_and_escape_costs_nothing) {
  open_copy("cube.obj");
  const Mesh before = session().mesh();
  xdotool("mousemove 640 400 key 3 key a");
  ASSERT_TRUE(has_selected(6));
  const auto each_is = [&](const Mesh& m, auto moved) {
    for (std::uint32_t i = 0; i < before.vertex_slots(); ++i)
      if (glm::distance(m.position(Vertex(i)), moved(before.position(Vertex(i)))) > 1e-9) return false;
    return m.vertex_slots() == before.vertex_slots();
  };
  xdotool("key g mousemove 700 450 mousemove 760 500 key Escape");
  xdotool("mousemove 640 400 key g key x type 0.5");
  xdotool("key Return");
  ASSERT_TRUE(is_at(1)) << "what was given up is no entry, what was ended is one";
  EXPECT_TRUE(each_is(saved(), [](glm::dvec3 p) { return p + glm::dvec3(0.5, 0, 0); }));
  xdotool("key ctrl+z");
  ASSERT_TRUE(is_at(0));
  xdotool("key shift+s type 2");
  xdotool("key Return");
  ASSERT_TRUE(is_at(1));
  const glm::dvec3 middle = 0.125 * [&] {
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : before.positions()) sum += p;
    return sum;
  }();
  EXPECT_TRUE(each_is(saved(), [&](glm::dvec3 p) { return middle + 2.0 * (p - middle); }));
  xdotool("key ctrl+z");
  ASSERT_TRUE(is_at(0));
  xdotool("key r key z type 90");
  xdotool("key Return");
  ASSERT_TRUE(is_at(1));
  EXPECT_TRUE(each_is(saved(), [&](glm::dvec3 p) {
    const glm::dvec3 d = p - middle;
    return middle + glm::dvec3(-d.y, d.x, d.z);
  }));
  xdotool("key ctrl+z");
  ASSERT_TRUE(is_at(0));
  // By the pointer, ended by a click; the right button gives it up.
  xdotool("mousemove 640 400 key g mousemove 700 400 click 3");
  xdotool("mousemove 640 400 key g mousemove 660 400 mousemove 700 400 click 1");
  ASSERT_TRUE(is_at(1)) << "a click ends it";
  EXPECT_FALSE(each_is(saved(), [](glm::dvec3 p) { return p; }));
}

TEST_F(WindowHand, menus_open_by_f10_or_alt_alone_and_the_right_button_shows_what_fits) {
  open_copy("cube.obj");
  type("split 0-1");
  ASSERT_TRUE(is_at(1));
  xdotool("mousemove 640 60 key F10 key Right key Return");
  ASSERT_TRUE(is_at(0)) << "the first entry of Edit is undo";
  xdotool("key alt key Right key Return");
  ASSERT_TRUE(is_at(1)) << "Alt alone opens them too; undo cannot be done, so that redo is the first";
  xdotool("key F10 key Right key Escape");
  xdotool("key ctrl+z");
  ASSERT_TRUE(is_at(0)) << "the keys are the view's again";
  xdotool("key 3 mousemove " + words_of(on_face()) + " click 3");
  ASSERT_TRUE(has_selected(1)) << "what the menu is about";
  EXPECT_EQ(last().history, 0);
  xdotool("key --delay 150 Escape key g key z type 1");
  xdotool("key Return");
  EXPECT_TRUE(is_at(1)) << "the menu has gone";
}

}  // namespace
}  // namespace ryosen
