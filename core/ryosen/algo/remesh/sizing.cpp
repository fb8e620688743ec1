#include "ryosen/algo/remesh/sizing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ryosen::remesh {

std::vector<double> largest_curvatures(const Mesh& mesh) {
  const std::uint32_t n = mesh.vertex_slots();
  std::vector<glm::dvec3> bends(n, glm::dvec3(0));
  std::vector<double> areas(n, 0), angles(n, 0), found(n, 0);
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    const Halfedge start = mesh.halfedge(Face(i));
    const double area = glm::length(area_normal(corners_of(mesh, start))) / 2;
    if (!(area > 0)) continue;
    for (const Halfedge h : loop(mesh, start)) {
      const Corners c = corners_of(mesh, h);
      const std::uint32_t at = mesh.from(h).index, a = mesh.to(h).index, b = mesh.from(mesh.prev(h)).index;
      const double weight = cotangent_at(c[0], c[1], c[2]) / 2;
      bends[a] += weight * (c[2] - c[1]);
      bends[b] += weight * (c[1] - c[2]);
      areas[at] += area / 3;
      angles[at] += std::atan2(2 * area, glm::dot(c[1] - c[0], c[2] - c[0]));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!mesh.is_alive(Vertex(i)) || mesh.is_boundary(Vertex(i)) || !(areas[i] > 0)) continue;
    const double mean = glm::length(bends[i]) / (2 * areas[i]);
    const double gaussian = (2 * std::numbers::pi - angles[i]) / areas[i];
    found[i] = mean + std::sqrt(std::max(0.0, mean * mean - gaussian));
  }
  return found;
}

namespace {

double length_for(double curvature, const SizeOptions& options) {
  const double square = curvature > 0 ? 6 * options.tolerance / curvature - 3 * options.tolerance * options.tolerance
                                      : std::numeric_limits<double>::infinity();
  return std::clamp(std::sqrt(std::max(0.0, square)), options.length / 8, options.length);
}

}  // namespace

Sizing::Sizing(const Mesh& mesh, const SizeOptions& options) : options_(options) {
  if (!options.adaptive) return;
  for (const double curvature : largest_curvatures(mesh)) lengths_.push_back(length_for(curvature, options));
}

}  // namespace ryosen::remesh
