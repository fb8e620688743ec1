// The files that the operands of a command name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace ryosen::cli {

struct Input {
  std::string path;
  std::optional<Failure> failure;  // a folder that cannot be read or holds no mesh
};

// Folders are walked with all that lies below them, in byte order of the paths, over the extensions of the format
// table (see may_be_mesh). Links to folders are followed, but a folder is gone through once, however many lead to it.
// Everything else stays as it was named, existing or not.
std::vector<Input> find_inputs(const std::vector<std::string>& operands);

// The exit code for what became of each of the inputs; there is at least one.
ExitCode combine(const std::vector<ExitCode>& codes);

}  // namespace ryosen::cli
