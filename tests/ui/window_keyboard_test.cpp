// The keyboard of the real window: its layout, keys that are held, the clipboard, pictures one after the other.
#include <cstdlib>

#include "tests/support/app/window_hand.h"

namespace ryosen {
namespace {

using test::Frame;
using test::wait_for;
using test::words_of;

class WindowKeyboard : public test::WindowHand {
 protected:
  // Keys by their places: what xdotool calls by a number is the key with that code, whatever is written on it.
  static constexpr const char *key_3 = "12", *left_of_w = "24", *right_of_tab_below = "38", *left_of_x = "52";

  void set_layout(const char* layout) const {
    ASSERT_EQ(std::system(("DISPLAY=:" + number_ + " setxkbmap " + layout).c_str()), 0) << layout;
  }
  // "ctrl+24"
  static std::string with(const char* modifier, const char* key) { return std::string(modifier) + "+" + key; }
};

TEST_F(WindowKeyboard, letters_are_those_of_the_layout_and_digits_those_of_the_place) {
  if (!test::is_installed("setxkbmap")) GTEST_SKIP() << "setxkbmap is not installed; it comes with Xvfb";
  set_layout("fr");
  open_copy("torus.off");
  const glm::dvec2 at = on_face();
  const std::string add = " mousemove " + words_of(at) + " keydown shift click 1 keyup shift";
  xdotool(std::string("key ") + key_3 + " key " + right_of_tab_below + add);
  ASSERT_TRUE(has_selected(1)) << "where an A is on other keyboards a Q is";
  xdotool(std::string("key ") + left_of_w);
  ASSERT_TRUE(has_selected(96)) << "the A is where others have a Q";
  xdotool("key " + with("ctrl+shift", left_of_w));
  ASSERT_TRUE(has_selected(0)) << "with Ctrl and Shift too";
  for (const glm::dvec2 pixel : {at, on_a_face(1).pixel}) {
    xdotool("key ctrl+shift+a");
    click(pixel);
    xdotool("key x");
  }
  ASSERT_TRUE(has_faces(94));
  xdotool("key " + with("ctrl", left_of_x));
  xdotool(std::string("key ctrl+z key ctrl+shift+a key ") + left_of_w);
  ASSERT_TRUE(has_selected(95)) << "Ctrl and the key called Z, not the one at its place, undoes";
  xdotool("key ctrl+shift+a");
  set_layout("us");
  xdotool(std::string("key ") + right_of_tab_below);
  EXPECT_TRUE(has_selected(95)) << "with another layout, which was chosen meanwhile";
}

TEST_F(WindowKeyboard, undo_and_redo_repeat_while_they_are_held_and_pictures_count_up) {
  open_copy("torus.off");
  xdotool("mousemove 640 60 key 3 key a");
  ASSERT_TRUE(has_selected(96));
  std::string moves;
  constexpr long count = 5;
  for (long i = 0; i < count; ++i) moves += " key g key x key 1 key Return";
  xdotool(moves);
  ASSERT_TRUE(is_at(count));
  xdotool("keydown ctrl keydown z");
  const bool is_undone = is_at(0);
  xdotool("keyup z keyup ctrl");
  ASSERT_TRUE(is_undone) << "one press, which is held, undoes " << count - last().history << " of " << count;
  xdotool("keydown ctrl keydown y");
  const bool is_redone = is_at(count);
  xdotool("keyup y keyup ctrl");
  ASSERT_TRUE(is_redone);

  const auto picture = [&](const char* name) {
    const auto read = [&] { return current_.has(name) ? test::read_file(current_.at(name)) : std::string(); };
    EXPECT_TRUE(wait_for([&] { return read().ends_with("IEND\xae\x42\x60\x82"); })) << name << " is not there";
    return read();
  };
  xdotool("key F12");
  const std::string first = picture("ryosen.png");
  xdotool("key ctrl+z key F12");
  const std::string second = picture("ryosen-1.png");
  EXPECT_NE(first, second) << "what is drawn now";
  EXPECT_EQ(picture("ryosen.png"), first) << "the first one stays";
}

TEST_F(WindowKeyboard, what_is_copied_in_a_field_is_pasted_in_another_and_in_another_program) {
  open_copy("cube.obj");
  const auto has_panel = [&](const char* id) { return shows([id](const Frame& frame) { return frame.panel == id; }); };
  xdotool("mousemove 640 400 key ctrl+o");
  ASSERT_TRUE(has_panel("open"));
  xdotool("type --delay 20 'split 0-1'");
  xdotool("key ctrl+a key ctrl+c key Escape");
  ASSERT_TRUE(has_panel("-"));
  xdotool("key F3");
  ASSERT_TRUE(has_panel("command"));
  xdotool("key ctrl+v key Return");
  ASSERT_TRUE(is_at(1)) << "the field of commands got something else";

  const std::string other_file = folder_.copy(test::asset("torus.off"), "torus.off");
  const std::string before = test::read_file(other_file);
  const auto other = started(other_file, "frames of the other");
  const auto says = [&](const char* panel) {
    return wait_for([&] {
      const std::string log =
          folder_.has("frames of the other") ? test::read_file(folder_.at("frames of the other")) : "";
      return log.substr(log.rfind("frame ") == log.npos ? 0 : log.rfind("frame ")).find(panel) != log.npos;
    });
  };
  ASSERT_TRUE(says("panel -")) << "no picture appeared";
  xdotool("mousemove 641 400 key F3");
  ASSERT_TRUE(says("panel command")) << "it has not the keyboard";
  xdotool("key ctrl+v key Return");
  ASSERT_TRUE(says("history 1")) << "another program has not got it";
}

}  // namespace
}  // namespace ryosen
