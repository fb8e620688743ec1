// Checks of a command's output files before anything runs.
#pragma once

#include <optional>
#include <string>

#include "app/cli/subcommand_table.h"
#include "app/editor/document/run_files.h"

namespace ryosen::cli {

// The files of a run that begins with this input, or with none where it is empty; --overwrite is heeded.
RunFiles files_of_run(const Arguments& arguments, const std::string& input);

// Refuses a name that does not tell the format. A pipe, a device or standard output without an extension gets the
// format of the input, if `has_input`.
std::optional<Failure> fault_of_output(const std::string& path, bool has_input);

}  // namespace ryosen::cli
