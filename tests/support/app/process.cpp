#include "tests/support/app/process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace ryosen::test {

Process::Process(std::vector<std::string> arguments, const std::vector<std::string>& environment,
                 const std::string& output, const std::string& errors) {
  id_ = fork();
  if (id_ != 0) return;
  for (const std::string& variable : environment) putenv(strdup(variable.c_str()));
  if (!freopen(output.c_str(), "w", stdout) || !freopen(errors.c_str(), "w", stderr)) _exit(126);
  for (const int each : {SIGINT, SIGTERM, SIGHUP}) signal(each, SIG_DFL);
  std::vector<char*> words;
  for (std::string& word : arguments) words.push_back(word.data());
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(127);
}

Process::~Process() {
  if (id_ > 0 && !is_over()) end_by(SIGTERM);
}

bool Process::is_over() { return is_over_ || (is_over_ = waitpid(id_, &status_, WNOHANG) == id_); }

void Process::send(int signal) {
  if (!is_over()) kill(id_, signal);
}

void Process::end_by(int signal) {
  send(signal);
  wait();
}

bool Process::handles(int signal) const {
  std::ifstream status("/proc/" + std::to_string(id_) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
  return false;
}

int Process::wait() {
  if (!is_over_) is_over_ = waitpid(id_, &status_, 0) == id_;
  return exit_code();
}

int Process::exit_code() const { return is_over_ && WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

bool wait_for(const std::function<bool()>& condition, std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return condition();
}

}  // namespace ryosen::test
