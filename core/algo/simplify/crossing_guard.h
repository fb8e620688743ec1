// Keeps a surface of triangles free of self-intersections while its edges collapse: exactly, in the sense of
// find_self_intersections.
#pragma once

#include <vector>

#include "core/geometry/triangles_meet.h"
#include "core/mesh/mesh.h"
#include "core/pick/bvh.h"

namespace ryosen {

class CrossingGuard {
 public:
  // Of a mesh of triangles without self-intersections. O(n log n).
  explicit CrossingGuard(const Mesh& mesh);

  // Whether faces would meet elsewhere than at what they share if from(h) became to(h) there. A face that would lose its
  // area counts too. Cost: the faces around both ends, and those near them.
  bool would_meet(Halfedge h, const glm::dvec3& position) const;
  // The vertex stands for another one too, and has come to its place: the faces around it are up to date.
  void follow(Vertex kept);
  // A face that is gone.
  void forget(Face f) { tree_.erase(f.index); }

 private:
  struct Changed {
    Face face;
    NumberedTriangle triangle;
  };
  NumberedTriangle triangle(Face f) const;
  // False where one would lose its area.
  bool collect(Halfedge h, const glm::dvec3& position, std::vector<Changed>& changed) const;
  bool meets_another(const Changed& one, const std::vector<Changed>& changed, Halfedge h) const;

  const Mesh& mesh_;
  Bvh tree_;  // slots are faces
};

}  // namespace ryosen
