// What can be said against a file that a command is to write, before anything runs.
#pragma once

#include <optional>
#include <string>

#include "app/cli/subcommand_table.h"
#include "app/editor/run_files.h"

namespace ryosen::cli {

// The files of a run that begins with this input, or with none where it is empty; --overwrite is heeded.
RunFiles files_of_run(const Arguments& arguments, const std::string& input);

// A name that does not say in which format to write. What is no file (a pipe, a device, standard output) gets the format
// of the input where its name says none, if `has_input`.
std::optional<Failure> fault_of_output(const std::string& path, bool has_input);

}  // namespace ryosen::cli
