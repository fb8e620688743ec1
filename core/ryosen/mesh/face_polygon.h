// The polygon of a face, loop by loop: the one source of corner positions for drawing, picking and measuring;
// and the middle of any element.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/geometry/triangulate.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

// Corners are numbered from 0, the outer loop from the face's first corner, then ring after ring. Reuse one object for
// many faces: it keeps its buffers.
class FacePolygon {
 public:
  FacePolygon() = default;
  FacePolygon(const Mesh& mesh, Face f) { read(mesh, f); }
  // Reads a live face. O(corners).
  void read(const Mesh& mesh, Face f);

  const std::vector<Halfedge>& corners() const { return corners_; }
  const std::vector<glm::dvec3>& places() const { return places_; }
  // One past the last corner of each loop.
  const std::vector<std::uint32_t>& loop_ends() const { return loop_ends_; }
  // The places of each loop.
  std::vector<std::span<const glm::dvec3>> loops() const;
  bool is_finite() const;
  // Moves all corners at the point of v (its copies included) to another position.
  void move(const Mesh& mesh, Vertex v, const glm::dvec3& place);
  // Moves one corner.
  void move(Halfedge corner, const glm::dvec3& place);

  // The triangles as corner numbers; coordinates must be finite. See triangulate.h.
  void triangulate(std::vector<CornerTriangle>& out) const;
  // Whether `second` is the corner after `first` on its loop.
  bool is_side(std::uint32_t first, std::uint32_t second) const;
  std::uint32_t next(std::uint32_t corner) const;
  // One closed polygon over all loops, connected through the first corners and back: sums over its sides (area, normal,
  // volume) are those of the face. Without rings, just the positions.
  std::vector<glm::dvec3> keyhole_walk() const;

 private:
  std::vector<Halfedge> corners_;
  std::vector<glm::dvec3> places_;
  std::vector<std::uint32_t> loop_ends_;
};

// The same walk in canonical form, independent of bridges, ring order and loop starts, so that sums over a mesh and
// over the file written from it are bitwise equal.
std::vector<glm::dvec3> measured_walk(const Mesh& mesh, Face f);

// One place of an element, in its middle, and on the element: of a face the middle of one of its triangles, so that it
// lies on it though that is not convex. Cost: of a face its triangulation, else O(1).
glm::dvec3 middle_of(const Mesh& mesh, const Element& element);

}  // namespace ryosen
