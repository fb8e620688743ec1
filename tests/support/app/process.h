// A program that runs beside a test.
#pragma once

#include <signal.h>
#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace ryosen::test {

// Runs from construction on; ended (SIGTERM) at the end of its life where it still runs.
class Process {
 public:
  // `environment` holds NAME=VALUE beside what the test has; stdout and stderr go to the files. An interrupt, a
  // request to terminate and a hang-up reach it even where the test was started to ignore them. It runs in the folder,
  // in that of the test where there is none.
  explicit Process(std::vector<std::string> arguments, const std::vector<std::string>& environment = {},
                   const std::string& output = "/dev/null", const std::string& errors = "/dev/null",
                   const std::string& folder = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool is_over();
  // Whether it has a handler of this signal by now.
  bool handles(int signal) const;
  void send(int signal);
  // Sends a signal and waits for the end.
  void end_by(int signal);
  // What it has taken of the processors by now, or had at its end.
  std::chrono::duration<double> processor_time();
  // Waits for the end. The exit code; -1 where a signal ended it.
  int wait();
  int exit_code() const;

 private:
  pid_t id_ = -1;
  int status_ = 0;
  rusage usage_{};
  bool is_over_ = false;
};

// Asks every now and then until it holds; false where it does not within the limit.
bool wait_for(const std::function<bool()>& condition, std::chrono::seconds limit = std::chrono::seconds(15));

}  // namespace ryosen::test
