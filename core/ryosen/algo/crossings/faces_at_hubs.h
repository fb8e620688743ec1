// The faces at a vertex of many faces, or at two of them, found by the directions in which they lie from there.
//
//      \ | /       Around a hub all faces have their tip at one place, and at an edge between two hubs all lie
//     -- X --      along it, like pages on a spine. Boxes part neither. Seen from a hub a face lies between the
//      / | \       directions of its other corners, and seen along a spine a page lies in one direction.
//        Y
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/base/handle.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/frustum.h"
#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

// Directions of places seen from a point: what two triangles have no direction in common meet at most at that point.
namespace directions {

// From one place to another. Its largest coordinate is 1, of either sign; all are 0 where that is the same place, and
// not finite where it is too far.
glm::dvec3 direction(const glm::dvec3& from, const glm::dvec3& to);
inline bool is_somewhere(const glm::dvec3& direction) { return is_finite(direction) && direction != glm::dvec3(0); }

// A triangle as thick as rounding; its box where it is too large or small for that.
Frustum slab_of(const TriangleCorners& triangle);

}  // namespace directions

class FacesAtHubs {
 public:
  using Slot = std::uint32_t;

  // Of one or two places.
  explicit FacesAtHubs(std::span<const glm::dvec3> ends);

  // A triangle that has its first corners at the ends and all three apart. O(log n).
  Slot add(Face f, const TriangleCorners& corners);
  void change(Slot slot, const TriangleCorners& corners);
  void erase(Slot slot);
  std::size_t size() const { return faces_.size() - free_slots_.size(); }

  // A box around all that were ever there.
  const Box& reach() const { return reach_; }

  // Calls visit(face) for each that meets the triangle elsewhere than at points of the same number, and others near it;
  // the ends have these numbers. Now and then it puts its tree in order.
  template <class Visit>
  void find(const NumberedTriangle& triangle, std::span<const std::uint32_t> numbers, Visit&& visit) {
    if (tree_.is_worn()) tree_.rebuild(seen_);
    tree_.visit_frustum(seen_, region_of(triangle, numbers), [&](Slot slot) { visit(faces_[slot]); });
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Face f : faces_)
      if (f) visit(f);
  }

 private:
  Frustum region_of(const NumberedTriangle& triangle, std::span<const std::uint32_t> numbers) const;

  std::vector<glm::dvec3> places_;
  // By slot two ends of a segment: the directions of the other corners from the one place, or, of a box, what is beside
  // the line through both.
  std::vector<glm::dvec3> seen_;
  Bvh tree_;
  std::vector<Face> faces_;  // by slot
  std::vector<Slot> free_slots_;
  Box reach_;
};

}  // namespace ryosen
