// The exit codes in words.
#pragma once

#include <span>
#include <string_view>

#include "ryosen/base/result.h"

namespace ryosen::cli {

struct ExitCodeText {
  ExitCode code;
  std::string_view en, ja;
};
std::span<const ExitCodeText> exit_code_texts();

}  // namespace ryosen::cli
