#include <csignal>

#include "app/cli/run.h"
#include "app/cli/sudden_end.h"
#include "ryosen/base/resource_limits.h"

int main(int argc, char** argv) {
  // Exceeding the file size limit becomes a failed write with a message instead of killing the program.
  std::signal(SIGXFSZ, SIG_IGN);
  ryosen::reserve_little_where_limited();
  ryosen::cli::answer_lack_of_memory();
  ryosen::cli::answer_signals();
  return static_cast<int>(ryosen::cli::run({argv + 1, argv + argc}));
}
