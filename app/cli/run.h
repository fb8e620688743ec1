// Entry point of the command line: finds the command, runs it, and maps the result to an exit code.
#pragma once

#include <string>
#include <vector>

#include "ryosen/base/result.h"

namespace ryosen::cli {

// `arguments` are those after the program's name. Exceptions end with internal_error.
ExitCode run(const std::vector<std::string>& arguments) noexcept;

}  // namespace ryosen::cli
