// Where the panels lie: hidden, folded, on the other side, in columns of another width, or behind tabs.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // how far a column scrolls
#include <glm/geometric.hpp>

#include "app/editor/preferences/layout.h"
#include "app/editor/session/session.h"
#include "app/ui/window_input.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using test::DrawnText;

class LayoutTest : public testing::Test, protected test::Laid {
 protected:
  explicit LayoutTest(Size size = test::window, float scale = 1) : Laid("cube.obj", size, scale) {
    input_.resize(size);
  }

  void run(const std::string& line) {
    ASSERT_TRUE(session.run(line).done()) << line;
    frames(3);
  }
  PixelRect view() const { return gui.view_area(size_, session.layout); }
  glm::dvec2 place(std::string_view text) const { return DrawnText(gui).place(text); }
  bool is_seen(std::string_view text) const { return DrawnText(gui).count(text) > 0; }
  void drag(glm::dvec2 from, glm::dvec2 to) {
    input_.move({from});
    input_.press(MouseButton::left, {from});
    for (const double share : {0.3, 0.7, 1.0}) input_.move({from + share * (to - from)});
    input_.release(MouseButton::left, {to, {}, now_s_ += 1});
    frames(2);
  }
  void view_click(glm::dvec2 at) {
    input_.move({at});
    input_.press(MouseButton::left, {at});
    input_.release(MouseButton::left, {at, {}, now_s_ += 1});
    frames(2);
  }
  // The menu of a panel, by the dots at the end of its header.
  void open_menu(std::string_view title) { click({gui.view_area(size_, {}).x0 - 30, place(title).y}); }

  WindowInput input_{gui, session, [this] { frames(1); }};
  double now_s_ = 1;
};

TEST_F(LayoutTest, the_left_column_fits_a_window_of_usual_height_whatever_is_broken) {
  const auto scrolls = [] { return ImGui::FindWindowByName("##left")->ScrollMax.y; };
  for (const char* file : {"torus.off", "cube.obj", "fin.obj", "bow_tie.obj", "collinear.obj", "klein_bottle.off"})
    for (const char* language : {"language en", "language ja"}) {
      open(file);
      run(language);
      frames(3);
      EXPECT_EQ(scrolls(), 0) << file << ", " << language;
    }
}

TEST_F(LayoutTest, a_column_that_scrolls_by_little_leaves_out_what_says_nothing) {
  const auto scrolls = [] { return ImGui::FindWindowByName("##left")->ScrollMax.y > 0; };
  open("fin.obj");
  int folded = 0, whole = 0;
  for (int height = 700; height <= 960; height += test::is_long_run() ? 2 : 6) {
    LayoutTest::size_ = {1280, height};
    frames(6);
    const bool leaves_out = is_seen("noneofithere");
    EXPECT_FALSE(scrolls() && !leaves_out) << height;
    for (int n = 0; n < 4; ++n) {
      frames(1);
      EXPECT_EQ(is_seen("noneofithere"), leaves_out) << height << ": it comes and goes";
    }
    (leaves_out ? folded : whole) += 1;
  }
  EXPECT_GT(folded, 0);
  EXPECT_GT(whole, 0);
}

TEST_F(LayoutTest, what_says_nothing_stands_behind_one_row_where_the_column_is_too_long) {
  LayoutTest::size_ = {1280, 600};
  frames(4);
  EXPECT_FALSE(is_seen("Duplicate"));
  click(place("more,noneofithere"));
  frames(4);
  EXPECT_TRUE(is_seen("Duplicate"));
  click(place("fewer"));
  frames(4);
  EXPECT_FALSE(is_seen("Duplicate"));
  run("delete f0");
  EXPECT_TRUE(is_seen("Boundary")) << "there is one";
  run("show seams on");
  EXPECT_TRUE(is_seen("Seams")) << "it was switched";
  LayoutTest::size_ = {1280, 1000};
  frames(4);
  EXPECT_TRUE(is_seen("Duplicate"));
  EXPECT_FALSE(is_seen("noneofithere"));
}

TEST_F(LayoutTest, a_click_on_a_header_folds_its_panel_and_another_unfolds_it) {
  ASSERT_TRUE(is_seen("Non-manifold"));
  const glm::dvec2 header = place("Highlights");
  click(header);
  EXPECT_EQ(session.layout.folded, std::set<std::string>{"highlights"});
  EXPECT_FALSE(is_seen("Non-manifold"));
  click(header);
  EXPECT_TRUE(session.layout.folded.empty());
  EXPECT_TRUE(is_seen("Non-manifold"));
  run("panel highlights fold");
  EXPECT_FALSE(is_seen("Non-manifold"));
  run("language ja");
  run("language en");
  EXPECT_FALSE(is_seen("Non-manifold")) << "it stays so";
}

TEST_F(LayoutTest, a_panel_has_a_menu_that_hides_it_and_puts_it_on_the_other_side) {
  const int column = view().x0;
  open_menu("Highlights");
  EXPECT_TRUE(gui.owns_pointer(session.layout, size_, {640, 360})) << "while the menu is open";
  click(place("Put on the right"));
  EXPECT_EQ(session.layout.moved, std::set<std::string>{"highlights"});
  EXPECT_GT(place("Highlights").x, 640);
  EXPECT_FALSE(gui.owns_pointer(session.layout, size_, {640, 360}));
  click(place("Highlights"), 1);
  click(place("Put on the left"));
  EXPECT_LT(place("Highlights").x, column);
  click(place("Highlights"), 1);
  click(place("Fold"));
  EXPECT_FALSE(is_seen("Non-manifold"));
  click(place("Highlights"), 1);
  click(place("Hide"));
  EXPECT_FALSE(is_seen("Highlights"));
  EXPECT_EQ(session.layout.switched, std::set<std::string>{"highlights"});
  EXPECT_EQ(view().x0, column);
}

TEST_F(LayoutTest, a_column_without_panels_leaves_its_place_to_the_view) {
  for (const char* id : {"tools", "highlights", "totals"}) run("panel " + std::string(id) + " off");
  EXPECT_EQ(view().x0, 0);
  EXPECT_EQ(session.view.origin.x, 0);
  EXPECT_EQ(session.view.size.width, view().width());
  EXPECT_FALSE(gui.owns_pointer(session.layout, size_, {100, 360}));
  run("panel history left");
  EXPECT_GT(view().x0, 0);
}

TEST_F(LayoutTest, a_drag_of_its_border_makes_a_column_wider_and_the_view_follows) {
  const PixelRect before = view();
  drag({before.x0 - 2, 400}, {before.x0 + 98, 430});
  EXPECT_NEAR(session.layout.left_px, before.x0 + 100, 3);
  EXPECT_EQ(view().x0, session.layout.left_px);
  EXPECT_EQ(session.view.origin.x, view().x0);
  EXPECT_EQ(session.view.size.width, view().width());
  EXPECT_TRUE(session.selecting.selection.empty());
  drag({before.x1 + 2, 400}, {before.x1 + 900, 400});
  EXPECT_EQ(session.layout.right_px, least_column_px);
  drag({view().x1 + 2, 400}, {5, 400});
  EXPECT_GE(view().width(), 200) << "the view keeps some room";
  const PixelRect now = view();
  drag({(now.x0 + now.x1) / 2, 400}, {now.x1 - 10, 430});
  EXPECT_EQ(view(), now) << "a drag in the view turns it";
}

TEST_F(LayoutTest, the_columns_take_widths_within_limits_and_the_view_keeps_its_least) {
  run("columns left 300");
  EXPECT_EQ(view().x0, 300);
  for (const char* wrong : {"columns", "columns left", "columns middle 300", "columns left 20", "columns right 5000",
                            "columns left wide", "columns left 300 300"})
    EXPECT_EQ(session.run(wrong).exit_code, ExitCode::usage) << wrong;
  run("columns left 640");
  run("columns right 640");
  EXPECT_EQ(view().width(), 200);
  EXPECT_TRUE(session.log().empty());
}

// At once, whatever makes the view another size; one that somebody has moved stays as it is.
TEST_F(LayoutTest, a_view_that_nobody_has_moved_is_framed_anew_with_its_size) {
  const char* const lines[] = {"columns right 640", "panel none",          "columns left 500", "prefer scale 1.25",
                               "prefer scale 1",    "prefer font_size 24", "panel tools left", "columns right 250"};
  for (const char* const line : lines) {
    ASSERT_TRUE(session.run(line).done()) << line;
    frames(2);
    EXPECT_TRUE(session.framing.is_framed()) << line;
    const Camera shown = session.view.camera;
    session.framing.frame_all();
    EXPECT_LT(glm::distance(shown.eye, session.view.camera.eye), 1e-9) << line;
  }
  session.view.camera = orbited(session.view.camera, {40, 20}, session.view.size, {0, 0, 0});
  const Camera moved = session.view.camera;
  run("columns right 500");
  EXPECT_EQ(session.view.camera, moved);
}

TEST_F(LayoutTest, what_a_click_would_do_stays_in_view_where_its_column_is_scrolled) {
  const glm::dvec2 before = place("Underthepointer");
  ASSERT_GT(before.y, 0);
  for (const char* line : {"colours edge_length", "panel levels on", "panel records on", "panel records"}) run(line);
  frames(6);
  ASSERT_GT(ImGui::FindWindowByName("##right")->Scroll.y, 50);
  EXPECT_EQ(place("Underthepointer"), before);
  const float end = ImGui::FindWindowByName("##right")->Size.y;
  session.layout.wanted = "inspector";
  frames(6);
  EXPECT_GT(place("Inspector").y, before.y + 100) << "below what stays";
  EXPECT_LT(place("Inspector").y, end);
}

TEST_F(LayoutTest, a_panel_that_is_asked_for_is_scrolled_to) {
  LayoutTest::size_ = {1280, 800};
  open("fin.obj");
  for (const char* line : {"select f0", "poke f0"}) run(line);
  for (const PanelRow& row : panel_list()) {
    if (row.place == PanelPlace::over) continue;
    ASSERT_TRUE(session.run("panel " + std::string(row.id) + " on").done());
    frames(6);
    const char* const column = session.layout.side_of(row) == PanelPlace::left ? "##left" : "##right";
    const float scrolled = ImGui::FindWindowByName(column)->Scroll.y;
    const glm::dvec2 title = place(row.title_en);
    EXPECT_GE(title.y, view().y0) << row.id;
    EXPECT_LT(title.y, view().y1 - 20) << row.id << ", the whole header";
    frames(3);
    EXPECT_EQ(ImGui::FindWindowByName(column)->Scroll.y, scrolled) << "it stays there";
    EXPECT_EQ(session.layout.wanted, "") << row.id;
  }
  const PixelRect column = areas_of(session.layout, {1280, 800}, 1).right;
  gui.pointer({(column.x0 + column.x1) / 2.0, column.y0 + 100.0});
  gui.wheel(50);
  frames(4);
  EXPECT_EQ(ImGui::FindWindowByName("##right")->Scroll.y, 0) << "it may be scrolled away again";
  run("levels");
  EXPECT_GE(place("Levels of detail").y, view().y0);
  EXPECT_LT(place("Levels of detail").y, view().y1 - 20) << "whatever opens it";
}

TEST_F(LayoutTest, its_commands_bring_it_back) {
  EXPECT_TRUE(session.layout.commands().empty());
  run("panel practice on");
  EXPECT_TRUE(session.layout.commands().empty()) << "no question is asked of the next mesh unasked";
  run("panel practice off");
  const std::vector<std::string> lines{"panel tools right", "panel totals off", "panel history fold",
                                       "columns left 300", "columns right 250"};
  for (const std::string& line : lines) run(line);
  EXPECT_EQ(session.layout.commands(), lines);
  Session other(std::make_unique<Document>());
  for (const std::string& line : session.layout.commands()) ASSERT_TRUE(other.run(line).done()) << line;
  EXPECT_EQ(other.layout.commands(), lines);
  for (const char* line : {"panel tools left", "panel totals on", "panel history unfold"}) run(line);
  EXPECT_EQ(session.layout.commands().size(), 2u);
}

TEST_F(LayoutTest, what_lies_over_the_view_is_only_opened_and_closed) {
  for (const char* wrong : {"panel keys fold", "panel keys left", "panel keys flyout", "panel tools over"})
    EXPECT_EQ(session.run(wrong).exit_code, ExitCode::usage) << wrong;
}

// Columns and what lies over the view grow with the letters, so that as much is read as before.
TEST_F(LayoutTest, larger_letters_have_as_much_room) {
  const UiSize large(1, 24);
  EXPECT_EQ(areas_of({}, {2400, 1200}, large).left.width(), areas_of({}, {2400, 1200}, UiSize(1.6f)).left.width());
  EXPECT_TRUE(areas_of({}, {1280, 800}, large).has_tabs);
  EXPECT_EQ(areas_of({}, {1280, 800}, UiSize(1, 11)).left.width(), areas_of({}, {1280, 800}, UiSize()).left.width());
  run("prefer font_size 24");
  for (const char* const panel : {"panel tools flyout", "panel preferences", "panel keys"}) {
    run(panel);
    frames(4);
    EXPECT_EQ(DrawnText(gui).cut_sideways() + DrawnText(gui).cut_in_height(), "") << panel;
  }
}

class NarrowWindow : public LayoutTest {
 protected:
  NarrowWindow() : LayoutTest({640, 480}) {}
};

TEST_F(NarrowWindow, leaves_most_of_its_width_to_the_view) {
  EXPECT_GE(view().width(), 0.85 * 640);
  EXPECT_EQ(session.view.size.width, view().width());
  EXPECT_TRUE(areas_of({}, {899, 600}, 1).has_tabs);
  EXPECT_FALSE(areas_of({}, {900, 600}, 1).has_tabs);
  EXPECT_TRUE(areas_of({}, {1799, 1200}, 2).has_tabs);
  EXPECT_FALSE(areas_of({}, {1800, 1200}, 2).has_tabs);
  for (const char* tab : {"Tools", "Highlights", "Totals", "Pointer", "Inspector", "Problems", "History", "Forms"})
    EXPECT_TRUE(is_seen(tab)) << tab;
  EXPECT_EQ(DrawnText(gui).cut_sideways() + DrawnText(gui).cut_in_height(), "");
}

class SmallWindow : public LayoutTest {
 protected:
  SmallWindow() : LayoutTest({640, 480}, 2) {}
};

// At scale 2 it is as 320 x 240: one strip of tabs a side, whose last is a menu of those that have no room.
TEST_F(SmallWindow, leaves_the_view_its_room_and_nothing_touches) {
  for (const char* const panel : {"panel colours on", "panel levels on", "panel none"}) run(panel);
  EXPECT_GE(view().width(), 0.75 * 640);
  EXPECT_EQ(DrawnText(gui).cut_sideways() + DrawnText(gui).cut_in_height() + DrawnText(gui).overlapping(), "");
  EXPECT_TRUE(is_seen("cube")) << "the name of the file, or its beginning";
  run("poke f0");
  EXPECT_TRUE(is_seen("*")) << "it is not saved";
  const double help = DrawnText(gui).last_place("Help").x, name = place("*").x;
  EXPECT_GT(name, help + 60) << "beside the last menu";
}

TEST_F(SmallWindow, what_has_no_tab_is_in_a_menu) {
  ASSERT_FALSE(is_seen("History")) << "else there is no need of it";
  const glm::dvec2 rest = place("+");
  ASSERT_GT(rest.x, view().x1) << "in the right strip";
  click(rest);
  frames(3);
  ASSERT_TRUE(is_seen("History"));
  click(place("History"));
  frames(3);
  EXPECT_EQ(session.layout.flyout, "history");
}

TEST_F(NarrowWindow, a_tab_opens_its_panel_and_another_click_closes_it) {
  const glm::dvec2 tab = place("Totals");
  ASSERT_FALSE(is_seen("vertices"));
  click(tab);
  frames(2);
  EXPECT_EQ(session.layout.flyout, "totals");
  EXPECT_TRUE(is_seen("vertices"));
  EXPECT_EQ(view().x0, areas_of({}, size_, 1).view.x0) << "the view stays as it is";
  EXPECT_TRUE(gui.owns_pointer(session.layout, size_, place("vertices")));
  EXPECT_FALSE(gui.owns_pointer(session.layout, size_, {500, 300}));
  click(tab);
  EXPECT_EQ(session.layout.flyout, "");
  EXPECT_FALSE(is_seen("vertices"));
  click(place("Highlights"));
  click(place("Problems"));
  EXPECT_EQ(session.layout.flyout, "problems") << "one takes the place of another";
  EXPECT_FALSE(is_seen("Non-manifold"));
  ASSERT_TRUE(session.run("cancel").done());
  EXPECT_EQ(session.layout.flyout, "");
  run("panel tools flyout");
  EXPECT_TRUE(is_seen("Collapse edge"));
}

TEST_F(NarrowWindow, a_panel_that_is_asked_for_is_opened_behind_its_tab) {
  run("panel colours on");
  EXPECT_EQ(session.layout.flyout, "colours");
  run("panel none");
  run("levels");
  EXPECT_EQ(session.layout.flyout, "levels");
  EXPECT_TRUE(is_seen("Keep this level"));
}

TEST_F(NarrowWindow, a_click_into_the_view_closes_what_a_tab_has_opened_and_does_nothing_else) {
  run("mode face");
  run("panel history flyout");
  const glm::dvec2 in_view{320, 240};
  ASSERT_TRUE(session.pointing.pick(in_view, PickMode::face));
  const glm::dvec3 eye = session.view.camera.eye;
  drag({200, 240}, {260, 240});
  EXPECT_NE(session.view.camera.eye, eye);
  EXPECT_EQ(session.layout.flyout, "history") << "a drag turns the view beside it";
  view_click(in_view);
  EXPECT_EQ(session.layout.flyout, "");
  EXPECT_TRUE(session.selecting.selection.empty());
  view_click(in_view);
  EXPECT_EQ(session.selecting.selection.size(), 1u);
}

TEST_F(NarrowWindow, a_wider_one_has_columns_again) {
  run("panel tools flyout");
  size_ = test::window;
  frames(3);
  EXPECT_EQ(session.layout.flyout, "");
  EXPECT_EQ(view(), areas_of({}, test::window, 1).view);
  EXPECT_TRUE(is_seen("Collapse edge"));
}

}  // namespace
}  // namespace ryosen
