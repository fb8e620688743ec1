// Pairing of the faces around one edge by exact angles.
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Pairs the sides of faces around edges. The mesh, `place`, which has by vertex slot the one that stands for its place,
// and `across`, which has the pairs known so far by halfedge slot, must outlive it.
class EdgePairer {
 public:
  EdgePairer(const Mesh& mesh, const std::vector<Vertex>& place, std::vector<Halfedge>& across)
      : mesh_(mesh), place_(place), across_(across) {}

  // All sides run between the same two places, as many in each direction. Around the edge a face is paired with the
  // first face of the other direction through its inside, which lies behind it, opposite its normal. Where faces lie at
  // one angle, a face that ends an inside comes before one that begins one, and then the lowest face is the nearest.
  // Exact. Cost: O(k log k) for k sides, and a triangulation of the faces that are no triangles.
  void pair(std::span<const Halfedge> sides);

 private:
  struct SideAround;

  void match(std::span<const SideAround> around);
  std::optional<glm::dvec3> apex(Halfedge side);
  std::optional<glm::dvec3> place_beside(Halfedge side, const glm::dvec3& start, const glm::dvec3& end);
  void triangulate(Face f);

  const Mesh& mesh_;
  const std::vector<Vertex>& place_;
  std::vector<Halfedge>& across_;
  std::unordered_set<Face> triangulated_;
  std::unordered_map<Halfedge, glm::dvec3> apexes_;  // by side, of the triangle at it
};

}  // namespace ryosen
