// The error above which a collapse loses the shape: far more than collapses cost before, and a visible share of the
// size.
//
// On a smooth surface the error doubles where half of the faces are left. It grows faster where the connectivity
// refuses all collapses that cost little: where handles and parts have as few faces as they can have.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace ryosen {

class JumpLimit {
 public:
  // A collapse costs at most so many times what the dearest one had cost when twice as many faces were left, or this
  // share of the size where that is more; until a quarter of the faces is left, any. Both are named in the help of
  // `force` and in the sentence on the stop.
  static constexpr double most_times = 3, share_of_size = 0.05;

  // `size` is the diagonal of the mesh, in units of the errors.
  JumpLimit(double size, std::size_t faces) : visible_(share_of_size * size), first_faces_(faces) { follow(faces, 0); }

  // After a collapse: so many faces are left, and its largest error so far.
  void follow(std::size_t faces, double error_max) {
    if (history_.empty() || error_max > history_.back().error) history_.push_back({faces, error_max});
    while (next_ + 1 < history_.size() && history_[next_ + 1].faces >= 2 * faces) ++next_;
    // Where the input has no face too many, its first collapses cost far more than those before.
    if (first_faces_ >= 4 * faces) limit_ = std::max(visible_, most_times * history_[next_].error);
  }
  double limit() const { return limit_; }

 private:
  struct Reached {
    std::size_t faces;
    double error;
  };

  double visible_;
  std::size_t first_faces_;
  std::vector<Reached> history_;  // by falling faces: when the error rose
  std::size_t next_ = 0;          // the last that was reached while twice as many faces were left
  double limit_ = std::numeric_limits<double>::infinity();
};

}  // namespace ryosen
