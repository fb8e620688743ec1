#include "ryosen/geometry/ear_clip.h"

#include "ryosen/geometry/predicates.h"

namespace ryosen {
namespace {

constexpr std::size_t most_point_tests = 20'000'000;

class EarClipper {
 public:
  EarClipper(std::span<const glm::dvec2> points, std::span<const std::uint32_t> corners)
      : points_(points), corners_(corners) {
    const auto count = static_cast<std::uint32_t>(corners.size());
    next_.resize(count);
    prev_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      next_[i] = i + 1 < count ? i + 1 : 0;
      prev_[next_[i]] = i;
    }
  }

  void run(std::vector<CornerTriangle>& out) {
    auto left = static_cast<std::uint32_t>(corners_.size());
    std::uint32_t here = 0;
    std::uint32_t refused = 0;
    while (left > 3 && tests_ < most_point_tests) {
      if (refused < left ? is_ear(here) : (refused >= 2 * left || bend(here) > 0)) {
        cut(here, out);
        --left;
        refused = 0;
        here = next_[next_[here]];  // skipping one corner keeps fans from growing around a single corner
      } else {
        ++refused;
        here = next_[here];
      }
    }
    // The rest: normally one triangle; a fan if the budget of point tests ran out.
    for (; left > 2; --left) {
      cut(next_[here], out);
    }
  }

 private:
  const glm::dvec2& point(std::uint32_t place) const { return points_[corners_[place]]; }
  int bend(std::uint32_t i) const { return orient2d(point(prev_[i]), point(i), point(next_[i])); }

  bool is_ear(std::uint32_t i) {
    ++tests_;
    if (bend(i) <= 0) return false;
    const glm::dvec2& a = point(prev_[i]);
    const glm::dvec2& b = point(i);
    const glm::dvec2& c = point(next_[i]);
    for (std::uint32_t k = next_[next_[i]]; k != prev_[i]; k = next_[k]) {
      ++tests_;
      const glm::dvec2& p = point(k);
      if (p == a || p == b || p == c) continue;
      if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0) return false;
    }
    return true;
  }

  // Emits the triangle at a corner and unlinks the corner; its own links stay, so a caller can walk on from it.
  void cut(std::uint32_t i, std::vector<CornerTriangle>& out) {
    out.push_back({corners_[prev_[i]], corners_[i], corners_[next_[i]]});
    next_[prev_[i]] = next_[i];
    prev_[next_[i]] = prev_[i];
  }

  std::span<const glm::dvec2> points_;
  std::span<const std::uint32_t> corners_;
  std::vector<std::uint32_t> next_, prev_;
  std::size_t tests_ = 0;
};

}  // namespace

void clip_ears(std::span<const glm::dvec2> points, std::span<const std::uint32_t> corners,
               std::vector<CornerTriangle>& out) {
  if (corners.size() < 3) return;
  EarClipper(points, corners).run(out);
}

}  // namespace ryosen
