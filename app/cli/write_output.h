// Saves what a command has made, and tells what comes of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/editor/document.h"

namespace ryosen::cli {

struct WrittenOutput {
  bool is_there = false;        // the file is the new one, also where a failure came after that
  std::vector<Message> losses;  // what it cannot hold; empty where it is not there
  std::optional<Failure> failure;
};

// Shows the losses and the failure.
WrittenOutput write_output(Document& document, const std::string& path, const Console& console);

}  // namespace ryosen::cli
