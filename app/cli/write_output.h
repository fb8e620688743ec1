// Saves what a command has made, and tells what comes of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/editor/document.h"
#include "app/editor/run_files.h"

namespace ryosen::cli {

struct WrittenOutput {
  bool is_there = false;        // the file is the new one, also where a failure came after that
  std::vector<Message> losses;  // what it cannot hold; empty after a failure to write
  std::optional<Failure> failure;
};

// The mesh of -o. Shows the losses and the failure. is_strict: losses are one.
WrittenOutput write_output(Document& document, RunFiles& files, const std::string& path, bool is_strict,
                           const Console& console);

}  // namespace ryosen::cli
