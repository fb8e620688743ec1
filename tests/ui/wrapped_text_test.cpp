// Where lines end within a panel.
#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "app/editor/session/session.h"
#include "app/ui/widgets.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class WrappedText : public testing::Test, protected test::Laid {
 protected:
  WrappedText() : Laid("cube.obj") {
    EXPECT_TRUE(session.run("language ja").done());
    frames(3);
  }
  static float width(const char* text) { return std::ceil(ImGui::CalcTextSize(text).x); }
  static long lines(const char* text, float width_px) {
    return std::lround((wrapped_size(text, width_px).y + ImGui::GetStyle().ItemSpacing.y) /
                       ImGui::GetTextLineHeightWithSpacing());
  }
};

// Latin letters that kanji follow without a blank are no reason to begin a new line.
TEST_F(WrappedText, fills_lines_of_kanji_with_latin_letters_between_them) {
  const float room = width("稜線を消すには C（稜線削除）か D（辺細分）を押し");
  EXPECT_EQ(lines("稜線を消すには C（稜線削除）か D（辺細分）を押し、稜線を指すと結果が見えます", room), 2);
}

TEST_F(WrappedText, ends_no_line_with_a_bracket_that_opens) {
  const float room = width("稜線を消す（");
  EXPECT_EQ(wrapped_size("稜線を消す（削除）", room).x, ImGui::CalcTextSize("稜線を消す").x) << "the bracket goes on";
}

TEST_F(WrappedText, begins_no_line_with_a_mark_that_closes) {
  for (const std::string mark : {"°、", "%、", "ー", "っ", "ァ", "：", "。"}) {
    const std::string rest = "30" + mark + "と";
    EXPECT_LE(wrapped_size(("角度は " + rest).c_str(), width("角度は 30")).x,
              std::max(width("角度は "), width(rest.c_str())))
        << rest << ": the number goes on with its mark";
  }
}

TEST_F(WrappedText, ends_no_line_behind_the_point_of_a_number_where_no_blank_is_before) {
  const float room = width("平均は0.00000");
  EXPECT_EQ(wrapped_size("平均は0.000000です", room).x, width("0.000000です"));
  EXPECT_EQ(lines("平均は0.000000です", room), 2);
}

TEST_F(WrappedText, leaves_latin_words_whole) {
  EXPECT_EQ(wrapped_size("平均曲率 1073.84、平均", width("平均曲率 1073.84")).x, width("1073.84、平均"))
      << "a number is not cut where a line may not begin behind it";
  EXPECT_EQ(wrapped_size("稜線 collapse 削除", width("稜線 colla")).x, ImGui::CalcTextSize("collapse").x);
  EXPECT_EQ(lines("one two three", width("one two")), 2);
}

// Also where no blank is before them and one behind, and a chord goes on below behind its plus.
TEST_F(WrappedText, leaves_the_names_of_keys_whole) {
  EXPECT_EQ(wrapped_size("ボックスで選択（Alt で裏側も）", width("ボックスで選択（Al")).x, width("（Alt で裏側も）"));
  EXPECT_EQ(wrapped_size("選択（Alt", width("選択（Al")).x, width("（Alt"));
  EXPECT_EQ(wrapped_size("Ctrl+Shift+左", width("Ctrl+Shi")).x, width("Shift+"));
}

TEST_F(WrappedText, parts_alternatives_behind_their_bar) {
  const char* const text = "alpha|beta|gamma|delta";
  EXPECT_EQ(wrapped_size(text, width("alpha|beta|gam")).x, ImGui::CalcTextSize("gamma|delta").x);
  EXPECT_EQ(lines(text, width("alpha|beta|gam")), 2);
}

}  // namespace
}  // namespace ryosen
