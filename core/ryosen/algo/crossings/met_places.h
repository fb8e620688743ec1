// Where faces of a surface met before it was changed, so that they may meet there again.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <unordered_set>
#include <vector>

#include "ryosen/analysis/box_tree.h"
#include "ryosen/geometry/common_part.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

// The box of what two triangles that meet have in common; of what their boxes have, where rounding shows none.
inline Box common_box(const TriangleCorners& a, const TriangleCorners& b) {
  const Box common = box_of_common_part(a, b), of_a = box_of(a), of_b = box_of(b);
  if (!common.is_empty()) return common;
  return {glm::max(of_a.lowest, of_b.lowest), glm::min(of_a.highest, of_b.highest)};
}

// Boxes, each of two parts of the surface that met there.
class MetPlaces {
 public:
  struct Place {
    Box box;
    std::uint32_t part, other;
  };

  MetPlaces() = default;
  // With a part for each face slot.
  MetPlaces(std::vector<std::uint32_t> parts, const std::vector<Place>& places) : parts_(std::move(parts)) {
    std::vector<Box> boxes;
    for (const Place& place : places) {
      boxes.push_back(place.box);
      owners_.push_back({place.part, place.other});
      pairs_.insert(key(place.part, place.other));
    }
    boxes_ = BoxTree(std::move(boxes));
  }

  bool is_empty() const { return boxes_.is_empty(); }
  const std::vector<std::uint32_t>& parts() const { return parts_; }
  bool have_met(std::uint32_t part, std::uint32_t other) const { return pairs_.contains(key(part, other)); }
  // Whether a triangle of a part lies in one of its boxes: what it has in common with any other one lies there too.
  // O(log n) and the boxes around it, as the next.
  bool enclose(const Box& triangle, std::uint32_t part) const {
    return !boxes_.visit([&](const Box& box) { return box.encloses(triangle); },
                         [&](std::uint32_t i) { return owners_[i][0] != part && owners_[i][1] != part; });
  }
  // Whether the middle of what two triangles have in common lies in any.
  bool hold(const TriangleCorners& a, const TriangleCorners& b) const {
    const glm::dvec3 middle = common_box(a, b).middle();
    const Box place{middle, middle};
    return !boxes_.visit([&](const Box& box) { return box.encloses(place); }, [](std::uint32_t) { return false; });
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32u | std::max(a, b);
  }

  BoxTree boxes_;
  std::vector<std::array<std::uint32_t, 2>> owners_;  // of each box
  std::vector<std::uint32_t> parts_;
  std::unordered_set<std::uint64_t> pairs_;
};

}  // namespace ryosen
