// The command line: finds the command, runs it, and turns whatever happens into an exit code.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace ryosen::cli {

// `arguments` are those after the program's name. Throws nothing; what goes wrong inside ends with internal_error.
ExitCode run(const std::vector<std::string>& arguments) noexcept;

}  // namespace ryosen::cli
