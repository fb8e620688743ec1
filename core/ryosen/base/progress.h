// Progress reporting and cancellation of long operations.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace ryosen {

// The operation calls go_on() as it proceeds and returns at once when that is false; its caller rolls back. Without a
// Report it never cancels.
class Progress {
 public:
  // Called with the fraction done, 0..1, at the first go_on() and then at most once per interval; returning false
  // cancels.
  using Report = std::function<bool(double share)>;
  using Clock = std::chrono::steady_clock;

  Progress() = default;
  explicit Progress(Report report, Clock::duration interval = std::chrono::milliseconds(50))
      : report_(std::move(report)), interval_(interval) {}

  // The next steps are those of part `part` of `parts` equal parts of the whole.
  void begin_part(std::size_t part, std::size_t parts) {
    part_size_ = 1.0 / static_cast<double>(parts);
    share_ = part_begin_ = static_cast<double>(part) * part_size_;
  }
  // `done` of `all` steps are done. Cheap enough for a step of a microsecond.
  bool go_on(std::size_t done, std::size_t all) {
    const double share = all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
    share_ = part_begin_ + share * part_size_;
    return go_on();
  }
  // Within a step, without advancing.
  bool go_on() {
    if (!report_ || is_cancelled_) return !is_cancelled_;
    const Clock::time_point now = Clock::now();
    if (reported_ && now - *reported_ < interval_) return true;
    reported_ = now;
    is_cancelled_ = !report_(share_);
    return !is_cancelled_;
  }
  bool is_cancelled() const { return is_cancelled_; }

 private:
  Report report_;
  Clock::duration interval_{};
  std::optional<Clock::time_point> reported_;
  double share_ = 0, part_begin_ = 0, part_size_ = 1;
  bool is_cancelled_ = false;
};

}  // namespace ryosen
