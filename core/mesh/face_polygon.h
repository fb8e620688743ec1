// The polygon of a face, loop by loop: the one place where corners become places for drawing, picking and measuring.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/geometry/triangulate.h"
#include "core/mesh/rings.h"

namespace ryosen {

// Corners are numbered from 0, the outer loop from the face's first corner, then ring after ring. Reuse one object for
// many faces: it keeps its memory.
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
  bool is_finite() const;
  // Puts the corners at a point of the mesh elsewhere.
  void move(const Mesh& mesh, Vertex v, const glm::dvec3& place);
  // Puts one corner elsewhere.
  void move(Halfedge corner, const glm::dvec3& place);

  // The triangles as corner numbers; coordinates must be finite. See triangulate.h.
  void triangulate(std::vector<CornerTriangle>& out) const;
  // Whether `second` is the corner after `first` on its loop.
  bool is_side(std::uint32_t first, std::uint32_t second) const;
  std::uint32_t next(std::uint32_t corner) const;
  // One closed walk over all loops, from ring to ring through the first corners and back: sums over its sides (area,
  // normal, volume) are those of the face. The places themselves where there is no ring.
  std::vector<glm::dvec3> keyhole_walk() const;

 private:
  std::vector<Halfedge> corners_;
  std::vector<glm::dvec3> places_;
  std::vector<std::uint32_t> loop_ends_;
};

// The same walk in a form that does not depend on bridges, on the order of the rings or on where a loop begins, so that
// sums over a mesh and over the file written of it are equal to the last bit.
std::vector<glm::dvec3> measured_walk(const Mesh& mesh, Face f);

}  // namespace ryosen
