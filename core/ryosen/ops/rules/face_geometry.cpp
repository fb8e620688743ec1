#include "ryosen/ops/rules/face_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/predicates.h"

namespace ryosen {

bool FaceGeometry::is_degenerate() const { return are_collinear(corners_); }

glm::dvec3 FaceGeometry::area_vector() const {
  glm::dvec3 sum{};
  for (std::size_t i = 1; i + 1 < corners_.size(); ++i)
    sum += glm::cross(corners_[i] - corners_[0], corners_[i + 1] - corners_[0]);
  return sum;
}

bool FaceGeometry::turns_against(const FaceGeometry& after) const {
  const glm::dvec3 n = area_vector(), n_after = after.area_vector();
  if (n == glm::dvec3() || n_after == glm::dvec3()) return false;
  return glm::dot(n, n_after) <= 0;
}

void ShapeDoubts::compare(const FaceGeometry& before, const FaceGeometry& after, Element what) {
  if (!before.is_degenerate() && after.is_degenerate())
    degenerate.push_back(what);
  else if (before.turns_against(after))
    turned.push_back(what);
}

void ShapeDoubts::add_to(std::vector<Reason>& reasons) const {
  if (!turned.empty()) reasons.push_back({Rule::normal_turns, turned});
  if (!degenerate.empty()) reasons.push_back({Rule::degenerate, degenerate});
}

std::vector<Reason> warnings_of_parts(Face face, const FaceGeometry& before, std::span<const FaceGeometry> parts) {
  std::vector<Reason> found;
  if (before.is_degenerate()) return found;
  if (std::any_of(parts.begin(), parts.end(), [&](const FaceGeometry& part) { return before.turns_against(part); }))
    found.push_back({Rule::normal_turns, {face}});
  if (std::any_of(parts.begin(), parts.end(), [](const FaceGeometry& part) { return part.is_degenerate(); }))
    found.push_back({Rule::degenerate, {face}});
  return found;
}

glm::dvec3 point_between(const glm::dvec3& a, const glm::dvec3& b, double t) {
  const glm::dvec3 p = a + t * (b - a);
  return is_finite(p) ? p : (1 - t) * a + t * b;
}

double closest_parameter(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  if (p == a) return 0;
  if (p == b) return 1;
  const glm::dvec3 d = b - a;
  const double t = glm::dot(p - a, d) / glm::dot(d, d);
  if (std::isfinite(t)) return std::clamp(t, 0.0, 1.0);
  // Squares may overflow or vanish where lengths do not.
  const double size = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  const double scaled = glm::dot((p - a) / size, d / size) / glm::dot(d / size, d / size);
  return std::isfinite(scaled) ? std::clamp(scaled, 0.0, 1.0) : 1.0;
}

}  // namespace ryosen
