// The table of key bindings. F1, menus, tooltips and `ryosen keys` read it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/gestures.h"

namespace ryosen {

struct KeyRow {
  std::string chord;    // "Ctrl+Z", "C", "Home", "Left", "Numpad1"
  std::string command;  // the command line it sends
  std::string_view help_en, help_ja;
  // Also while a panel lies over the view, or text is typed.
  bool acts_always = false;
  bool repeats = false;  // while it is held down
};

// The keys of operators, selectors, views and switches come from their own rows; other presets than the first change some.
std::vector<KeyRow> key_table(const InputPreset& preset = input_presets()[0]);
// By chord; none if unbound.
std::optional<KeyRow> find_key(std::string_view chord, const InputPreset& preset = input_presets()[0]);

}  // namespace ryosen
