// The table of key bindings. F1, menus, tooltips and `ryosen keys` read it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/input/input_presets.h"
#include "ryosen/base/message.h"

namespace ryosen {

struct OpInfo;

// The menu that has an entry for what a key does too.
enum class KeyMenu { none, edit, select };

struct KeyRow {
  std::string chord;    // "Ctrl+Z", "C", "Home", "Left", "Numpad1"
  std::string command;  // the command line it sends
  std::string_view help_en, help_ja;
  // Also while a panel lies over the view, or text is typed.
  bool acts_always = false;
  bool repeats = false;  // while it is held down
  KeyMenu menu = KeyMenu::none;
  std::string_view menu_en = "", menu_ja = "";
};

// The keys of operators, selectors, views and switches come from their own rows; other presets than the first change
// some, and the user's own bindings stand above all.
std::vector<KeyRow> key_table(const InputPreset& preset = input_presets()[0], std::span<const KeyBinding> own = {});
// By chord; none if unbound.
std::optional<KeyRow> find_key(std::string_view chord, const InputPreset& preset = input_presets()[0],
                               std::span<const KeyBinding> own = {});
// What had a key in the preset and has none any more because of these bindings: rows without a chord.
std::vector<KeyRow> rows_without_key(const InputPreset& preset, std::span<const KeyBinding> own);
// What the key of an operator sends: its tool, or itself where it has no target.
std::string line_of_key(const OpInfo& op);
// What a key does in words: those of its row, else the help of its command.
Text help_of_key(const KeyRow& row);

}  // namespace ryosen
