// Functions of the commands of the source texts, for the table of commands.
#pragma once

#include <string>

#include "app/editor/commands/command_functions.h"

namespace ryosen {

// Exercises and figures
RunCommand run_exercise;
RunOn<Document, Framing> run_figure;
FaultOfCommand fault_of_exercise, fault_of_figure;
// Playing step by step
RunCommand run_steps;
FaultOfCommand fault_of_steps;
std::string steps_syntax();

}  // namespace ryosen
