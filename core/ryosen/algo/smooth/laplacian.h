// The weights of the Laplacian of a mesh: how much each neighbour of a point counts.
//
//          j             uniform: 1 for each neighbour
//         /|\            cotangent: (cot a + cot b) / 2, but not below 0 [Desbrun99]; a polygon counts by its
//        | a | b           triangles, so that the ends of a diagonal are neighbours too
//         \|/
//          i
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::smooth {

using Places = std::vector<glm::dvec3>;
using Triangle = std::array<std::uint32_t, 3>;

enum class WeightKind { uniform, cotangent };

// The triangles of all faces with finite corners, as points (copies.h). The scale (unit_scale.h) is applied before
// polygons are cut, so that the size of the mesh does not matter.
std::vector<Triangle> triangles_of(const Mesh& mesh, double scale);
// Those of one face, by corners of the polygon, which holds its places in the mesh.
void cut_scaled(const Mesh& mesh, double scale, FacePolygon& polygon, std::vector<CornerTriangle>& out);

// A symmetric matrix by rows: one per vertex slot, empty unless it is a point with finite neighbours.
class Laplacian {
 public:
  struct Term {
    std::uint32_t point;
    double weight;
  };

  // O(n), a logarithm of the valence beside it.
  Laplacian(const Mesh& mesh, WeightKind kind, std::span<const Triangle> triangles);

  // Forms the weights for these places; uniform ones do not depend on them. O(n).
  void weigh(std::span<const Triangle> triangles, const Places& places);

  std::span<const Term> row(std::uint32_t point) const {
    return {terms_.data() + begin_[point], terms_.data() + begin_[point + 1]};
  }
  double sum(std::uint32_t point) const { return sums_[point]; }
  // The weighted mean of the neighbours; `here` where none counts.
  glm::dvec3 mean(std::uint32_t point, const Places& places, const glm::dvec3& here) const;

 private:
  void add(std::uint32_t a, std::uint32_t b, double weight);

  WeightKind kind_;
  std::vector<std::uint32_t> begin_;
  std::vector<Term> terms_;
  std::vector<double> sums_;
};

}  // namespace ryosen::smooth
