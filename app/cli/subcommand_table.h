// The one table of the program's commands and their flags. Parsing, help and the tests of both read it; a command or
// flag that is not in it does not exist.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/contract/shape.h"
#include "core/base/result.h"

namespace ryosen::cli {

struct Flag {
  std::string_view name;   // with its dash or dashes
  std::string_view value;  // what stands behind it, in words; empty for a switch
  bool repeatable = false;
  std::string_view en, ja;
};

// What the user gave, checked against the row of the command.
class Arguments {
 public:
  const std::vector<std::string>& operands() const { return operands_; }
  bool has(std::string_view flag) const;
  // The value of a flag, or null when it was not given.
  const std::string* value(std::string_view flag) const;
  // All values of a repeatable flag, in order.
  std::vector<std::string> values(std::string_view flag) const;

  void add_operand(std::string operand) { operands_.push_back(std::move(operand)); }
  void add_flag(const Flag& flag, std::string value) { given_.push_back({&flag, std::move(value)}); }

 private:
  struct Given {
    const Flag* flag;
    std::string value;
  };
  std::vector<std::string> operands_;
  std::vector<Given> given_;
};

struct Subcommand {
  std::string_view id;
  std::string_view operands;  // as in the help
  std::size_t least_operands, most_operands;
  std::string_view en, ja;        // one line
  std::vector<Flag> flags;        // besides the common ones
  std::string (*more)(Language);  // further lines of the help; may be null
  ExitCode (*run)(const Arguments& arguments, const Console& console);
  Contract contract = {};  // what it prints as JSON and ends with
};

std::span<const Subcommand> subcommands();
std::span<const Flag> common_flags();
const Subcommand* find_subcommand(std::string_view id);

}  // namespace ryosen::cli
