// How far a place is from the mesh that is simplified, by a search over its triangles from one near by.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

class InputSearch {
 public:
  // The faces of the input are triangles at finite places. Both must outlive it.
  InputSearch(const Mesh& input, const ScaledPlaces& scale) : input_(input), scale_(scale) {}

  struct Near {
    glm::dvec3 way{0.0};  // from the input to the place, scaled
    double square = std::numeric_limits<double>::infinity();
    std::size_t asked = 0;  // triangles
  };
  // Spreads from the triangle at a corner over those across its sides, the nearest first, as far as twice the least
  // distance found, so that it comes around what lies between. Stops where a distance is found whose square is
  // `enough`. Cost: O(log n) for each triangle that it asks, at most 4,096 of them: of more the answer may be too far.
  Near nearest(const glm::dvec3& place, Halfedge corner, double enough = 0) const;

 private:
  std::optional<Near> from_triangle(const glm::dvec3& place, Halfedge corner) const;
  glm::dvec3 place_of(Vertex v) const { return scale_.scaled(input_.position(v)); }

  const Mesh& input_;
  const ScaledPlaces& scale_;
};

}  // namespace ryosen
