// The table of key bindings. F1, menus, tooltips and `ryosen keys` read it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ryosen {

struct KeyRow {
  std::string chord;    // "Ctrl+Z", "C", "Home", "Left", "Numpad1"
  std::string command;  // the command line it sends
  std::string_view help_en, help_ja;
  // Also while a panel lies over the view, or text is typed.
  bool acts_always = false;
  bool repeats = false;  // while it is held down
};

// The keys of operators, selectors, views and switches come from their own rows.
std::vector<KeyRow> key_table();
// By chord; none if unbound.
std::optional<KeyRow> find_key(std::string_view chord);

}  // namespace ryosen
