// Handling of Ctrl-C: cancels a running command instead of killing the program.
#pragma once

#include <string>

#include "app/cli/console.h"
#include "core/base/progress.h"

namespace ryosen::cli {

// During its lifetime the first interrupt is only recorded; a second one kills the program.
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

// A report function that cancels after an interrupt and shows the progress of `what` on a terminal.
Progress::Report report_on(const Console& console, std::string what);

}  // namespace ryosen::cli
