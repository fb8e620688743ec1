#include "ryosen/geometry/volume_sign.h"

#include <algorithm>
#include <cmath>

#include "ryosen/geometry/exact_sum.h"
#include "ryosen/geometry/place_keys.h"

namespace ryosen {

namespace {

// The corners whose mean is the tip of the cone; a triangle needs but one.
class Tips {
 public:
  explicit Tips(std::span<const glm::dvec3> polygon) : all_(polygon) {
    if (polygon.size() == 3) all_ = polygon.first(1);
    if (polygon.size() <= 8) return;
    const auto [lowest, highest] = std::minmax_element(polygon.begin(), polygon.end(), is_before);
    ends_ = {*lowest, *highest};
    all_ = ends_;
  }
  Tips(const Tips&) = delete;
  Tips& operator=(const Tips&) = delete;
  std::span<const glm::dvec3> all() const { return all_; }

 private:
  std::array<glm::dvec3, 2> ends_;
  std::span<const glm::dvec3> all_;
};

}  // namespace

void RoundedVolume::add(std::span<const glm::dvec3> polygon) {
  if (polygon.size() == 3) return add_cone(polygon[0] - lowest_, polygon[1] - lowest_, polygon[2] - lowest_);
  const Tips tips(polygon);
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& tip : tips.all()) middle += tip - lowest_;
  middle /= static_cast<double>(tips.all().size());
  for (std::size_t i = 0; i < polygon.size(); ++i)
    add_cone(middle, polygon[i] - lowest_, polygon[(i + 1) % polygon.size()] - lowest_);
}

// No coordinate is negative, and each is off by a few parts in 2^53 at most.
void RoundedVolume::add_cone(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  double term = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double forward = b[j] * c[k], backward = b[k] * c[j];
    term += a[i] * (forward - backward);
    size_ += a[i] * (forward + backward);
    reach_ = std::max({reach_, a[i], b[i], c[i]});
  }
  const double sum = sum_ + term;
  rest_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
  sum_ = sum;
}

std::optional<int> RoundedVolume::sign() const {
  // A term is off by less than 30 parts in 2^53 of its share of the size, and the sum of n terms by (n / 2^53)^2 of it,
  // which 2^32 terms keep below 3e-13. The limits keep what underflow takes far below that, and overflow out.
  const double sum = sum_ + rest_;
  if (!(size_ > 1e-180 && size_ <= 1e+300 && reach_ < 1e+60 && std::abs(sum) > 1e-12 * size_)) return std::nullopt;
  return sum > 0 ? 1 : -1;
}

void ExactVolume::add(std::span<const glm::dvec3> polygon) {
  const Tips tips(polygon);
  exact::ProductSum<3>& sum = sums_[tips.all().size()];
  if (polygon.size() == 3) return exact::add_determinant(sum, polygon[0], polygon[1], polygon[2]);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (const glm::dvec3& tip : tips.all())
      exact::add_determinant(sum, tip, polygon[i], polygon[(i + 1) % polygon.size()]);
}

int ExactVolume::sign() const {
  constexpr std::uint64_t multiple = 840;  // of all numbers up to 8
  exact::ProductSum<3> all;
  for (std::size_t tips = 1; tips < sums_.size(); ++tips) {
    exact::ProductSum<3> sum = sums_[tips];
    sum.multiply(multiple / tips);
    all.add(sum);
  }
  return all.sign();
}

}  // namespace ryosen
