// Expansion of a command's operands to input files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ryosen/base/result.h"

namespace ryosen::cli {

struct Input {
  std::string path;
  std::optional<Failure> failure;  // a folder that cannot be read or holds no mesh
};

// Folders are walked recursively, in byte order of the paths, for the extensions of the format table (see may_be_mesh).
// Links to folders are followed, but each folder is visited once. Other operands are kept as given, existing or not.
std::vector<Input> find_inputs(const std::vector<std::string>& operands);

// The combined exit code of at least one input.
ExitCode combine(const std::vector<ExitCode>& codes);

}  // namespace ryosen::cli
