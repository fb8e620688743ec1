#include "ryosen/indexed/fans.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

// A fan of faces at a point: one of its outgoing halfedges (the outside one if it has any), its lowest face.
struct CornerFan {
  std::uint32_t point;
  Face lowest_face;
  Halfedge halfedge;
};

Halfedge counter_clockwise(const MeshColumns& c, Halfedge h) { return twin(c.halfedges[h.index].prev); }

// Calls visit(halfedge) around a fan; the visit may write all but the links that are gone along.
template <class Visit>
void for_each_of_fan(const MeshColumns& c, Halfedge start, Visit visit) {
  Halfedge h = start;
  do {
    visit(h);
    h = counter_clockwise(c, h);
  } while (h != start);
}

// Total size of the fans reached from vertex_halfedge, for the vertices begin .. end-1. Walks around several vertices
// are interleaved, so that their cache misses overlap.
std::size_t count_in_fans(const MeshColumns& c, std::uint32_t begin, std::uint32_t end) {
  struct Walk {
    Halfedge start, at;
  };
  std::array<Walk, 16> walks;
  std::size_t active = 0, count = 0;
  std::uint32_t v = begin;
  const auto start_next = [&](Walk& walk) {
    while (v < end) {
      const Halfedge h = c.vertex_halfedge[v++];
      if (!h) continue;
      walk = {h, h};
      return true;
    }
    return false;
  };
  while (active < walks.size() && start_next(walks[active])) ++active;
  while (active > 0) {
    for (std::size_t i = 0; i < active; ++i) {
      Walk& walk = walks[i];
      walk.at = counter_clockwise(c, walk.at);
      __builtin_prefetch(&c.halfedges[walk.at.index]);
      ++count;
      if (walk.at == walk.start && !start_next(walk)) walk = walks[--active];
    }
  }
  return count;
}

// The fans are disjoint, so they cover all halfedges iff each vertex has exactly one.
bool has_one_fan_each(const MeshColumns& c) {
  const unsigned threads = threads_for(c.halfedges.size());
  std::vector<std::size_t> counts(threads, 0);
  for_each_part(static_cast<std::uint32_t>(c.vertex_halfedge.size()), threads,
                [&](unsigned t, std::uint32_t begin, std::uint32_t end) { counts[t] = count_in_fans(c, begin, end); });
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0}) == c.halfedges.size();
}

std::uint32_t fan_size(const MeshColumns& c, Halfedge start) {
  std::uint32_t n = 0;
  for_each_of_fan(c, start, [&](Halfedge) { ++n; });
  return n;
}

// Points with more outgoing halfedges than the fan of vertex_halfedge contains.
std::vector<bool> find_points_with_several_fans(const MeshColumns& c, bool& any) {
  std::vector<std::uint32_t> outgoing(c.vertex_halfedge.size(), 0);
  for (const HalfedgeLinks& links : c.halfedges) ++outgoing[links.from.index];
  std::vector<bool> several(outgoing.size(), false);
  any = false;
  for (std::size_t v = 0; v < outgoing.size(); ++v) {
    if (outgoing[v] == 0 || fan_size(c, c.vertex_halfedge[v]) == outgoing[v]) continue;
    several[v] = true;
    any = true;
  }
  return several;
}

std::vector<CornerFan> collect_fans(const MeshColumns& c, const std::vector<bool>& several) {
  std::vector<CornerFan> fans;
  std::vector<bool> seen(c.halfedges.size(), false);
  for (std::uint32_t i = 0; i < c.halfedges.size(); ++i) {
    const std::uint32_t point = c.halfedges[i].from.index;
    if (!several[point] || seen[i]) continue;
    CornerFan fan{point, Face(), Halfedge(i)};
    for_each_of_fan(c, Halfedge(i), [&](Halfedge h) {
      seen[h.index] = true;
      const Face face = c.halfedges[h.index].face;
      if (!face) fan.halfedge = h;
      fan.lowest_face = std::min(fan.lowest_face, face);  // none compares largest
    });
    fans.push_back(fan);
  }
  std::sort(fans.begin(), fans.end(), [](const CornerFan& a, const CornerFan& b) {
    return a.point != b.point ? a.point < b.point : a.lowest_face < b.lowest_face;
  });
  return fans;
}

}  // namespace

void separate_fans(MeshColumns& c) {
  if (has_one_fan_each(c)) return;
  bool any = false;
  const std::vector<bool> several = find_points_with_several_fans(c, any);
  if (!any) return;
  const std::vector<CornerFan> fans = collect_fans(c, several);
  c.next_copy.resize(c.positions.size());
  for (std::uint32_t v = 0; v < c.next_copy.size(); ++v) c.next_copy[v] = Vertex(v);
  c.copy_point = c.next_copy;
  for (std::size_t i = 0; i < fans.size(); ++i) {
    const CornerFan& fan = fans[i];
    if (i == 0 || fans[i - 1].point != fan.point) {
      c.vertex_halfedge[fan.point] = fan.halfedge;
      continue;
    }
    // Append the new copy to the cyclic list, which closes at the point itself.
    const Vertex copy(c.vertex_halfedge.size());
    const Vertex before = fans[i - 1].point == fan.point && i >= 2 && fans[i - 2].point == fan.point
                              ? Vertex(copy.index - 1)
                              : Vertex(fan.point);
    c.vertex_halfedge.push_back(fan.halfedge);
    c.positions.push_back(c.positions[fan.point]);
    c.next_copy.push_back(Vertex(fan.point));
    c.copy_point.push_back(Vertex(fan.point));
    c.next_copy[before.index] = copy;
    for_each_of_fan(c, fan.halfedge, [&](Halfedge h) { c.halfedges[h.index].from = copy; });
    ++c.live.vertices;
  }
}

}  // namespace ryosen
