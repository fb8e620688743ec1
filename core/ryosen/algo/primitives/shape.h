// What the primitives share: a polygon list to put a shape together in, points on a circle, and the way into the mesh.
#pragma once

#include <glm/vec2.hpp>
#include <initializer_list>
#include <span>
#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen {

// The faces are counter-clockwise seen from outside.
class Shape {
 public:
  // Places are relative to the centre.
  explicit Shape(const glm::dvec3& centre) : centre_(centre) {}

  std::uint32_t add_point(const glm::dvec3& place);
  void add_face(std::span<const std::uint32_t> corners);
  void add_face(std::initializer_list<std::uint32_t> corners) { add_face({corners.begin(), corners.size()}); }

  // Adds it to the mesh as a component of its own. Where its values are so far apart that places overflow or faces have
  // no area, nothing is written and the result has the fault. Cost: what is added.
  AlgorithmResult add_to(Edit& edit, Progress& progress) &&;

 private:
  glm::dvec3 centre_;
  IndexedMesh list_;
};

// So many points around a circle of radius 1, counter-clockwise from (1, 0). Points that mirror each other in an axis
// do so exactly.
std::vector<glm::dvec2> points_on_circle(std::size_t count);

}  // namespace ryosen
