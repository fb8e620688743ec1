// The rows of commands that no other table has.
#pragma once

#include <vector>

#include "app/editor/commands/command_functions.h"

namespace ryosen {

// Rows before the switches of the view, and rows behind them.
const std::vector<CommandRow>& first_command_rows();
const std::vector<CommandRow>& last_command_rows();

}  // namespace ryosen
