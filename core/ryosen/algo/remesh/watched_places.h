// Parts of space, as equal cubes, where steps are judged more closely.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_set>

#include "ryosen/geometry/box.h"

namespace ryosen::remesh {

class WatchedPlaces {
 public:
  explicit WatchedPlaces(double cell) : cell_(cell) {}

  // The cubes of a box and those beside them; all of space, where they would be very many.
  void add(const Box& box);
  void add_all() { is_all_ = true; }
  bool contains(const glm::dvec3& place) const {
    return is_all_ || (!cells_.empty() && cells_.count(cell_of(place)) > 0);
  }
  bool is_all() const { return is_all_; }
  bool is_empty() const { return !is_all_ && cells_.empty(); }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const;
  };
  Cell cell_of(const glm::dvec3& place) const;

  double cell_;
  bool is_all_ = false;
  std::unordered_set<Cell, Hash> cells_;
};

}  // namespace ryosen::remesh
