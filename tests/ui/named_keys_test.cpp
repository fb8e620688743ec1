// What panels say of keys and commands is what is in force, and all of it.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // its windows

#include "app/editor/session/session.h"
#include "app/ui/widgets.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;
using test::Laid;

TEST(tools_panel, shows_the_keys_that_are_in_force) {
  Laid laid("cube.obj");
  EXPECT_EQ(DrawnText(laid.gui).count("SSwapedge"), 1u);
  ASSERT_TRUE(laid.session.run("preset blender").done());
  laid.frames(3);
  EXPECT_EQ(DrawnText(laid.gui).count("Shift+SSwapedge"), 1u);
  ASSERT_TRUE(laid.session.run("preset ryosen").done());
  laid.session.preferences.bindings = {{"Ctrl+7", "tool swap"}, {"S", ""}};
  laid.frames(3);
  EXPECT_EQ(DrawnText(laid.gui).count("Ctrl+7Swapedge"), 1u);
}

TEST(command_panel, leaves_no_name_out_of_the_middle_of_a_word) {
  Laid laid("cube.obj");
  ASSERT_TRUE(laid.session.run("panel command").done());
  laid.frames(3);
  laid.gui.text("scale");
  laid.frames(4);
  EXPECT_GT(DrawnText(laid.gui).count("scalesvertices,everywhere"), 0u);
}

TEST(widgets, cut_a_text_at_a_word_and_a_word_anywhere) {
  Laid laid("cube.obj");
  const std::string words = "some words that are long", word = "a_name_of_a_file_without_blanks";
  const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  EXPECT_EQ(fitted_at_word(words, width(words)), words);
  EXPECT_EQ(fitted_at_word(words, width(words) - 1), "some words that are\u2026");
  EXPECT_LE(width(fitted_at_word(word, width(word) - 1)), width(word) - 1);
  EXPECT_TRUE(fitted_at_word(word, width(word) - 1).starts_with("a_name_of_a_file"));
}

TEST(command_panel, has_the_keyboard_after_a_click_beside_it) {
  Laid laid("cube.obj");
  ASSERT_TRUE(laid.session.run("panel command").done());
  laid.frames(3);
  laid.gui.text("gr");
  laid.frames(2);
  for (const glm::dvec2 beside : {glm::dvec2(60, 600), glm::dvec2(640, 206)}) {
    laid.click(beside);
    laid.frames(3);
    laid.gui.text("ow");
    laid.frames(3);
    EXPECT_TRUE(laid.gui.owns_keys()) << beside.x;
  }
  EXPECT_EQ(DrawnText(laid.gui).count("growow"), 1u);
}

TEST(command_panel, takes_a_name_where_the_word_alone_lacks_something) {
  Laid laid("cube.obj");
  ASSERT_TRUE(laid.session.run("panel command").done());
  laid.frames(3);
  laid.gui.text("move");
  laid.frames(3);
  laid.gui.key(ImGuiKey_Enter, true);
  laid.frames(4);
  EXPECT_EQ(laid.session.layout.open_panel, "values") << laid.gui.said().en;
  EXPECT_EQ(laid.session.layout.asked_algorithm, "translate");
}

TEST(history_panel, scrolls_to_the_entry_that_is_the_mesh) {
  Laid laid("cube.obj");
  for (int i = 1; i < 12; ++i) {
    ASSERT_TRUE(laid.session.run("move_vertex v0 0,0," + std::to_string(i)).done());
    laid.frames(4);
    const ImGuiWindow* entries = nullptr;
    for (const ImGuiWindow* const one : GImGui->Windows)
      if (one->Active && std::string_view(one->Name).find("/entries") != std::string_view::npos) entries = one;
    ASSERT_TRUE(entries);
    EXPECT_NEAR(entries->Scroll.y, static_cast<float>(std::max(i - 6, 0)) * ImGui::GetTextLineHeightWithSpacing(), 0.5f)
        << i;
  }
}

}  // namespace
}  // namespace ryosen
