// The dialog of preferences, and keys that are bound by pressing them.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "app/ui/window_input.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class PreferencesPanelTest : public testing::Test, protected test::Laid {
 protected:
  PreferencesPanelTest() : Laid("cube.obj", {1280, 800}) { input_.resize(size_); }
  glm::dvec2 place(std::string_view text) const { return test::DrawnText(gui).place(text); }
  void open(const std::string& panel) {
    ASSERT_TRUE(gui.run(session, "panel " + panel).done());
    frames(4);
  }
  void key(const std::string& chord) {
    input_.key(chord);
    frames(3);
  }

  WindowInput input_{gui, session, [this] { frames(1); }};
};

TEST_F(PreferencesPanelTest, sets_and_resets) {
  open("preferences");
  const glm::dvec2 scale = place("Scale");
  click({scale.x + 300, scale.y});
  for (const char* const pressed : {"End", "Backspace"}) key(pressed);
  ASSERT_TRUE(input_.type("2").done());
  key("Enter");
  EXPECT_EQ(session.preferences.ui_scale, 2);
  ASSERT_TRUE(gui.run(session, "prefer theme light").done());
  frames(4);
  click(place("Resetall"));
  frames(3);
  EXPECT_EQ(session.preferences.ui_scale, 1);
  EXPECT_EQ(session.view.settings.theme, Theme::dark);
}

TEST_F(PreferencesPanelTest, keeps_a_wrong_value_in_the_field_with_the_reason) {
  open("preferences");
  const glm::dvec2 font = place("Fontsize");
  click({font.x + 300, font.y});
  ASSERT_TRUE(input_.type("99").done());
  key("Enter");
  EXPECT_EQ(session.preferences.font_size_px, 15);
  EXPECT_EQ(test::DrawnText(gui).count("10to32"), 1u);
}

TEST_F(PreferencesPanelTest, larger_letters_and_scales_cut_no_text) {
  for (const char* const line : {"prefer font_size 20", "prefer scale 1.3", "language ja"}) {
    ASSERT_TRUE(gui.run(session, line).done());
    open("preferences");
    const test::DrawnText text(gui);
    EXPECT_EQ(text.cut_sideways(), "") << line;
    EXPECT_EQ(text.overlapping(), "") << line;
  }
}

TEST_F(PreferencesPanelTest, keys_and_what_the_mouse_does_are_found_by_any_word_in_either_language) {
  const auto found = [&](const char* typed, const char* language) {
    EXPECT_TRUE(gui.run(session, "panel none").done());
    frames(2);
    EXPECT_TRUE(gui.run(session, std::string("language ") + language).done());
    open("keys");
    EXPECT_TRUE(input_.type(typed).done()) << "the field has the keyboard at once";
    frames(3);
    return test::DrawnText(gui);
  };
  EXPECT_EQ(found("pick vert", "en").count("pick vertices"), 1u);
  EXPECT_EQ(test::DrawnText(gui).count("pick edges"), 0u);
  EXPECT_EQ(found("orbit", "en").count("left drag"), 1u) << "of the mouse";
  EXPECT_EQ(found("Ctrl+Z", "en").count("Ctrl+Z"), 2u) << "what was typed, and its row";
  EXPECT_EQ(found("頂点", "en").count("pick vertices"), 1u);
  EXPECT_EQ(found("vertices", "ja").count("1??"), 1u);
  EXPECT_EQ(found("no such word", "en").count("Nothing is found by these words."), 1u);
  EXPECT_EQ(found("zzz", "en").count("left drag"), 0u);
}

// The keys and the mouse scroll together.
TEST_F(PreferencesPanelTest, the_keys_are_one_list) {
  open("keys");
  const auto mouse = [&] { return place("left drag"); };
  const glm::dvec2 before = mouse(), key = place("pick vertices");
  gui.pointer(key);
  frames(2);
  gui.wheel(-1);
  frames(4);
  EXPECT_LT(mouse().y, before.y - 10);
  EXPECT_LT(place("pick vertices").y, key.y - 10);
}

TEST_F(PreferencesPanelTest, a_key_is_bound_by_pressing_it) {
  open("keys");
  click(place("pickvertices") - glm::dvec2(110, 0));
  EXPECT_EQ(test::DrawnText(gui).count("Pressthenewkeyfor:pickvertices"), 1u);
  key("Ctrl+K");
  const std::vector<KeyBinding> own{{"1", ""}, {"Ctrl+K", "mode vertex"}};
  EXPECT_EQ(session.preferences.bindings, own);
  key("Escape");
  key("Ctrl+K");
  EXPECT_EQ(session.selecting.mode, PickMode::vertex);
}

TEST_F(PreferencesPanelTest, a_key_that_is_taken_is_asked_about_with_both_names) {
  open("keys");
  click(place("pickvertices") - glm::dvec2(110, 0));
  key("2");
  EXPECT_EQ(test::DrawnText(gui).count("2does'pickedges'already.Isittodo'pickvertices'?"), 1u);
  EXPECT_TRUE(session.preferences.bindings.empty()) << "nothing is bound unasked";
  click(place("Swapthetwo"));
  frames(3);
  const auto& preset = input_presets()[0];
  EXPECT_EQ(find_key("2", preset, session.preferences.bindings)->help_en, "pick vertices");
  EXPECT_EQ(find_key("1", preset, session.preferences.bindings)->help_en, "pick edges");
  click(place("Resetkeys"));
  frames(3);
  EXPECT_TRUE(session.preferences.bindings.empty());
}

TEST_F(PreferencesPanelTest, escape_leaves_a_key_as_it_is) {
  open("keys");
  click(place("pickvertices") - glm::dvec2(110, 0));
  key("Escape");
  EXPECT_EQ(session.layout.open_panel, "keys") << "it only ends the question";
  EXPECT_TRUE(session.preferences.bindings.empty());
}

}  // namespace
}  // namespace ryosen
