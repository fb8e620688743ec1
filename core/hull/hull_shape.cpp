#include "core/hull/hull_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

// Places relative to the first vertex in units of a power of two, below 1 in magnitude, so that no product overflows and
// only what is far below the others underflows.
class UnitPlaces {
 public:
  UnitPlaces(std::span<const glm::dvec3> points, const ConvexHull& hull) : points_(points) {
    if (hull.vertices.empty()) return;
    half_origin_ = points[hull.vertices[0]] / 2.0;
    double largest = 0;
    for (const std::uint32_t i : hull.vertices) {
      const glm::dvec3 d = points[i] / 2.0 - half_origin_;
      largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    if (largest > 0) std::frexp(largest, &exponent_);
  }
  glm::dvec3 operator[](std::uint32_t i) const {
    const glm::dvec3 d = points_[i] / 2.0 - half_origin_;
    return {std::ldexp(d.x, -exponent_), std::ldexp(d.y, -exponent_), std::ldexp(d.z, -exponent_)};
  }
  // A number of so many dimensions in units of the points.
  double full(double value, int dimensions) const { return std::ldexp(value, dimensions * (exponent_ + 1)); }

 private:
  std::span<const glm::dvec3> points_;
  glm::dvec3 half_origin_{0.0};
  int exponent_ = 0;
};

}  // namespace

HullSize hull_size(std::span<const glm::dvec3> points, const ConvexHull& hull) {
  const UnitPlaces places(points, hull);
  double six_volumes = 0, area = 0;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const std::span<const std::uint32_t> facet = hull.facet(f);
    const glm::dvec3 a = places[facet[0]];
    glm::dvec3 normal(0.0);
    for (std::size_t i = 2; i < facet.size(); ++i) normal += glm::cross(places[facet[i - 1]] - a, places[facet[i]] - a);
    area += glm::length(normal) / 2;
    six_volumes += glm::dot(a, normal);
  }
  return {hull.dimension == 3 ? places.full(six_volumes / 6, 3) : 0.0, places.full(area, 2)};
}

HullList hull_list(std::span<const glm::dvec3> points, const ConvexHull& hull, HullFaces faces) {
  HullList result;
  IndexedMesh& list = result.list;
  list.positions.reserve(hull.vertices.size());
  for (const std::uint32_t i : hull.vertices) list.positions.push_back(points[i]);
  if (hull.dimension == 1) result.wires.emplace_back(0, 1);
  std::vector<std::uint32_t> number(hull.vertices.empty() ? 0 : hull.vertices.back() + std::size_t{1});
  for (std::uint32_t i = 0; i < hull.vertices.size(); ++i) number[hull.vertices[i]] = i;
  const auto end_face = [&] { list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size())); };
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const std::span<const std::uint32_t> facet = hull.facet(f);
    if (faces == HullFaces::facets) {
      for (const std::uint32_t i : facet) list.corners.push_back(number[i]);
      end_face();
      continue;
    }
    for (std::size_t i = 2; i < facet.size(); ++i) {
      for (const std::uint32_t corner : {facet[0], facet[i - 1], facet[i]}) list.corners.push_back(number[corner]);
      end_face();
    }
  }
  return result;
}

Text hull_sentence(const ConvexHull& hull) {
  const std::string vertices = std::to_string(hull.vertices.size()), facets = std::to_string(hull.facet_count());
  switch (hull.dimension) {
    case -1:
      return {"There is no point, so the hull is empty (dimension -1).", "点がないため、凸包は空です（次元 -1）。"};
    case 0:
      return {"All points lie at one place: the hull is that point (dimension 0).",
              "すべての点が同じ位置にあり、凸包はその点です（次元 0）。"};
    case 1:
      return {"All points lie on a line: the hull is a segment (dimension 1).",
              "すべての点が一直線上にあり、凸包は線分です（次元 1）。"};
    case 2:
      return {"All points lie in a plane: the hull is a polygon of " + vertices + " vertices (dimension 2).",
              "すべての点が一平面上にあり、凸包は頂点 " + vertices + " 個の多角形です（次元 2）。"};
    default:
      return {"The hull is a solid of " + vertices + " vertices and " + facets + " facets (dimension 3).",
              "凸包は頂点 " + vertices + " 個、面 " + facets + " 枚の立体です（次元 3）。"};
  }
}

}  // namespace ryosen
