#include "app/cli/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace ryosen::cli {

Progress::Report report_on(const Console& console, std::string what) {
  const bool is_shown = !console.quiet && ::isatty(STDERR_FILENO) == 1;
  return [is_shown, what = std::move(what)](double share) {
    if (is_shown) std::fprintf(stderr, "\r%s %3.0f %%\r", what.c_str(), 100 * share);
    return true;
  };
}

}  // namespace ryosen::cli
