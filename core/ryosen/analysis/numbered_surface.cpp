#include "ryosen/analysis/numbered_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "ryosen/base/interruption.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

NumberedSurface::NumberedSurface(const Mesh& mesh) : places_(mesh.positions().begin(), mesh.positions().end()) {
  const std::size_t expected = mesh.live().faces;
  corners_.reserve(expected);
  faces_.reserve(expected);
  sides_.reserve(expected);
  for (const Face f : live_faces(mesh)) add(mesh, f);
  choose_frame();
  if (!mesh.has_copies()) return;
  for (auto& corners : corners_)
    for (std::uint32_t& corner : corners) corner = point(mesh, Vertex(corner)).index;
}

NumberedSurface::NumberedSurface(const Mesh& mesh, std::span<const Face> faces) {
  for (const Face f : faces) add(mesh, f);
  std::vector<Vertex> points;
  for (auto& corners : corners_)
    for (std::uint32_t& corner : corners) points.emplace_back(corner = point(mesh, Vertex(corner)).index);
  sort_unique(points);
  for (const Vertex v : points) places_.push_back(mesh.position(v));
  for (auto& corners : corners_)
    for (std::uint32_t& corner : corners)
      corner =
          static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), Vertex(corner)) - points.begin());
  choose_frame();
}

NumberedSurface::NumberedSurface(std::vector<glm::dvec3> places, std::vector<std::array<std::uint32_t, 3>> corners)
    : corners_(std::move(corners)), sides_(corners_.size(), 7), places_(std::move(places)) {
  for (std::uint32_t i = 0; i < corners_.size(); ++i) faces_.emplace_back(i);
  choose_frame();
}

void NumberedSurface::add(const Mesh& mesh, Face f) {
  stop_if_interrupted();
  polygon_.read(mesh, f);
  if (!polygon_.is_finite()) return;
  polygon_.triangulate(triangles_);
  for (const CornerTriangle& t : triangles_) {
    const auto vertex = [&](std::size_t k) { return mesh.from(polygon_.corners()[t[k]]).index; };
    corners_.push_back({vertex(0), vertex(1), vertex(2)});
    faces_.push_back(f);
    unsigned sides = 0;
    for (unsigned k = 0; k < 3; ++k) sides |= unsigned{polygon_.is_side(t[k], t[(k + 1) % 3])} << k;
    sides_.push_back(static_cast<std::uint8_t>(sides));
  }
}

NumberedTriangle NumberedSurface::triangle(std::uint32_t slot) const {
  const auto& [a, b, c] = corners_[slot];
  return {{places_[a], places_[b], places_[c]}, corners_[slot], sides_[slot]};
}

bool NumberedSurface::is_flat(std::uint32_t slot) const {
  const auto& [a, b, c] = corners_[slot];
  return are_collinear(places_[a], places_[b], places_[c]);
}

std::vector<std::uint32_t> NumberedSurface::triangles_at_points() const {
  std::vector<std::uint32_t> count(places_.size(), 0);
  for (const auto& corners : corners_)
    for (const std::uint32_t v : corners) ++count[v];
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
      for (const std::uint32_t v : corners_[part_begin(slots(), k, samples)]) places.push_back(places_[v][axis]);
    std::sort(places.begin(), places.end());
    const std::size_t quarter = places.size() / 4;
    origin_[axis] = places[2 * quarter];
    size = std::max(size, places[places.size() - 1 - quarter] * 0.5 - places[quarter] * 0.5);
  }
  if (size > 0.0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
}

}  // namespace ryosen
