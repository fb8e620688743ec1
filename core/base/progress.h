// How long work tells how far it is and is asked to stop.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace ryosen {

// Work that gets one calls go_on() as it proceeds and returns at once when that is false; whoever began the work undoes
// what it has done. One that nobody listens to never stops anything.
class Progress {
 public:
  // Gets the share that is done, 0..1, at first and then not more often than the interval; false asks the work to stop.
  using Report = std::function<bool(double share)>;
  using Clock = std::chrono::steady_clock;

  Progress() = default;
  explicit Progress(Report report, Clock::duration interval = std::chrono::milliseconds(50))
      : report_(std::move(report)), interval_(interval) {}

  // From now on the steps are those of this one of so many equal parts of the whole.
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
  // Within a step.
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
