// The command palette: everything that a menu, a key or a script line can do, found by any of its words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/editor/commands/commands.h"

namespace ryosen {

class Selecting;

class Findings;

struct PaletteEntry {
  std::string line;  // what it says, without arguments that are not known yet
  Text name;         // as menus have it; where they have none, what it does in a few words
  Text help;         // may be empty
  std::string syntax;
};

// All entries: one per row of the tables of commands, operators, algorithms, switches, views, selectors, panels, colour
// maps and keys.
std::vector<PaletteEntry> palette_entries();

// The entries in which each word of what was typed is found, in either language, without regard to case; best first:
// whose name begins with it, one of whose words begins with it, others; of equals those first that the tables have
// first. Where a command with arguments is typed: its own, and those that go on as it was typed.
std::vector<PaletteEntry> find_in_palette(std::string_view typed);

// The help without the name that it begins with.
std::string beyond_name(const std::string& help, const std::string& name);

// What choosing an entry comes to.
struct PaletteChoice {
  enum class Kind {
    run,    // this line: nothing is missing, or what is selected is worked on, or what is missing is pointed at
    begin,  // this line is to be completed by typing
  };
  Kind kind;
  std::string line;
};
PaletteChoice choice_of(const Findings& findings, const Selecting& selecting, const PaletteEntry& entry);

}  // namespace ryosen
