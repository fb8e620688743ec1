// What can be said against a file that a command is to write, before anything runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace ryosen::cli {

// A name that does not say in which format to write.
std::optional<Failure> fault_of_output(const std::string& path);

// A file that is one of the inputs; --overwrite would allow it.
std::optional<Failure> fault_of_replacing(const std::string& path, const std::vector<std::string>& inputs);

}  // namespace ryosen::cli
