// The farthest of the pairs that are offered.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/hull_measures.h"

namespace ryosen::hull {

class FarthestPair {
 public:
  FarthestPair(std::span<const glm::dvec3> points, const UnitPlaces& places) : points_(points), places_(places) {}

  // Exact; of equally far ones the lexicographically first stays.
  void offer(std::uint32_t p, std::uint32_t q) {
    const double length = glm::length(places_[p] - places_[q]);
    if (length < length_ * (1 - 1e-14)) return;
    const std::pair<std::uint32_t, std::uint32_t> pair = std::minmax(p, q);
    if (has_any_) {
      const int sign = compare_lengths({points_[p], points_[q]}, {points_[pair_.first], points_[pair_.second]});
      if (sign < 0 || (sign == 0 && pair >= pair_)) return;
    }
    has_any_ = true;
    pair_ = pair;
    length_ = length;
  }
  std::pair<std::uint32_t, std::uint32_t> pair() const { return pair_; }
  double length() const { return length_; }  // in units of the places

 private:
  std::span<const glm::dvec3> points_;
  const UnitPlaces& places_;
  std::pair<std::uint32_t, std::uint32_t> pair_{};
  double length_ = 0;
  bool has_any_ = false;
};

}  // namespace ryosen::hull
