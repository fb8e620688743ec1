#include "ryosen/algo/simplify/input_sides.h"

#include <glm/geometric.hpp>
#include <limits>

#include "ryosen/algo/unit_scale.h"
#include "ryosen/geometry/closest.h"
#include "ryosen/geometry/frustum.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

InputSides::InputSides(const Mesh& input, const std::vector<std::uint8_t>& is_asked_about)
    : input_(input), scale_(unit_scale(input.positions())) {
  places_.reserve(input.vertex_slots());
  for (const glm::dvec3& p : input.positions()) places_.push_back(scale_ * p);
  std::vector<Primitive> faces;
  for (std::uint32_t i = 0; i < is_asked_about.size(); ++i) {
    if (!is_asked_about[i] || !input.is_alive(Vertex(i)) || input.is_isolated(Vertex(i))) continue;
    for (Halfedge h : outgoing(input, Vertex(i))) {
      if (input.is_outside(h)) continue;
      const std::uint32_t b = input.to(h).index, c = input.from(input.prev(h)).index;
      // Each once, at the first of its vertices.
      if ((is_asked_about[b] && b < i) || (is_asked_about[c] && c < i)) continue;
      const glm::dvec3 normal = area_normal({places_[i], places_[b], places_[c]});
      if (glm::dot(normal, normal) > 0) faces.push_back(Primitive::triangle(i, b, c, input.face(h).index));
    }
  }
  tree_.build(places_, std::move(faces));
}

TriangleCorners InputSides::corners(Face f) const {
  const Halfedge h = input_.halfedge(f);
  return {places_[input_.from(h).index], places_[input_.to(h).index], places_[input_.from(input_.prev(h)).index]};
}

bool InputSides::looks_against(Face f, const glm::dvec3& normal) const {
  const glm::dvec3 own = area_normal(corners(f));
  return glm::dot(own, own) > 0 && !(glm::dot(own, normal) > 0);
}

bool InputSides::is_turned(const TriangleCorners& unscaled) const {
  const TriangleCorners triangle{scale_ * unscaled[0], scale_ * unscaled[1], scale_ * unscaled[2]};
  const glm::dvec3 normal = area_normal(triangle), middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  if (!(glm::dot(normal, normal) > 0)) return false;
  const auto hit = tree_.nearest(places_, middle, std::numeric_limits<double>::infinity());
  if (!hit) return false;
  // On a side or corner of the nearest one others are as near, within rounding.
  constexpr double rounding_rel = 1e-9;
  const double as_near = (1 + rounding_rel) * hit->distance;
  const glm::dvec3 reach(rounding_rel * hit->distance);
  bool found = false;
  tree_.visit_frustum(places_, frustum_of_box({hit->place - reach, hit->place + reach}), [&](std::uint32_t slot) {
    ++looks_;
    const Face f(tree_.primitive(slot).owner);
    if (found || !looks_against(f, normal)) return;
    const auto [a, b, c] = corners(f);
    found = glm::length(way_from_triangle(a, b, c, middle)) <= as_near;
  });
  return found;
}

}  // namespace ryosen
