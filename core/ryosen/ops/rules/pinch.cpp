#include "ryosen/ops/rules/pinch.h"

#include <algorithm>
#include <map>

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"

namespace ryosen {

namespace {

// The face corners at one point, each given by the previous and next point along its face.
class CornersAtPoint {
 public:
  void add(std::uint32_t before, std::uint32_t after) { corners_.emplace_back(before, after); }
  // Collects those at all copies of a point in faces accepted by `counts`.
  template <class Counts>
  void gather(const Mesh& mesh, Vertex p, Counts counts) {
    for_each_copy(mesh, p, [&](Vertex copy) {
      for (Halfedge h : outgoing(mesh, copy))
        if (!mesh.is_outside(h) && counts(mesh.face(h)))
          add(point(mesh, mesh.from(mesh.prev(h))).index, point(mesh, mesh.to(h)).index);
    });
  }
  // Renames a point.
  void replace(std::uint32_t goes, std::uint32_t stays) {
    for (auto& [before, after] : corners_) {
      if (before == goes) before = stays;
      if (after == goes) after = stays;
    }
  }

  // Number of groups of corners connected through shared neighbours.
  std::size_t fans() const {
    std::vector<std::uint32_t> neighbours;
    for (const auto& [before, after] : corners_) neighbours.insert(neighbours.end(), {before, after});
    sort_unique(neighbours);
    const auto place = [&](std::uint32_t p) {
      const auto found = std::lower_bound(neighbours.begin(), neighbours.end(), p);
      return static_cast<std::uint32_t>(found - neighbours.begin());
    };
    DisjointSets sets(neighbours.size());
    for (const auto& [before, after] : corners_) sets.join(place(before), place(after));
    return sets.count();
  }

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> corners_;
};

constexpr auto any_face = [](Face) { return true; };

}  // namespace

std::vector<Vertex> pinched_by_face(const Mesh& mesh, std::span<const std::uint32_t> loop) {
  // With bridges a loop may visit a point more than once.
  std::map<std::uint32_t, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < loop.size(); ++i) places[loop[i]].push_back(i);
  std::vector<Vertex> found;
  for (const auto& [p, at] : places) {
    CornersAtPoint corners;
    corners.gather(mesh, Vertex(p), any_face);
    const std::size_t before = corners.fans();
    for (std::size_t i : at) corners.add(loop[(i + loop.size() - 1) % loop.size()], loop[(i + 1) % loop.size()]);
    if (before > 0 && corners.fans() > before) found.push_back(Vertex(p));
  }
  return found;
}

std::vector<Vertex> pinched_without(const Mesh& mesh, std::span<const Face> faces, bool apart) {
  std::vector<Vertex> points;
  for (Face f : faces)
    for (Vertex v : vertices_around(mesh, f)) points.push_back(point(mesh, v));
  sort_unique(points);
  const auto goes = [&](Face f) { return std::binary_search(faces.begin(), faces.end(), f); };
  std::erase_if(points, [&](Vertex p) {
    CornersAtPoint all, rest, away;
    all.gather(mesh, p, any_face);
    rest.gather(mesh, p, [&](Face f) { return !goes(f); });
    if (apart) away.gather(mesh, p, goes);
    return std::max(rest.fans(), away.fans()) <= all.fans();
  });
  return points;
}

std::vector<Vertex> pinched_by_weld(const Mesh& mesh, std::span<const std::pair<Vertex, Vertex>> pairs) {
  std::vector<Vertex> found;
  for (const auto& [goes, stays] : pairs) {
    CornersAtPoint joined, one, other;
    one.gather(mesh, goes, any_face);
    other.gather(mesh, stays, any_face);
    for (Vertex p : {goes, stays}) joined.gather(mesh, p, any_face);
    for (const auto& [from, to] : pairs) joined.replace(from.index, to.index);
    if (joined.fans() > std::max(one.fans(), other.fans())) found.push_back(std::min(goes, stays));
  }
  return found;
}

std::vector<Reason> warnings_of_face_in(const Mesh& mesh, Halfedge outside) {
  std::vector<Reason> reasons;
  if (FaceGeometry(places_along(mesh, outside)).is_degenerate()) reasons.push_back({Rule::degenerate, {edge(outside)}});
  warn_of_pinch(pinched_by_face(mesh, points_along(mesh, outside)), reasons);
  return reasons;
}

void warn_of_pinch(const std::vector<Vertex>& points, std::vector<Reason>& reasons) {
  if (!points.empty()) reasons.push_back({Rule::pinch, {points.begin(), points.end()}});
}

}  // namespace ryosen
