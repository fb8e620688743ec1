#include "app/ui/window_input.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/program.h"
#include "tests/support/app/window_size.h"

namespace ryosen {
namespace {

using test::window;

constexpr glm::dvec2 in_view{640, 560};  // on a face of the torus

class WindowInputTest : public testing::Test {
 protected:
  void SetUp() override { input_.resize(window); }
  void frames(int n) { laid_.frames(n); }
  void press(glm::dvec2 pixel, MouseButton button = MouseButton::left) { input_.press(button, {pixel}); }
  void release(glm::dvec2 pixel, MouseButton button = MouseButton::left) {
    input_.release(button, {pixel, {}, now_s_ += 0.1});
  }
  // Whether the view turns when the pointer moves.
  bool moves_view() {
    const glm::dvec3 before = session_.view.camera.eye;
    input_.move({in_view + glm::dvec2(60, 0)});
    input_.move({in_view + glm::dvec2(120, 0)});
    return session_.view.camera.eye != before;
  }
  bool gui_has_a_button() {
    frames(2);  // a short press is shown to one frame
    const ImGuiIO& io = ImGui::GetIO();
    return io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2];
  }

  test::Laid laid_{"torus.off"};
  Session& session_ = laid_.session;
  Gui& gui_ = laid_.gui;
  WindowInput input_{gui_, session_};
  const glm::dvec2 on_panel_ = laid_.place_of("Swapedge");  // a row of the tools
  double now_s_ = 1;
};

TEST_F(WindowInputTest, a_press_on_a_panel_that_ends_over_the_view) {
  input_.move({on_panel_});
  press(on_panel_);
  EXPECT_TRUE(gui_has_a_button());
  EXPECT_FALSE(moves_view());
  release(in_view);
  EXPECT_FALSE(gui_has_a_button());
  EXPECT_FALSE(moves_view());
  EXPECT_TRUE(session_.selecting.selection.empty()) << "no click";
}

TEST_F(WindowInputTest, a_press_in_the_view_that_ends_over_a_panel) {
  input_.move({in_view});
  press(in_view);
  EXPECT_TRUE(moves_view());
  input_.move({on_panel_});
  release(on_panel_);
  EXPECT_FALSE(input_.is_dragging());
  EXPECT_FALSE(moves_view());
  EXPECT_FALSE(gui_has_a_button());
  EXPECT_EQ(session_.selecting.tool, "") << "the panel was not clicked";
}

TEST_F(WindowInputTest, a_press_on_a_panel_during_a_drag_is_released_too) {
  press(in_view, MouseButton::right);
  input_.move({on_panel_});
  press(on_panel_);
  EXPECT_TRUE(gui_has_a_button());
  release(on_panel_);
  EXPECT_FALSE(gui_has_a_button());
  EXPECT_TRUE(input_.is_dragging());
  release(on_panel_, MouseButton::right);
  EXPECT_FALSE(input_.is_dragging());
}

TEST_F(WindowInputTest, losing_the_keyboard_ends_every_press_without_a_click) {
  press(in_view);
  input_.let_go();
  EXPECT_FALSE(input_.is_dragging());
  EXPECT_FALSE(moves_view());
  release(in_view);  // the window system may still tell
  EXPECT_TRUE(session_.selecting.selection.empty());

  input_.move({on_panel_});
  press(on_panel_);
  input_.let_go();
  EXPECT_FALSE(gui_has_a_button());
}

TEST_F(WindowInputTest, a_release_that_was_never_told_does_not_hold_the_next_press) {
  press(in_view);
  press(in_view + glm::dvec2(200, -200));
  release(in_view + glm::dvec2(200, -200));
  EXPECT_FALSE(input_.is_dragging());
}

TEST_F(WindowInputTest, a_panel_that_opens_during_a_press_takes_the_click) {
  press(in_view);
  ASSERT_TRUE(session_.run("panel keys").done());
  frames(2);
  release(in_view);
  EXPECT_TRUE(session_.selecting.selection.empty());
  EXPECT_FALSE(input_.is_dragging());
}

TEST_F(WindowInputTest, a_double_click_sets_the_centre_with_select_and_edits_twice_with_a_tool) {
  for (const char* tool : {"tool none", "tool poke"}) {
    const bool edits = std::string_view(tool) != "tool none";
    ASSERT_TRUE(session_.run(tool).done());
    ASSERT_TRUE(session_.run("frame all").done());
    const std::size_t before = session_.document().position();
    const glm::dvec3 target = session_.view.camera.target;
    ASSERT_TRUE(session_.pointing.pick(in_view, PickMode::face));
    for (int click = 1; click <= 2; ++click) {
      press(in_view);
      release(in_view);
      EXPECT_EQ(session_.view.camera.target == target, edits || click == 1) << tool << ", click " << click;
      EXPECT_LE(session_.document().position() - before, edits ? static_cast<std::size_t>(click) : 0u);
    }
    EXPECT_EQ(session_.document().position() > before, edits);
    now_s_ += 10;
  }
}

// The handles of what the first click has selected come to lie under the second, where that is beside it.
TEST_F(WindowInputTest, a_double_click_sets_the_centre_through_a_handle_that_its_first_click_has_brought) {
  ASSERT_TRUE(session_.run("gizmo move").done());
  std::optional<glm::dvec2> at;
  for (int y = 100; y < window.height - 100 && !at; y += 5)
    for (int x = 300; x < window.width - 300 && !at; x += 5) {
      const glm::dvec2 pixel(x, y);
      if (session_.pointing.pick(pixel, PickMode::edge) || !session_.pointing.pick_to_select(pixel, PickMode::edge))
        continue;
      session_.pointing.click(pixel, "");
      if (session_.pointing.handle_at(pixel, {})) at = pixel;
      session_.selecting.selection.clear();
    }
  ASSERT_TRUE(at);
  const glm::dvec3 target = session_.view.camera.target;
  for (int click = 1; click <= 2; ++click) {
    press(*at);
    release(*at);
    EXPECT_EQ(session_.selecting.selection.size(), 1u);
  }
  EXPECT_NE(session_.view.camera.target, target);
}

TEST_F(WindowInputTest, a_key_between_two_clicks_makes_them_two) {
  const glm::dvec3 target = session_.view.camera.target;
  session_.run("mode face");
  press(in_view);
  release(in_view);
  input_.key_down("A");
  input_.key_up("A");
  press(in_view);
  release(in_view);
  EXPECT_EQ(session_.view.camera.target, target);
  EXPECT_EQ(session_.selecting.selection.size(), 1u);
}

TEST_F(WindowInputTest, a_click_may_move_as_far_as_the_display_is_fine) {
  session_.run("mode face");
  const glm::dvec2 away = in_view + glm::dvec2(6, 0);
  for (const double scale : {1.0, 2.0}) {
    session_.selecting.selection.clear();
    session_.preferences.display_scale = scale;
    press(in_view);
    input_.move({away});
    release(away);
    EXPECT_EQ(session_.selecting.selection.size(), scale == 1 ? 0u : 1u) << scale;
  }
}

// A window, whose frames may come after all of it.
TEST_F(WindowInputTest, a_click_on_a_panel_is_where_it_was_made_though_the_pointer_goes_on_at_once) {
  WindowInput fast(gui_, session_, {}, [this] { frames(3); });
  fast.resize(window);
  fast.move({on_panel_});
  fast.press(MouseButton::left, {on_panel_});
  fast.release(MouseButton::left, {on_panel_});
  fast.move({in_view});
  frames(2);
  EXPECT_NE(session_.selecting.tool, "") << "the row of the tool was clicked";
}

TEST(gui, takes_another_scale_while_it_runs) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  Gui gui(1);
  gui.prepare(session);
  const float before = gui.fonts().Fonts[0]->FontSize;
  gui.set_scale(2);
  EXPECT_EQ(gui.view_area({2560, 1440}, {}), Gui(2).view_area({2560, 1440}, {}));
  EXPECT_TRUE(gui.prepare(session)) << "the glyphs are made anew";
  EXPECT_EQ(gui.fonts().Fonts[0]->FontSize, 2 * before);
  gui.frame(session, {2560, 1440}, 0.02);
  gui.set_scale(2);
  EXPECT_FALSE(gui.prepare(session));
}

TEST_F(WindowInputTest, a_key_that_is_held_down_repeats_where_that_helps) {
  session_.run("mode face");
  session_.run("select f0");
  input_.key_down("+");
  const std::size_t once = session_.selecting.selection.size();
  EXPECT_GT(once, 1u);
  input_.key_down("+", true);
  EXPECT_GT(session_.selecting.selection.size(), once);
  input_.key_down("I");
  const std::size_t others = session_.selecting.selection.size();
  input_.key_down("I", true);
  EXPECT_EQ(session_.selecting.selection.size(), others) << "it would come and go";
}

TEST_F(WindowInputTest, bands_select_what_lies_in_them) {
  session_.run("mode face");
  const auto drag = [&](Modifiers modifiers, MouseButton button = MouseButton::left) {
    const glm::dvec2 low = session_.view.origin,
                     high = low + glm::dvec2(session_.view.size.width - 1, session_.view.size.height - 1);
    input_.press(button, {low + glm::dvec2(1), modifiers});
    input_.move({0.5 * low + 0.5 * high, modifiers});
    EXPECT_TRUE(session_.view.band);
    input_.move({high, modifiers});
    input_.release(button, {high, modifiers});
    EXPECT_FALSE(session_.view.band);
  };
  const Camera camera = session_.view.camera;
  drag({.shift = true, .ctrl = true});
  const std::size_t seen = session_.selecting.selection.size(), all = session_.mesh().live().faces;
  EXPECT_GT(seen, 0u);
  EXPECT_LT(seen, all);
  drag({.shift = true, .ctrl = true, .alt = true});
  EXPECT_EQ(session_.selecting.selection.size(), all) << "through the surface";
  EXPECT_EQ(session_.view.camera, camera);
  input_.key("B");
  drag({.ctrl = true});
  EXPECT_EQ(session_.selecting.selection.size(), all - seen) << "toggled";
  input_.key("Shift+B");
  drag({});
  EXPECT_TRUE(session_.selecting.selection.empty()) << "a lasso along a line surrounds nothing";
  ASSERT_TRUE(session_.run("preset blender").done());
  drag({});
  EXPECT_EQ(session_.selecting.selection.size(), seen) << "the left button draws boxes there";
  EXPECT_TRUE(session_.log().empty());
}

// Whenever Alt is pressed until the button is let go.
TEST_F(WindowInputTest, alt_counts_when_a_box_ends_and_opens_no_menu_that_was_down_during_a_drag) {
  session_.run("mode face");
  const glm::dvec2 low = session_.view.origin + glm::dvec2(2),
                   high =
                       session_.view.origin + glm::dvec2(session_.view.size.width - 2, session_.view.size.height - 2);
  const Modifiers of_box{.shift = true, .ctrl = true};
  const auto drag_to_end = [&] {
    session_.selecting.selection.clear();
    input_.move({low, of_box});
    input_.press(MouseButton::left, {low, of_box});
    input_.move({high, of_box});
  };
  drag_to_end();
  input_.key_down("Alt");
  input_.release(MouseButton::left, {high, {.alt = true}});
  EXPECT_EQ(session_.selecting.selection.size(), session_.mesh().live().faces) << "through the surface";
  input_.key_up("Alt");
  frames(4);
  EXPECT_FALSE(gui_.has_menu(session_.layout));
  drag_to_end();
  input_.key_down("Alt");
  input_.key_up("Alt");
  input_.release(MouseButton::left, {high, {}});
  EXPECT_LT(session_.selecting.selection.size(), session_.mesh().live().faces);
  frames(4);
  EXPECT_FALSE(gui_.has_menu(session_.layout));
  input_.key("Alt");
  frames(4);
  EXPECT_TRUE(gui_.has_menu(session_.layout)) << "alone it does";
}

TEST_F(WindowInputTest, the_blender_preset_has_the_keys_of_selecting_and_hiding) {
  ASSERT_TRUE(session_.run("preset blender").done());
  ASSERT_TRUE(session_.run("select f0").done());
  const auto press_key = [&](const char* chord) {
    input_.key_down(chord);
    input_.key_up(chord);
    return session_.selecting.selection.size();
  };
  const std::size_t all = session_.mesh().live().faces;
  const std::size_t grown = press_key("Ctrl++");
  EXPECT_GT(grown, 1u);
  EXPECT_EQ(press_key("Ctrl+-"), 1u);
  EXPECT_EQ(press_key("Ctrl+I"), all - 1);
  press_key("H");
  EXPECT_FALSE(session_.findings().hidden().empty());
  press_key("Alt+H");
  EXPECT_TRUE(session_.findings().hidden().empty());
  for (const char* const chord : {"L", "Ctrl+L"}) {
    ASSERT_TRUE(session_.run("select f0").done());
    EXPECT_EQ(press_key(chord), all) << chord;
  }
}

TEST_F(WindowInputTest, a_band_is_given_up_by_escape) {
  const glm::dvec2 at = session_.view.origin + glm::dvec2(20);
  input_.press(MouseButton::left, {at, {.shift = true, .ctrl = true}});
  input_.move({at + glm::dvec2(200), {}});
  ASSERT_TRUE(session_.view.band);
  input_.key("Escape");
  input_.move({at + glm::dvec2(300), {}});
  input_.release(MouseButton::left, {at + glm::dvec2(300), {}});
  EXPECT_TRUE(session_.selecting.selection.empty());
  EXPECT_FALSE(session_.view.band);
}

TEST_F(WindowInputTest, presets_change_drags_and_keys_but_scripts_keep_their_own) {
  ASSERT_TRUE(session_.run("preset blender").done());
  input_.key_down("Shift+S");
  EXPECT_EQ(session_.selecting.tool, "swap");
  session_.run("tool none");
  EXPECT_EQ(find_key("Shift+S", input_presets()[1])->command, "tool swap");
  for (const InputPreset& preset : input_presets()) {
    std::set<std::string> chords;
    for (const KeyRow& row : key_table(preset)) {
      EXPECT_TRUE(chords.insert(row.chord).second) << preset.id << " " << row.chord;
      EXPECT_TRUE(call_of(row.command)) << row.command;
    }
    for (const MouseButton button : {MouseButton::left, MouseButton::right, MouseButton::middle})
      drag_action_of(preset, button, {.shift = true, .ctrl = true, .alt = true});
  }
}

TEST_F(WindowInputTest, what_was_under_the_pointer_is_lit_no_more_when_it_is_on_a_panel) {
  input_.move({in_view});
  ASSERT_TRUE(session_.selecting.hover());
  input_.move({on_panel_});  // at once, as it can
  EXPECT_FALSE(session_.selecting.hover());

  ASSERT_TRUE(session_.run("select f0").done());
  ASSERT_TRUE(session_.run("gizmo move").done());
  const auto gizmo = session_.pointing.gizmo();
  ASSERT_TRUE(gizmo);
  for (int y = 0; y < window.height && !session_.pointing.pointed_handle(); y += 6)
    for (int x = 0; x < window.width && !session_.pointing.pointed_handle(); x += 6)
      input_.move({{static_cast<double>(x), static_cast<double>(y)}});
  ASSERT_TRUE(session_.pointing.pointed_handle());
  input_.move({on_panel_});
  EXPECT_FALSE(session_.pointing.pointed_handle());
}

TEST_F(WindowInputTest, the_status_line_names_the_only_button_that_orbits) {
  for (const InputPreset& preset : input_presets()) {
    ASSERT_TRUE(session_.run("preset " + std::string(preset.id)).done());
    frames(2);
    EXPECT_GE(test::DrawnText(gui_).count("ragorbit"), 1u) << preset.id;
  }
}

TEST_F(WindowInputTest, a_right_click_selects_and_opens_the_menu_of_the_element) {
  session_.run("mode face");
  const glm::dvec2 middle = in_view;
  const auto face = session_.pointing.pick(middle, PickMode::face);
  ASSERT_TRUE(face);
  input_.press(MouseButton::right, {middle, {}});
  input_.release(MouseButton::right, {middle, {}});
  EXPECT_EQ(session_.selecting.selection, (std::vector<Element>{face->element}));
  frames(4);
  EXPECT_TRUE(gui_.owns_pointer(session_.layout, test::window, middle)) << "the menu is open";
  // Its first entries are operators.
  const std::size_t before = session_.document().history().size();
  for (double y = 100; y < 700 && session_.document().history().size() == before; y += 8) {
    input_.press(MouseButton::right, {middle, {}});
    input_.release(MouseButton::right, {middle, {}});
    frames(4);
    const Pointer entry{{middle.x + 30, y}, {}};
    input_.press(MouseButton::left, entry);
    frames(2);
    input_.release(MouseButton::left, entry);
    frames(4);
  }
  EXPECT_GT(session_.document().history().size(), before);
}

TEST_F(WindowInputTest, a_menu_takes_the_keys_and_escape_closes_it) {
  session_.run("mode face");
  press(in_view, MouseButton::right);
  release(in_view, MouseButton::right);
  frames(4);
  ASSERT_EQ(session_.selecting.selection.size(), 1u);
  ASSERT_TRUE(gui_.has_menu(session_.layout));
  input_.key_down("X");
  EXPECT_TRUE(session_.log().empty()) << "nothing behind the menu is deleted";
  input_.key_down("Escape");
  frames(4);
  EXPECT_FALSE(gui_.has_menu(session_.layout));
  EXPECT_EQ(session_.selecting.selection.size(), 1u) << "one step at a time";
}

TEST_F(WindowInputTest, a_key_of_ones_own_asks_before_edits_are_lost) {
  session_.run("split 0-1");
  const std::uint32_t vertices = session_.mesh().live().vertices;
  for (const std::string& command :
       std::vector<std::string>{"new", "start", "open " + test::asset("cube.obj"), "reload"}) {
    session_.run("bind Ctrl+K " + command);
    input_.key_down("Ctrl+K");
    frames(3);
    EXPECT_EQ(session_.mesh().live().vertices, vertices) << command;
    EXPECT_EQ(session_.layout.open_panel, panel_opened_by(PanelOpener::loss).id) << command;
    session_.run("panel none");
    frames(2);
  }
}

}  // namespace
}  // namespace ryosen
