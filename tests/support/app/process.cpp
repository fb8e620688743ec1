#include "tests/support/app/process.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace ryosen::test {

Process::Process(std::vector<std::string> arguments, const std::vector<std::string>& environment,
                 const std::string& output, const std::string& errors, const std::string& folder) {
  id_ = fork();
  if (id_ != 0) return;
  for (const std::string& variable : environment) putenv(strdup(variable.c_str()));
  if (!freopen(output.c_str(), "w", stdout) || !freopen(errors.c_str(), "w", stderr)) _exit(126);
  if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
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

bool Process::is_over() { return is_over_ || (is_over_ = wait4(id_, &status_, WNOHANG, &usage_) == id_); }

std::chrono::duration<double> Process::processor_time() {
  if (is_over()) {
    const auto seconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return std::chrono::duration<double>(seconds(usage_.ru_utime) + seconds(usage_.ru_stime));
  }
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(id_, &clock) == 0) clock_gettime(clock, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

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
  if (!is_over_) is_over_ = wait4(id_, &status_, 0, &usage_) == id_;
  return exit_code();
}

int Process::exit_code() const { return is_over_ && WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

bool wait_for(const std::function<bool()>& condition, std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return condition();
}

}  // namespace ryosen::test
