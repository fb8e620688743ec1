#include "core/algo/repair/collapse_near.h"

#include <algorithm>

#include "core/algo/repair/flat_faces.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/collapse_edge.h"

namespace ryosen {

std::size_t collapse_near(Edit& edit, const NearPoints& near, Progress& progress) {
  const Mesh& m = edit.mesh();
  const std::vector<Vertex>& place = near.first;
  std::size_t done = 0;
  const auto is_near = [&](Vertex a, Vertex b) { return place[a.index] == place[b.index]; };
  for (std::uint32_t i = m.vertex_slots(); i-- > 0;) {
    const Vertex p(i);
    if (!progress.go_on(m.vertex_slots() - i, m.vertex_slots())) return done;
    if (i >= place.size() || !place[i] || place[i] == p || !m.is_alive(p)) continue;
    std::vector<std::pair<Vertex, Halfedge>> ways;
    for_each_copy(m, p, [&](Vertex copy) {
      if (m.is_isolated(copy)) return;
      for (Halfedge h : outgoing(m, copy))
        if (const Vertex end = point(m, m.to(h)); end < p && is_near(p, end)) ways.emplace_back(end, h);
    });
    std::sort(ways.begin(), ways.end());
    for (const auto& [end, h] : ways) {
      if (!collapses_soundly(m, h)) continue;
      CollapseEdge{h, CollapseEdge::Place::end}.apply(edit);
      ++done;
      break;
    }
  }
  return done;
}

}  // namespace ryosen
