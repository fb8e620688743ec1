// Samples of a surface as it was before it was simplified, each at the nearest face of now about it: what tells how far
// both lie from each other.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/base/progress.h"
#include "ryosen/geometry/closest.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/geometry/trees/triangle_tree.h"

namespace ryosen {

class NearSamples {
 public:
  // `input`: the mesh as it was, whose vertices have the same numbers. Its triangles at finite places and without rings
  // are sampled at their middles and corners. Both must outlive it. O(n).
  NearSamples(const Mesh& input, const CollapseSurface& surface);

  // Whether every face of the input is sampled.
  bool cover_input() const { return covers_input_; }
  struct Sample {
    glm::dvec3 place{0.0};
    double area = 0;  // that it stands for: so an integral over a triangle is exact for polynomials of degree two
  };
  std::size_t size() const { return sample_places_.size(); }
  Sample sample(std::uint32_t i) const { return {sample_places_[i], sample_areas_[i]}; }
  // The vertices of the input in whose middle it is: those of a triangle, or three times the same one.
  std::array<Vertex, 3> corners(std::uint32_t i) const;
  // A corner of the input at a triangle that it is on.
  Halfedge corner_of_input(std::uint32_t i) const;

  // Gives each sample to the face that it is nearest to: where it need not be exact, to one to which no other about it
  // is nearer. False where it is cancelled. `merged`: by vertex, the one that it has become, or none where it is there
  // still. Samples at vertices that are gone altogether have no face. O(n), and O(n log n) where it is exact or there
  // are hubs.
  bool assign(std::span<const Vertex> merged, bool is_exact, Progress& progress);
  template <class Visit>
  void for_each(Face f, const Visit& visit) const {
    for (std::uint32_t i = first_[f.index]; i != no_index; i = next_[i]) visit(i);
  }
  // Takes all samples of a face.
  void take(Face f, std::vector<std::uint32_t>& taken);
  void give(Face f, std::uint32_t i) {
    next_[i] = first_[f.index];
    first_[f.index] = i;
  }

 private:
  class Search;
  // The samples of now by the vertices that theirs have become: those of vertex v begin at begins[v].
  std::vector<std::uint32_t> take_samples(std::span<const Vertex> merged);
  bool is_sampled(Face f) const;
  Sample middle_of(Face f) const;

  const Mesh& input_;
  const CollapseSurface& surface_;
  bool covers_input_ = true;
  std::vector<float> vertex_areas_;        // by vertex of the input
  std::vector<glm::dvec3> sample_places_;  // near ones are near in memory too
  std::vector<float> sample_areas_;
  std::vector<std::uint32_t> numbers_;  // by sample its face in the input, or behind all its vertex
  std::vector<std::uint32_t> first_;    // by face, its first sample
  std::vector<std::uint32_t> next_;     // by sample, the next one of its face
};

inline NearestPlace nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& place) {
  return nearest_place(corners, Primitive::triangle(0, 1, 2, 0), place);
}
// The square of the distance.
inline double square_from_triangle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& place) {
  return squared(way_from_triangle(corners[0], corners[1], corners[2], place));
}
// A plain triangle, its owner the face.
Primitive triangle_primitive(const Mesh& mesh, Face f);
// The triangles of a mesh without rings whose corners have finite places.
std::vector<Primitive> plain_triangles(const Mesh& mesh, std::span<const glm::dvec3> places);
// The tree of the input, in the scale of the surface. O(n log n).
TriangleTree tree_of_input(const Mesh& input, const CollapseSurface& surface);

}  // namespace ryosen
