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
  const std::size_t before = chord.size() - key_of(chord).size();
  return (before == 0 || find_modifiers(chord.substr(0, before - 1))) &&
         std::find(std::begin(panel_keys), std::end(panel_keys), key_of(chord)) != std::end(panel_keys);
}

std::optional<MouseButton> find_button(std::string_view word) {
  if (word == "left") return MouseButton::left;
  if (word == "right") return MouseButton::right;
  if (word == "middle") return MouseButton::middle;
  return std::nullopt;
}

}  // namespace ryosen
