#include "app/editor/input.h"

#include <algorithm>
#include <iterator>

#include "core/base/split_list.h"

namespace ryosen {

std::optional<Modifiers> find_modifiers(std::string_view text) {
  Modifiers held;
  for (const std::string_view word : split_list(text, '+')) {
    if (word == "Shift")
      held.shift = true;
    else if (word == "Ctrl")
      held.ctrl = true;
    else if (word == "Alt")
      held.alt = true;
    else
      return std::nullopt;
  }
  return held;
}

std::string_view key_of(std::string_view chord) {
  const std::size_t plus = chord.size() < 2 ? std::string_view::npos : chord.rfind('+', chord.size() - 2);
  return plus == std::string_view::npos ? chord : chord.substr(plus + 1);
}

Modifiers modifiers_of(std::string_view chord) {
  const std::size_t length = chord.size() - key_of(chord).size();
  return length == 0 ? Modifiers() : find_modifiers(chord.substr(0, length - 1)).value_or(Modifiers());
}

bool is_panel_key(std::string_view chord) {
  constexpr std::string_view keys[] = {"Tab",       "Left",  "Right",  "Up",    "Down",   "Home",   "End",
                                       "Backspace", "Enter", "Escape", "Space", "Delete", "PageUp", "PageDown",
                                       "A",         "C",     "V",      "X",     "Y",      "Z"};
  const std::size_t before = chord.size() - key_of(chord).size();
  return (before == 0 || find_modifiers(chord.substr(0, before - 1))) &&
         std::find(std::begin(keys), std::end(keys), key_of(chord)) != std::end(keys);
}

std::optional<MouseButton> find_button(std::string_view word) {
  if (word == "left") return MouseButton::left;
  if (word == "right") return MouseButton::right;
  if (word == "middle") return MouseButton::middle;
  return std::nullopt;
}

}  // namespace ryosen
