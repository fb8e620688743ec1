#include "ryosen/indexed/bridged_corners.h"

#include <algorithm>

#include "ryosen/geometry/bridge_loops.h"
#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

namespace {

// Loops without bridges in canonical form, independent of where each starts.
using LoopSet = std::vector<std::vector<std::uint32_t>>;

LoopSet normal_form(const CornerLoops& list, const LoopSet& places) {
  LoopSet loops;
  for (const auto& part : places) {
    std::vector<std::uint32_t>& loop = loops.emplace_back();
    for (std::uint32_t place : part) loop.push_back(list.corners[place]);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

// Whether every bridge of the mesh face is also a side of the list (whose loops are known to be equal).
bool has_bridges_of(const Mesh& mesh, Face f, std::span<const std::uint32_t> list) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (std::size_t i = 0; i < list.size(); ++i) sides.emplace_back(list[i], list[(i + 1) % list.size()]);
  std::sort(sides.begin(), sides.end());
  for (Halfedge h : halfedges_around(mesh, f)) {
    const std::pair side(point(mesh, mesh.from(h)).index, point(mesh, mesh.to(h)).index);
    if (is_bridge(mesh, h) && !std::binary_search(sides.begin(), sides.end(), side)) return false;
  }
  return true;
}

}  // namespace

bool visits_a_corner_twice(const Mesh& mesh, Face f) {
  if (mesh.has_rings(f)) return true;
  std::uint32_t corners = 0;
  for (Halfedge h : halfedges_around(mesh, f)) {
    ++corners;
    if (is_bridge(mesh, h)) return true;
    if (corners == 3 && mesh.next(h) == mesh.halfedge(f)) return false;
  }
  return false;
}

std::optional<std::vector<std::pair<Halfedge, std::size_t>>> corners_as_in_file(const Mesh& mesh, Face f,
                                                                                std::span<const std::uint32_t> list) {
  CornerLoops now, then;
  std::vector<std::pair<std::uint32_t, Halfedge>> corner_of;  // by point
  for_each_loop(mesh, f, [&](Halfedge start) {
    std::vector<std::uint32_t> points;
    for (Halfedge h : loop(mesh, start)) {
      points.push_back(point(mesh, mesh.from(h)).index);
      if (!is_bridge(mesh, h)) corner_of.emplace_back(points.back(), h);
    }
    now.add(points);
  });
  then.add(list);
  const auto parts_now = take_out_bridges(now), parts_then = take_out_bridges(then);
  if (!parts_now || !parts_then || normal_form(now, *parts_now) != normal_form(then, *parts_then)) return std::nullopt;
  if (!has_bridges_of(mesh, f, list)) return std::nullopt;
  std::sort(corner_of.begin(), corner_of.end());
  std::vector<std::pair<std::uint32_t, std::size_t>> place_of;  // by point, its index in the list
  for (const auto& part : *parts_then)
    for (std::uint32_t place : part) place_of.emplace_back(list[place], place);
  std::sort(place_of.begin(), place_of.end());
  std::vector<std::pair<Halfedge, std::size_t>> corners;
  for (std::uint32_t p : list) {
    const auto corner = std::lower_bound(corner_of.begin(), corner_of.end(), std::pair(p, Halfedge(0)));
    const auto place = std::lower_bound(place_of.begin(), place_of.end(), std::pair(p, std::size_t{0}));
    corners.emplace_back(corner->second, place->second);
  }
  return corners;
}

std::vector<Halfedge> corners_with_bridges(const Mesh& mesh, Face f) {
  const FacePolygon polygon(mesh, f);
  if (!mesh.has_rings(f)) return polygon.corners();
  std::vector<std::span<const glm::dvec3>> loops;
  std::uint32_t begin = 0;
  for (std::uint32_t end : polygon.loop_ends()) {
    loops.push_back(std::span(polygon.places()).subspan(begin, end - begin));
    begin = end;
  }
  std::vector<Halfedge> corners;
  for (std::uint32_t corner : bridge_loops(loops)) corners.push_back(polygon.corners()[corner]);
  return corners;
}

}  // namespace ryosen
