#include "core/algo/remesh/sizing.h"

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

Target::Target(const Mesh& mesh, const SizeOptions& options)
    : options_(options), places_(mesh.positions().begin(), mesh.positions().end()) {
  std::vector<Primitive> triangles;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    const Halfedge h = mesh.halfedge(Face(i));
    triangles.push_back(Primitive::triangle(mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index, i));
  }
  tree_.build(places_, std::move(triangles));
  if (!options.adaptive) return;
  const std::vector<double> curvatures = largest_curvatures(mesh);
  for (const double curvature : curvatures) lengths_.push_back(length_for(curvature, options));
}

std::optional<Target::Nearest> Target::nearest(const glm::dvec3& place) const {
  const auto hit = tree_.nearest(places_, place, std::numeric_limits<double>::infinity());
  if (!hit) return std::nullopt;
  Nearest found{hit->place, options_.length};
  if (lengths_.empty()) return found;
  found.length = 0;
  const std::array<std::uint32_t, 3> corners = tree_.primitive(hit->slot).vertices;
  for (int k = 0; k < 3; ++k) found.length += hit->barycentric[k] * lengths_[corners[static_cast<std::size_t>(k)]];
  return found;
}

}  // namespace ryosen::remesh
