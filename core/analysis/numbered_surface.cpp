#include "core/analysis/numbered_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

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

void NumberedSurface::choose_frame() {
  glm::dvec3 lowest(std::numeric_limits<double>::infinity()), highest(-lowest);
  for (const auto& triangle : triangles_.triangles())
    for (const std::uint32_t v : triangle) {
      lowest = glm::min(lowest, mesh_.position(Vertex(v)));
      highest = glm::max(highest, mesh_.position(Vertex(v)));
    }
  if (slots() == 0) return;
  origin_ = lowest * 0.5 + highest * 0.5;
  const glm::dvec3 half = highest * 0.5 - lowest * 0.5;
  const double size = std::max({half.x, half.y, half.z});
  if (size > 0.0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
}

}  // namespace ryosen
