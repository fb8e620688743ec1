// The table of commands: what a script line, a key, a menu entry or a click may say. Operators and algorithms are
// commands too, read from their own tables. A command that changes the mesh itself sends an operator or an algorithm to
// the document (Document::apply, Document::run), each one entry of the history; what it needs beyond those is written
// as one.
//
// Who has to know what a command does asks its row: the log, autosave and recovery for its effect, the window whether
// it takes long or looks at the window itself, the guards of files which one it reads or writes, the check of a script
// what is wrong with its arguments.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/commands/text/command.h"
#include "app/editor/commands/text/outcomes.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/owners.h"
#include "app/editor/shown/shown.h"
#include "ryosen/algo/algorithm.h"
#include "ryosen/algo/repair/report.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/document/document.h"
#include "ryosen/scene/selection/selectors.h"

namespace ryosen {

class RepairTrials;
class Session;

// What a command does with the file that its arguments name: one whose effect is to write the document writes a mesh,
// any other a picture; `writes_part` is a mesh that does
// not become the document's.
enum class FileAccess { none, reads, writes, writes_part };

// A call of a command that has a name of its own, as a menu shows it.
struct NamedCall {
  std::string_view line, en, ja;
};

struct CommandRow {
  std::string_view id;
  std::string syntax;
  std::string_view help_en, help_ja;
  Effect effect;  // with most words; effect_of() knows those of a call
  // Does it; `whole` is all of the text behind the id. What it performed is the line that does the same; for one that
  // edits or steps, where it is left empty, the line that was said.
  OnOwners<Outcome(Session&, Words arguments, std::string_view whole)> run;

  std::string_view aliases = "";                     // further ids, separated by blanks
  bool is_long = false;                              // may take long: the window first shows that it is at work
  bool (*may_take_long)(Words arguments) = nullptr;  // the same with these arguments
  bool prepares_edits = false;                       // in the log it says what the next line works on
  bool reads_again = false;                          // replaces the mesh by what is in its file now
  bool sees_window = false;  // looks at the window as it is drawn: first without the panel or menu that sent it
  FileAccess file = FileAccess::none;
  // What is wrong with arguments that no mesh and no file can make right. Without it the line is tried on an empty
  // session, so a command has one that touches anything outside of its session, or that needs a mesh or its elements.
  std::function<std::optional<Text>(Words arguments, const std::string& line)> fault = {};
  // With these arguments it only tells something: it needs no element, and is not long.
  bool (*only_tells)(Words arguments) = nullptr;
  // It works on `selected`, or on so many elements of any kind that are named, or pointed at; 0: on none.
  std::size_t most_elements = 0;
  // The line that it sends, where it stands for another one; empty where there is none.
  std::string (*sends)(Words arguments) = nullptr;
  std::string (*ids)() = nullptr;  // what ID in the syntax stands for, where the help names it
  std::vector<NamedCall> named = {};
};

// The effect with these words.
Effect effect_of(const CommandRow& row, Words arguments);

// All commands: operators, those of the editor, and algorithms. A row stays where it is as long as the program runs, or
// its ScopedCommand.
std::vector<const CommandRow*> command_table();
// The row with this id or alias; null if there is none. Copies nothing.
const CommandRow* find_command_row(std::string_view id);
// The row of a command; null where its line has none.
const CommandRow* row_of(const Command& command);
// As the window calls it: an operator or an algorithm by its name, others by their id.
Text name_of_command(std::string_view id);
// The same of a line, which may be a call that has a name of its own.
Text name_of_line(std::string_view line);

// The help, with the ids behind it that the row lists.
std::string help_of(const CommandRow& row, Language language);

// A line as its row sees it.
struct CommandCall {
  const CommandRow* row;
  Effect effect;     // with these arguments
  bool is_long;      // with these arguments
  std::string line;  // what is done: what a key sends, in place of the line that presses it
};
// None where the line says no command.
std::optional<CommandCall> call_of(std::string_view line);
// The same of a command; the call of a value has no line.
std::optional<CommandCall> call_of_command(const Command& command);
// The name of the file that a call reads or writes; empty where it gives none: a mesh goes to the document's own then,
// a picture to one that is not there yet.
std::string file_of(const CommandCall& call);

// Runs an algorithm, whose line this is; the word for the selection means what is selected now.
Outcome run_algorithm(Session& session, AlgorithmCall call, std::string line);

// What a line of `repair` without a fault would do; null while that is being tried.
const RepairReport* tried(const Document& document, RepairTrials& trials, const std::string& line);

// A further row for its life: for tests, and for programs that embed the editor. The last one made ends first. Not
// while anything else reads the table.
class ScopedCommand {
 public:
  explicit ScopedCommand(CommandRow row);
  ~ScopedCommand();
  ScopedCommand(const ScopedCommand&) = delete;
  ScopedCommand& operator=(const ScopedCommand&) = delete;
};

// All ids, operators and their aliases included: for "did you mean".
std::vector<std::string> command_ids();
// Not a command: usage, with the closest id or alias named.
Outcome unknown_command(std::string_view id);
// The same of a word in the place of an operator.
Text not_an_operator(std::string_view word);

}  // namespace ryosen
