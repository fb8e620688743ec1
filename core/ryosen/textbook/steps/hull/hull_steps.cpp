#include "ryosen/textbook/steps/hull/hull_steps.h"

#include <numeric>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/textbook/steps/hull/planar_steps.h"
#include "ryosen/textbook/steps/hull/solid_steps.h"

namespace ryosen {

HullSteps::HullSteps(std::span<const glm::dvec3> points, HullOrder order, std::uint64_t seed) : points_(points) {
  const auto count = static_cast<std::uint32_t>(points.size());
  std::vector<std::uint32_t> numbers;
  if (order == HullOrder::random) {
    numbers = shuffled_numbers(count, seed);
  } else {
    numbers.resize(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
  }
  std::erase_if(numbers, [&](std::uint32_t i) { return !is_finite(points[i]); });
  const hull::FirstPoints first = hull::first_points(points, numbers);
  dimension_ = first.dimension;
  if (dimension_ == 2) builder_ = std::make_unique<hull::PlanarSteps>(points, order, std::move(numbers), first);
  if (dimension_ == 3) builder_ = std::make_unique<hull::SolidSteps>(points, order, std::move(numbers), first);
}

HullSteps::~HullSteps() = default;
HullSteps::HullSteps(HullSteps&&) noexcept = default;
HullSteps& HullSteps::operator=(HullSteps&&) noexcept = default;

HullSteps HullSteps::copy() const {
  HullSteps other;
  other.points_ = points_;
  other.dimension_ = dimension_;
  if (builder_) other.builder_ = builder_->copy();
  return other;
}

int HullSteps::dimension() const { return dimension_; }
std::size_t HullSteps::step_count() const { return builder_ ? builder_->step_count() : 0; }
std::size_t HullSteps::steps_done() const { return builder_ ? builder_->steps_done() : 0; }
const HullStep* HullSteps::next(bool tells_why) { return builder_ ? builder_->next(tells_why) : nullptr; }
std::size_t HullSteps::made_so_far() const { return builder_ ? builder_->made_so_far() : 0; }
ConvexHull HullSteps::hull() const { return builder_ ? builder_->hull() : convex_hull(points_); }

const forms::DcelRecords& HullSteps::records() const {
  static const forms::DcelRecords none;
  return builder_ ? builder_->records() : none;
}

}  // namespace ryosen
