// What happened to a window, as it was when it happened.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/input/input.h"

namespace ryosen {

struct WindowEvent {
  enum class Kind { resized, focused, unfocused, close_asked, moved, left, button, wheel, key, character, dropped };
  enum class Way { down, again, up };

  Kind kind;
  Pointer at = {};  // where the pointer was by then, and what was held down
  MouseButton button = MouseButton::left;
  Way way = Way::down;  // of a button or a key
  double steps = 0;     // of the wheel
  std::string chord = {};
  unsigned character = 0;
  std::filesystem::path path = {};
};

}  // namespace ryosen
