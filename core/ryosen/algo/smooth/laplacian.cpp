#include "ryosen/algo/smooth/laplacian.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::smooth {

void cut_scaled(const Mesh& mesh, double scale, FacePolygon& polygon, std::vector<CornerTriangle>& out) {
  if (polygon.corners().size() > 3)
    for (const Halfedge corner : polygon.corners()) polygon.move(corner, scale * mesh.position(mesh.from(corner)));
  polygon.triangulate(out);
}

std::vector<Triangle> triangles_of(const Mesh& mesh, double scale) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.live().faces);
  FacePolygon polygon;
  std::vector<CornerTriangle> cut;
  for (const Face f : live_faces(mesh)) {
    polygon.read(mesh, f);
    if (!polygon.is_finite()) continue;
    cut_scaled(mesh, scale, polygon, cut);
    for (const CornerTriangle& t : cut) {
      Triangle points;
      for (std::size_t k = 0; k < 3; ++k) points[k] = point(mesh, mesh.from(polygon.corners()[t[k]])).index;
      triangles.push_back(points);
    }
  }
  return triangles;
}

Laplacian::Laplacian(const Mesh& mesh, WeightKind kind, std::span<const Triangle> triangles)
    : kind_(kind), begin_(std::size_t{mesh.vertex_slots()} + 1, 0), sums_(mesh.vertex_slots(), 0.0) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // that are joined
  for (const Edge e : live_edges(mesh)) {
    if (mesh.is_wire(e)) continue;
    const auto [a, b] = ends(mesh, e);
    if (is_finite(mesh.position(a)) && is_finite(mesh.position(b)))
      pairs.emplace_back(point(mesh, a).index, point(mesh, b).index);
  }
  if (kind == WeightKind::cotangent)
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) pairs.emplace_back(t[k], t[(k + 1) % 3]);
  // Both ways, by counting; then each row for itself.
  for (const auto& [a, b] : pairs) {
    ++begin_[a + 1];
    ++begin_[b + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
  terms_.resize(begin_.back());
  for (const auto& [a, b] : pairs) {
    terms_[at[a]++] = {b, 1};
    terms_[at[b]++] = {a, 1};
  }
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i + 1 < begin_.size(); ++i) {
    const auto first = terms_.begin() + begin_[i], last = terms_.begin() + at[i];
    std::sort(first, last, [](const Term& x, const Term& y) { return x.point < y.point; });
    const auto end = std::unique(first, last, [](const Term& x, const Term& y) { return x.point == y.point; });
    begin_[i] = kept;
    for (auto term = first; term != end; ++term)
      if (term->point != i) terms_[kept++] = *term;
  }
  begin_.back() = kept;
  terms_.resize(kept);
  for (std::uint32_t i = 0; i < sums_.size(); ++i) sums_[i] = static_cast<double>(row(i).size());
}

void Laplacian::add(std::uint32_t a, std::uint32_t b, double weight) {
  const auto first = terms_.begin() + begin_[a], last = terms_.begin() + begin_[a + 1];
  const auto term =
      std::lower_bound(first, last, b, [](const Term& t, std::uint32_t wanted) { return t.point < wanted; });
  if (term != last && term->point == b) term->weight += weight;
}

void Laplacian::weigh(std::span<const Triangle> triangles, const Places& places) {
  if (kind_ == WeightKind::uniform) return;
  for (Term& term : terms_) term.weight = 0;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const glm::dvec3 u = places[a] - places[corner], v = places[b] - places[corner];
      const double area = glm::length(glm::cross(u, v));
      if (!(area > 0)) continue;
      constexpr double most = 1e6;  // of needles
      const double weight = std::clamp(glm::dot(u, v) / area, -most, most) / 2;
      add(a, b, weight);
      add(b, a, weight);
    }
  const auto points = static_cast<std::uint32_t>(sums_.size());
  for_each_part(points, threads_for(terms_.size()), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      double sum = 0;
      for (std::uint32_t k = begin_[i]; k < begin_[i + 1]; ++k) {
        terms_[k].weight = std::max(0.0, terms_[k].weight);
        sum += terms_[k].weight;
      }
      sums_[i] = sum;
    }
  });
}

glm::dvec3 Laplacian::mean(std::uint32_t i, const Places& places, const glm::dvec3& here) const {
  if (!(sums_[i] > 0)) return here;
  glm::dvec3 sum(0);
  for (const Term& term : row(i)) sum += term.weight * (places[term.point] - here);
  return here + sum / sums_[i];
}

}  // namespace ryosen::smooth
