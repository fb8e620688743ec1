#include "ryosen/ops/rules/pinch_watch.h"

#include <algorithm>
#include <array>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

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
