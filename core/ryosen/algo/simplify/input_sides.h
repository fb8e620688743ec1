// Which way the surface looked before it was simplified, at some of its places: to tell faces that have come to look
// against it.
//
// Where a part is folded, or two sheets lie nearer to each other than the error, a face may come to lie nearer to what
// looks the other way. Neither its own turns nor the normals that its corners stand for tell that; only the input does.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

class InputSides {
 public:
  // Of the triangles with an area at some vertices of a mesh of triangles, which must stay as it is. Cost: n log n in
  // those.
  InputSides(const Mesh& input, const std::vector<std::uint8_t>& is_asked_about);

  // Whether of these the one nearest to the middle of a triangle looks 90 degrees or more away from it; where several
  // are as near, whether one of them does. A triangle without area looks nowhere. Cost: O(log n), and what looks()
  // says.
  bool is_turned(const TriangleCorners& triangle) const;
  // What that has cost so far: so many triangles were near the nearest place. As many slivers lie around a hub.
  std::size_t looks() const { return looks_; }

 private:
  TriangleCorners corners(Face f) const;
  bool looks_against(Face f, const glm::dvec3& normal) const;

  const Mesh& input_;
  double scale_;  // a power of two, so that what is huge or tiny is judged as all else is
  std::vector<glm::dvec3> places_;
  Bvh tree_;
  mutable std::size_t looks_ = 0;
};

}  // namespace ryosen
