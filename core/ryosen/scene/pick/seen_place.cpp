#include "ryosen/scene/pick/seen_place.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ryosen {

bool is_seen(const Bvh& tree, const Mesh& mesh, const Ray& ray, const glm::dvec3& place, Face own,
             const IndexSet* passed_over) {
  const auto hit = tree.cast(mesh.positions(), ray, passed_over);
  if (!hit || (own && tree.primitive(hit->slot).owner == own.index)) return true;
  constexpr double tolerance = 1e-7;
  const double t = glm::dot(place - ray.origin, ray.direction);
  return hit->t >= t - tolerance * std::abs(t);
}

}  // namespace ryosen
