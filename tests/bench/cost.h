// What work costs: wall time beside CPU time, and the rows in which benchmarks of files print it.
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace ryosen::bench {

struct Cost {
  double wall = 0, cpu = 0;  // milliseconds; cpu is that of all threads, user and system
};

inline double milliseconds_of(const rusage& usage) {
  const auto of = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

inline double cpu_milliseconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return milliseconds_of(usage);
}

// Of this process and all its threads.
template <class Work>
Cost cost_of(Work work) {
  const double cpu = cpu_milliseconds();
  const auto start = std::chrono::steady_clock::now();
  work();
  const double wall = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return {wall, cpu_milliseconds() - cpu};
}

// What several turns cost. Other programs on the machine only add, so the least is nearest to the truth.
class Costs {
 public:
  void add(Cost cost) {
    wall_.push_back(cost.wall);
    least_cpu_ = std::min(least_cpu_, cost.cpu);
    sum_of_cpu_ += cost.cpu;
  }
  bool empty() const { return wall_.empty(); }
  double least() const { return *std::min_element(wall_.begin(), wall_.end()); }
  double most() const { return *std::max_element(wall_.begin(), wall_.end()); }
  double least_cpu() const { return least_cpu_; }
  double mean_cpu() const { return sum_of_cpu_ / static_cast<double>(wall_.size()); }
  double median() const {
    std::vector<double> values = wall_;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

 private:
  std::vector<double> wall_;
  double sum_of_cpu_ = 0;
  double least_cpu_ = std::numeric_limits<double>::infinity();
};

inline void print_head(const char* title) {
  std::printf("%-28s %8s %8s %8s %8s %8s %7s %8s\n", title, "median", "least", "cpu", "CGAL", "its cpu", "ratio",
              "bar");
}

// A row in milliseconds. The peer may be empty; a bar of 0 stands for none.
inline void print_row(const std::string& name, const Costs& ours, const Costs& peer = {}, double bar_ms = 0) {
  std::printf("%-28s %8.1f %8.1f %8.1f", name.c_str(), ours.median(), ours.least(), ours.least_cpu());
  if (!peer.empty())
    std::printf(" %8.1f %8.1f %6.1fx", peer.least(), peer.least_cpu(), peer.least() / ours.least());
  else if (bar_ms > 0)
    std::printf(" %8s %8s %7s", "-", "-", "-");
  if (bar_ms > 0) std::printf(" %8.0f %s", bar_ms, ours.least() <= bar_ms ? "reached" : "short");
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace ryosen::bench
