#include "app/cli/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace ryosen::cli {
namespace {

volatile std::sig_atomic_t asked = 0;

void remember(int) {
  asked = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() : before_(std::signal(SIGINT, remember)) {
  asked = 0;
  if (before_ == SIG_IGN) std::signal(SIGINT, SIG_IGN);  // the parent process set it to be ignored
}
Interrupt::~Interrupt() { std::signal(SIGINT, before_); }

bool Interrupt::was_asked() { return asked != 0; }

Progress::Report report_on(const Console& console, std::string what) {
  const bool is_shown = !console.quiet && ::isatty(STDERR_FILENO) == 1;
  return [is_shown, what = std::move(what)](double share) {
    if (is_shown) std::fprintf(stderr, "\r%s %3.0f %%\r", what.c_str(), 100 * share);
    return !Interrupt::was_asked();
  };
}

}  // namespace ryosen::cli
