#include "core/analysis/numbered_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/geometry/predicates.h"
#include "core/mesh/copies.h"

namespace ryosen {

NumberedSurface::NumberedSurface(const Mesh& mesh) : mesh_(mesh), triangles_(mesh) {
  choose_frame();
  if (!mesh.has_copies()) return;
  point_.assign(mesh.vertex_slots(), no_index);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (mesh.is_alive(Vertex(i)) && point_[i] == no_index)
      for_each_copy(mesh, Vertex(i), [&](Vertex copy) { point_[copy.index] = i; });
}

NumberedTriangle NumberedSurface::triangle(std::uint32_t slot) const {
  NumberedTriangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = triangles_.triangles()[slot][k];
    t.places[k] = mesh_.position(Vertex(v));
    t.numbers[k] = point(v);
  }
  t.sides = triangles_.edge_bits()[slot];
  return t;
}

bool NumberedSurface::is_flat(std::uint32_t slot) const {
  const auto& [a, b, c] = triangles_.triangles()[slot];
  return are_collinear(mesh_.position(Vertex(a)), mesh_.position(Vertex(b)), mesh_.position(Vertex(c)));
}

std::vector<std::uint32_t> NumberedSurface::triangles_at_points() const {
  std::vector<std::uint32_t> count(mesh_.vertex_slots(), 0);
  for (std::uint32_t slot = 0; slot < slots(); ++slot)
    if (face(slot))
      for (const std::uint32_t v : triangles_.triangles()[slot]) ++count[point(v)];
  return count;
}

glm::dvec3 NumberedSurface::scaled_normal(const NumberedTriangle& t) const {
  const glm::dvec3 to_b = t.places[1] * scale_ - t.places[0] * scale_;
  const glm::dvec3 to_c = t.places[2] * scale_ - t.places[0] * scale_;
  return glm::cross(to_b, to_c);
}

// From the interquartile range of a sample of positions, so that outliers do not shrink the rest.
void NumberedSurface::choose_frame() {
  constexpr std::uint32_t most_samples = 1000;
  const std::uint32_t samples = std::min(slots(), most_samples);
  if (samples == 0) return;
  double size = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> places;
    for (std::uint32_t k = 0; k < samples; ++k)
      for (const std::uint32_t v : triangles_.triangles()[part_begin(slots(), k, samples)])
        if (const double place = mesh_.position(Vertex(v))[axis]; std::isfinite(place)) places.push_back(place);
    if (places.empty()) return;
    std::sort(places.begin(), places.end());
    const std::size_t quarter = places.size() / 4;
    origin_[axis] = places[2 * quarter];
    size = std::max(size, places[places.size() - 1 - quarter] * 0.5 - places[quarter] * 0.5);
  }
  if (size > 0.0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
}

}  // namespace ryosen
