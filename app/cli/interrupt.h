// Ctrl-C while a command works: it cancels the work instead of killing the program.
#pragma once

#include <string>

#include "app/cli/console.h"
#include "core/base/progress.h"

namespace ryosen::cli {

// For its life the first interrupt is only remembered; a second one kills as ever.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool was_asked();

 private:
  void (*before_)(int);
};

// Stops work when it was interrupted, and meanwhile shows on a terminal how far `what` is.
Progress::Report report_on(const Console& console, std::string what);

}  // namespace ryosen::cli
