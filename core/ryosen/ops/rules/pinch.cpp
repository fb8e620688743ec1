#include "ryosen/ops/rules/pinch.h"

#include <algorithm>
#include <array>
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

// By point.
std::vector<PinchWatch::Corner> PinchWatch::corners_of(std::span<const Face> faces) const {
  std::vector<Corner> corners;
  for (const Face f : faces)
    for (const Halfedge h : halfedges_around(mesh_, f)) {
      const Vertex before = mesh_.from(mesh_.prev(h)), after = mesh_.to(h);
      corners.push_back({point(mesh_, mesh_.from(h)), point(mesh_, before), point(mesh_, after)});
    }
  std::stable_sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.point < b.point; });
  return corners;
}

PinchWatch::Corners& PinchWatch::corners_at(Vertex p) {
  const auto [watched, is_new] = watched_.try_emplace(p);
  Corners& corners = watched->second;
  if (!is_new) return corners;
  for_each_copy(mesh_, p, [&](Vertex copy) {
    for (const Halfedge h : outgoing(mesh_, copy)) {
      ++looks_;
      if (!mesh_.is_outside(h)) add(corners, point(mesh_, mesh_.from(mesh_.prev(h))), point(mesh_, mesh_.to(h)));
    }
  });
  return corners;
}

void PinchWatch::add(Corners& corners, Vertex before, Vertex after) {
  ++corners[before][after];
  if (before != after) ++corners[after][before];
}

void PinchWatch::remove(Corners& corners, Vertex before, Vertex after) {
  const auto leave = [&](Vertex from, Vertex to) {
    const auto beside = corners.find(from);
    const auto joined = beside->second.find(to);
    if (--joined->second > 0) return;
    beside->second.erase(joined);
    if (beside->second.empty()) corners.erase(beside);
  };
  leave(before, after);
  if (before != after) leave(after, before);
}

// Walks from both in step: the side that ends first has met all that hangs together with it.
bool PinchWatch::are_joined(const Corners& corners, Vertex a, Vertex b) {
  struct Walk {
    std::vector<Vertex> met;
    std::size_t at = 0;
    Beside::const_iterator next;
  };
  std::array<Walk, 2> walks{Walk{{a}, 0, corners.at(a).begin()}, Walk{{b}, 0, corners.at(b).begin()}};
  std::unordered_map<Vertex, int> sides{{a, 0}, {b, 1}};
  for (int side = 0;; side = 1 - side) {
    ++looks_;
    auto& [met, at, next] = walks[static_cast<std::size_t>(side)];
    while (next == corners.at(met[at]).end()) {
      if (++at == met.size()) return false;
      next = corners.at(met[at]).begin();
    }
    const Vertex v = (next++)->first;
    const auto [known, is_new] = sides.try_emplace(v, side);
    if (is_new)
      met.push_back(v);
    else if (known->second != side)
      return true;
  }
}

// Takes the corner away.
int PinchWatch::parts_more_without(Corners& corners, const Corner& corner) {
  ++looks_;
  remove(corners, corner.before, corner.after);
  const bool stays_before = corners.contains(corner.before), stays_after = corners.contains(corner.after);
  if (!stays_before && !stays_after) return -1;
  if (!stays_before || !stays_after || corner.before == corner.after) return 0;
  return are_joined(corners, corner.before, corner.after) ? 0 : 1;
}

bool PinchWatch::is_pinched_without(std::span<const Face> faces) {
  const std::vector<Corner> corners = corners_of(faces);
  for (auto begin = corners.begin(); begin != corners.end();) {
    const auto end = std::find_if(begin, corners.end(), [&](const Corner& c) { return c.point != begin->point; });
    Corners& at = corners_at(begin->point);
    int more = 0;
    std::for_each(begin, end, [&](const Corner& c) { more += parts_more_without(at, c); });
    std::for_each(begin, end, [&](const Corner& c) { add(at, c.before, c.after); });
    if (more > 0) return true;
    begin = end;
  }
  return false;
}

void PinchWatch::loses(std::span<const Face> faces) {
  if (watched_.empty()) return;
  for (const Corner& corner : corners_of(faces))
    if (const auto watched = watched_.find(corner.point); watched != watched_.end())
      remove(watched->second, corner.before, corner.after);
}

}  // namespace ryosen
