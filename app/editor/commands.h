// The table of commands: what a script line, a key, a menu entry or a click may say. Operators are commands too, read
// from their own list.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/session.h"

namespace ryosen {

struct CommandRow {
  std::string_view id;
  std::string_view syntax;
  std::string_view help_en, help_ja;
  bool changes_mesh;  // undo, redo, open: goes into the log even where it is not an operator
  Outcome (*run)(Session& session, std::span<const std::string_view> arguments, std::string_view whole);
  std::string (*ids)() = nullptr;  // what ID in the syntax stands for, where the help names it
};

std::span<const CommandRow> command_table();
const CommandRow* find_command_row(std::string_view id);
// The help, with the ids behind it that the row lists.
std::string help_of(const CommandRow& row, Language language);

// All ids, operators and their aliases included: for "did you mean".
std::vector<std::string> command_ids();
// Not a command: usage, with the closest id or alias named.
Outcome unknown_command(std::string_view id);
// The same of a word in the place of an operator.
Text not_an_operator(std::string_view word);
Outcome usage_error(std::string en, std::string ja);
// An operator's line names no element of the mesh, with this error: a refusal by the rule `deleted` where the element
// stands at another place of the history, else usage; with a sentence that says which, and of faces that were set aside.
Outcome no_element(Document& document, std::string_view line, NameError error, const Text& sentence);

}  // namespace ryosen
