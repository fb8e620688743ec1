// The program as a whole process: what it costs from its start to its end.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "tests/bench/cost.h"

namespace ryosen::bench {

struct ProcessCost {
  Cost cost;
  double peak_bytes = 0;
  int status = 0;  // as wait gives it
};

// Runs in a process of its own, whose memory is not that of this one.
inline ProcessCost run_process(const std::function<void()>& work) {
  ProcessCost out;
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(127);
  }
  rusage usage{};
  if (child < 0 || wait4(child, &out.status, 0, &usage) != child ||
      (WIFEXITED(out.status) && WEXITSTATUS(out.status) == 127)) {
    std::fprintf(stderr, "a process could not be run\n");
    std::exit(70);
  }
  out.cost.wall = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  out.cost.cpu = milliseconds_of(usage);
  out.peak_bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return out;
}

// Its standard output goes to `output`. After `most_seconds` of processor time it is killed; 0 stands for no limit.
inline ProcessCost run_program(std::vector<std::string> arguments, const std::string& output = "/dev/null",
                               rlim_t most_seconds = 0) {
  return run_process([&] {
    arguments.insert(arguments.begin(), RYOSEN_PROGRAM);
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    dup2(open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    const rlimit limit{most_seconds, most_seconds};
    if (most_seconds > 0) setrlimit(RLIMIT_CPU, &limit);
    execv(RYOSEN_PROGRAM, words.data());
  });
}

}  // namespace ryosen::bench
