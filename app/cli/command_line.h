// Parsing of the program's arguments by the table of commands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/subcommand_table.h"

namespace ryosen::cli {

struct CommandLine {
  std::optional<Subcommand> command;
  Arguments arguments;
  Console console;  // set as far as possible even on failure
  std::optional<Failure> failure;
  bool wants_help = false;
};

// Common flags may precede the command, all flags may occur anywhere after it; `--` ends them. `--flag=value` and
// `--flag value` are the same.
CommandLine read_command_line(const std::vector<std::string>& arguments);

}  // namespace ryosen::cli
