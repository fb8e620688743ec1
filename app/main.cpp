#include <csignal>

#include "app/cli/run.h"

int main(int argc, char** argv) {
  // A file that may not become so large is a write that fails, with a sentence, and not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  return static_cast<int>(ryosen::cli::run({argv + 1, argv + argc}));
}
