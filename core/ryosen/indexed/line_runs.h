// The line number of each element of a file, run-length encoded (consecutive lines form a run): a few bytes for most
// files.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ryosen {

class LineRuns {
 public:
  // Appends the line of the next element, from 1.
  void add(std::uint64_t line) { add(line, 1); }
  // Appends the lines of as many elements, one after the other.
  void add(std::uint64_t line, std::size_t elements) {
    if (elements == 0) return;
    begin_run({count_, line});
    count_ += static_cast<std::uint32_t>(elements);
  }
  // Appends the elements of a part of the file that starts after `lines_before` lines. O(runs).
  void append(const LineRuns& next, std::uint64_t lines_before) {
    for (const Run& run : next.runs_) begin_run({count_ + run.first, lines_before + run.line});
    count_ += next.count_;
  }
  friend bool operator==(const LineRuns&, const LineRuns&) = default;
  // The line of an element, 0 if none was added. O(log runs).
  std::uint64_t line(std::uint32_t element) const {
    if (element >= count_) return 0;
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), element,
                                        [](std::uint32_t e, const Run& r) { return e < r.first; });
    return line_in(*(after - 1), element);
  }

 private:
  struct Run {
    std::uint32_t first;
    std::uint64_t line;
    friend bool operator==(const Run&, const Run&) = default;
  };
  // Starts a run unless it continues the last one.
  void begin_run(const Run& run) {
    if (runs_.empty() || line_in(runs_.back(), run.first) != run.line) runs_.push_back(run);
  }
  static std::uint64_t line_in(const Run& run, std::uint32_t element) { return run.line + (element - run.first); }

  std::vector<Run> runs_;
  std::uint32_t count_ = 0;
};

}  // namespace ryosen
