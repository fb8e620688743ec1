#include "app/editor/input/input.h"

#include <algorithm>
#include <iterator>

#include "ryosen/base/split_list.h"

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

namespace {

bool is_key_name(std::string_view key) {
  if (std::find(std::begin(panel_keys), std::end(panel_keys), key) != std::end(panel_keys)) return true;
  if (key == lone_key) return true;
  if (key.size() == 1)
    return (key[0] >= 'A' && key[0] <= 'Z') || (key[0] >= '0' && key[0] <= '9') || key == "." || key == "+" ||
           key == "-";
  for (int i = 0; i <= 12; ++i)
    if ((i > 0 && key == "F" + std::to_string(i)) || (i < 10 && key == "Numpad" + std::to_string(i))) return true;
  return false;
}

}  // namespace

std::optional<std::string> chord_from(std::string_view text) {
  const std::string_view key = key_of(text);
  const std::size_t before = text.size() - key.size();
  if (!is_key_name(key) || (before > 0 && !find_modifiers(text.substr(0, before - 1)))) return std::nullopt;
  const Modifiers held = modifiers_of(text);
  return (held.ctrl ? "Ctrl+" : "") + std::string(held.alt ? "Alt+" : "") + (held.shift ? "Shift+" : "") +
         std::string(key);
}

std::optional<MouseButton> find_button(std::string_view word) {
  if (word == "left") return MouseButton::left;
  if (word == "right") return MouseButton::right;
  if (word == "middle") return MouseButton::middle;
  return std::nullopt;
}

}  // namespace ryosen
