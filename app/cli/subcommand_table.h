// The table of the program's commands and their flags. Parsing, help and their tests are driven by it; a command or
// flag that is not in it does not exist.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/contract/shape.h"
#include "ryosen/algo/algorithm.h"
#include "ryosen/base/result.h"

namespace ryosen::cli {

struct Flag {
  std::string name;   // including its dashes
  std::string value;  // description of its value; empty for a switch, in [] where it may be left out
  bool repeatable = false;
  std::string en, ja;
  bool replaces_operand = false;

  // Such a value is one of the words in the brackets; given without one it is empty.
  bool may_lack_value() const { return value.starts_with('['); }
};

// The user's arguments, checked against the row of the command.
class Arguments {
 public:
  const std::vector<std::string>& operands() const { return operands_; }
  bool has(std::string_view flag) const;
  // The value of a flag, or null if not given.
  const std::string* value(std::string_view flag) const;
  // All values of a repeatable flag, in order.
  std::vector<std::string> values(std::string_view flag) const;

  void add_operand(std::string operand) { operands_.push_back(std::move(operand)); }
  void add_flag(const Flag& flag, std::string value) { given_.push_back({flag.name, std::move(value)}); }

 private:
  struct Given {
    std::string flag;
    std::string value;
  };
  std::vector<std::string> operands_;
  std::vector<Given> given_;
};

// A whole number within these bounds, written as digits alone; none for anything else.
std::optional<std::uint64_t> whole_number(std::string_view word, std::uint64_t least, std::uint64_t most);

struct Subcommand {
  std::string_view id;
  std::string_view operands;  // as in the help: words with a blank between them, one that may be left out in [], the
                              // last with ... where there may be several
  std::string_view en, ja;    // one line
  std::function<ExitCode(const Arguments& arguments, const Console& console)> run;
  Contract contract;                                    // what it prints as JSON and ends with
  std::vector<Flag> flags = {};                         // besides the common ones
  std::function<std::string(Language)> more = nullptr;  // further lines of the help; may be empty
  bool operand_is_command = false;
  bool is_window = false;     // runs until it is closed
  bool is_algorithm = false;  // made of its row in the table of algorithms

  std::size_t least_operands() const;
  std::size_t most_operands() const;
};

// Those of the program, then the algorithms.
std::vector<Subcommand> subcommands();
std::span<const Flag> common_flags();
std::optional<Subcommand> find_subcommand(std::string_view id);

// The commands, one file each. Their arguments have been checked against their row of the table.
using RunCommand = ExitCode(const Arguments& arguments, const Console& console);
RunCommand check_command, why_command, edit_command, convert_command, view_command, repair_command, shot_command,
    hull_command, measure_command, steps_command, distance_command, forms_command, practice_command, formats_command,
    keys_command, doctor_command, help_command, version_command;
ExitCode algorithm_command(const AlgorithmRow& row, const Arguments& arguments, const Console& console);

// The help of one command, or of the program.
ExitCode show_help(const std::optional<Subcommand>& command, const Console& console);

}  // namespace ryosen::cli
