// Normals and angles of the triangles of a mesh, by one of their halfedges.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen::remesh {

using Corners = TriangleCorners;

// Of length 1, or 0 where there is no area.
inline glm::dvec3 unit_normal(const Mesh& mesh, Halfedge h) { return unit_or_zero(area_normal(corners_of(mesh, h))); }

constexpr double tiny = 1e-200;  // below, squares of squares are rounded

// Whether the normal of a triangle turns by less than the angle with this cosine; one without area may do anything that
// gives it one, and none may lose its own.
inline bool keeps_facing(const glm::dvec3& before, const glm::dvec3& after, double least_cosine) {
  const double product = glm::dot(before, after), square = glm::dot(before, before);
  if (!(square > 0)) return true;
  // No root where the sign of the cosine is at least 0.
  const double squares = square * glm::dot(after, after);
  if (least_cosine >= 0 && squares > tiny)
    return product > 0 && product * product > least_cosine * least_cosine * squares;
  const double lengths = glm::length(before) * glm::length(after);
  return lengths > 0 && product > least_cosine * lengths;
}

// The sine of the smallest angle; 0 without area.
inline double smallest_sine(const Corners& c) {
  const double a = glm::dot(c[1] - c[0], c[1] - c[0]), b = glm::dot(c[2] - c[1], c[2] - c[1]),
               d = glm::dot(c[0] - c[2], c[0] - c[2]);
  const double least = std::min({a, b, d}), longer = std::sqrt(a) * std::sqrt(b) * std::sqrt(d);
  return longer > 0 ? glm::length(area_normal(c)) * std::sqrt(least) / longer : 0;
}

// Whether the sine of the smallest angle is less, without a root where nothing is tiny.
inline bool is_narrower(const Corners& c, double sine) {
  const double a = glm::dot(c[1] - c[0], c[1] - c[0]), b = glm::dot(c[2] - c[1], c[2] - c[1]),
               d = glm::dot(c[0] - c[2], c[0] - c[2]);
  const double product = a * b * d;
  if (!(product > tiny)) return smallest_sine(c) < sine;
  const glm::dvec3 normal = area_normal(c);
  return glm::dot(normal, normal) * std::min({a, b, d}) < sine * sine * product;
}

// The cotangent of the angle at a, between b and c; large where there is no area.
inline double cotangent_at(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a, v = c - a;
  const double area = glm::length(glm::cross(u, v)), most = 1e12;
  const double product = glm::dot(u, v);
  return area * most > std::abs(product) ? product / area : product < 0 ? -most : most;
}

}  // namespace ryosen::remesh
