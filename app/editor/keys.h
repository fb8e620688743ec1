// The table of key bindings. F1, menus, tooltips and `ryosen keys` read it.
#pragma once

#include <span>
#include <string_view>

namespace ryosen {

struct KeyRow {
  std::string_view chord;    // "Ctrl+Z", "C", "Home", "Left", "Numpad1"
  std::string_view command;  // the command line it sends
  std::string_view help_en, help_ja;
};

std::span<const KeyRow> key_table();
// By chord; null if unbound.
const KeyRow* find_key(std::string_view chord);

}  // namespace ryosen
