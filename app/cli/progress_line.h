// The progress of long work on a terminal.
#pragma once

#include <string>

#include "app/cli/console.h"
#include "ryosen/base/progress.h"

namespace ryosen::cli {

// Shows on stderr, where that is a terminal and not quiet, how far `what` is. Never cancels: signals end the program.
Progress::Report report_on(const Console& console, std::string what);

}  // namespace ryosen::cli
