#include "ryosen/hull/hull_shape.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/hull/hull_measures.h"

namespace ryosen {

HullSize hull_size(std::span<const glm::dvec3> points, const ConvexHull& hull) {
  const hull::UnitPlaces places(points, hull.vertices);
  // From the first extreme point, so that no volume is taken away again.
  const glm::dvec3 origin = hull.vertices.empty() ? glm::dvec3(0.0) : places.by_axis(hull.vertices[0]);
  double six_volumes = 0, area = 0;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const std::span<const std::uint32_t> facet = hull.facet(f);
    for (std::size_t i = 2; i < facet.size(); ++i) {
      area += glm::length(hull::normal_of(places[facet[0]], places[facet[i - 1]], places[facet[i]])) / 2;
      if (hull.dimension == 3)
        six_volumes += hull::six_volumes_of(origin, places.by_axis(facet[0]), places.by_axis(facet[i - 1]),
                                            places.by_axis(facet[i]));
    }
  }
  return {places.full_volume(six_volumes / 6), places.full(area, 2)};
}

void add_hull(std::span<const glm::dvec3> points, const ConvexHull& hull, HullFaces faces, HullList& to) {
  IndexedMesh& list = to.list;
  const auto first = static_cast<std::uint32_t>(list.positions.size());
  for (const std::uint32_t i : hull.vertices) list.positions.push_back(points[i]);
  if (hull.dimension == 1) to.wires.emplace_back(first, first + 1);
  const auto add_corner = [&](std::uint32_t i) {
    const auto at = std::lower_bound(hull.vertices.begin(), hull.vertices.end(), i);
    list.corners.push_back(first + static_cast<std::uint32_t>(at - hull.vertices.begin()));
  };
  const auto end_face = [&] { list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size())); };
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const std::span<const std::uint32_t> facet = hull.facet(f);
    if (faces == HullFaces::facets) {
      for (const std::uint32_t i : facet) add_corner(i);
      end_face();
      continue;
    }
    for (std::size_t i = 2; i < facet.size(); ++i) {
      for (const std::uint32_t corner : {facet[0], facet[i - 1], facet[i]}) add_corner(corner);
      end_face();
    }
  }
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

Text size_sentence(const ConvexHull& hull, const HullSize& size) {
  if (hull.dimension < 2) return {};
  const std::string volume = hull::in_short(size.volume), area = hull::in_short(size.area);
  if (hull.dimension == 2) return {"Area " + area + ".", "面積 " + area + "。"};
  return {"Volume " + volume + ", area " + area + ".", "体積 " + volume + "、面積 " + area + "。"};
}

Text hulls_sentence(std::size_t count, std::size_t vertices, std::size_t facets, const HullSize& size) {
  const std::string parts = std::to_string(count), v = std::to_string(vertices), f = std::to_string(facets),
                    volume = hull::in_short(size.volume), area = hull::in_short(size.area);
  return {"The hulls of " + parts + " components have " + v + (vertices == 1 ? " vertex and " : " vertices and ") + f +
              (facets == 1 ? " facet" : " facets") + ". Volume " + volume + ", area " + area + " together.",
          "連結成分 " + parts + " 個の凸包は、合わせて頂点 " + v + " 個、面 " + f + " 枚です。体積の和 " + volume +
              "、面積の和 " + area + "。"};
}

ConvexHull hull_of_some(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers,
                        Progress& progress) {
  std::vector<glm::dvec3> places;
  places.reserve(numbers.size());
  for (const std::uint32_t i : numbers) places.push_back(points[i]);
  ConvexHull hull = convex_hull(places, progress);
  for (std::uint32_t& i : hull.vertices) i = numbers[i];
  for (std::uint32_t& i : hull.corners) i = numbers[i];
  return hull;
}

std::vector<std::vector<std::uint32_t>> joined_points(const IndexedMesh& list, const PointPairs& edges) {
  const auto count = static_cast<std::uint32_t>(list.positions.size());
  DisjointSets sets(count);
  for (std::size_t f = 0; f < list.face_count(); ++f)
    for (std::uint32_t k = list.face_offsets[f] + 1; k < list.face_offsets[f + 1]; ++k)
      sets.join(list.corners[k - 1], list.corners[k]);
  for (const auto& [a, b] : edges) sets.join(a, b);
  std::vector<std::vector<std::uint32_t>> parts;
  std::vector<std::uint32_t> part_of(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = sets.root(i);  // the lowest one
    if (root == i) {
      part_of[i] = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    parts[part_of[root]].push_back(i);
  }
  return parts;
}

}  // namespace ryosen
