// Events of mouse and keyboard, and what takes them: a window with panels, or the view alone. Windows, scripts and
// tests send the same ones.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "ryosen/document/document.h"

namespace ryosen {

class Session;

enum class MouseButton { left, right, middle };  // as numbered by GLFW and ImGui

struct Modifiers {
  bool shift = false, ctrl = false, alt = false;
};

// Where the pointer is, from the upper left corner of the window or picture, and what is held down meanwhile.
struct Pointer {
  glm::dvec2 pixel{0};
  Modifiers modifiers = {};
  double now_s = 0;  // stands still in scripts: two clicks at one place are a double click there
};

class Input {
 public:
  virtual ~Input() = default;

  virtual void press(MouseButton button, const Pointer& at) = 0;
  // What the click did that has ended; done where there was none.
  virtual Outcome release(MouseButton button, const Pointer& at) = 0;
  virtual void move(const Pointer& at) = 0;
  virtual void wheel(double steps, const Pointer& at) = 0;
  // A key is pressed and let go, by its chord: "Ctrl+Z", "Enter". What its command did.
  virtual Outcome key(const std::string& chord) = 0;
  // Text in UTF-8 for the field that has the keyboard; fails where none has.
  virtual Outcome type(std::string_view text) = 0;
};

// Events of a view without panels, in the hands of its navigation.
std::unique_ptr<Input> make_view_input(Session& session);

// "Ctrl+Shift" as in chords; none for anything else.
std::optional<Modifiers> find_modifiers(std::string_view text);
// The parts of a chord, which may end with the key +; what stands before the key in vain is no modifier.
std::string_view key_of(std::string_view chord);
Modifiers modifiers_of(std::string_view chord);
// The keys that edit text or walk through panels, whatever else they are bound to; and whether a chord is with one.
inline constexpr std::string_view panel_keys[] = {
    "Tab",    "Left",  "Right",  "Up",       "Down", "Home", "End", "Delete", "Backspace", "Enter",
    "Escape", "Space", "PageUp", "PageDown", "A",    "C",    "V",   "X",      "Y",         "Z"};
bool is_panel_key(std::string_view chord);
// The modifier that is a key too: pressed and let go alone.
inline constexpr std::string_view lone_key = "Alt";
// A chord as keys are bound to it, its modifiers in their usual order; none where the text is no chord of a key that a
// window can tell.
std::optional<std::string> chord_from(std::string_view text);
std::optional<MouseButton> find_button(std::string_view word);

}  // namespace ryosen
