#include "ryosen/algo/repair/collapse_near.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "ryosen/algo/repair/flat_faces.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/collapse_edge.h"

namespace ryosen {

namespace {

// Grows a point by collapsing its edges to near points onto it, so that a collapse moves only the faces of the point
// that goes: the other way round, those of a point that has taken up many would be moved again and again.
class Growth {
 public:
  Growth(Edit& edit, const std::vector<Vertex>& place, Progress& progress)
      : edit_(edit), m_(edit.mesh()), place_(place), progress_(progress) {}

  std::size_t grow(Vertex point) {
    grown_ = point;
    std::vector<Halfedge> ways, refused;
    add_ways(point, ways);
    std::size_t done = 0;
    for (int round = 0; round < 2 && !ways.empty(); ++round) {  // what was refused may be sound once others are gone
      const std::size_t before = done;
      for (std::size_t i = 0; i < ways.size() && progress_.go_on(); ++i) {
        if (!m_.is_alive(ways[i]) || !is_way(ways[i])) continue;
        take_up(ways[i], ways) ? void(++done) : refused.push_back(ways[i]);
      }
      if (done == before) break;
      ways = std::exchange(refused, {});
    }
    return done;
  }

 private:
  bool is_way(Halfedge h) const {
    const Vertex end = point(m_, m_.to(h));
    return grown_ < end && place_[end.index] == place_[grown_.index];
  }

  void add_ways(Vertex from, std::vector<Halfedge>& ways) const {
    for_each_copy(m_, from, [&](Vertex copy) {
      if (m_.is_isolated(copy)) return;
      for (Halfedge h : outgoing(m_, copy))
        if (is_way(h)) ways.push_back(h);
    });
  }

  // Collapses the end of a way onto the point, whose further ways are those of the end.
  bool take_up(Halfedge way, std::vector<Halfedge>& ways) {
    if (!collapses_soundly(m_, twin(way))) return false;
    const std::size_t first = ways.size();
    add_ways(m_.to(way), ways);
    CollapseEdge{twin(way), CollapseEdge::Place::end}.apply(edit_);
    ways.erase(std::remove_if(ways.begin() + static_cast<std::ptrdiff_t>(first), ways.end(),
                              [&](Halfedge h) { return !m_.is_alive(h); }),
               ways.end());
    return true;
  }

  Edit& edit_;
  const Mesh& m_;
  const std::vector<Vertex>& place_;
  Progress& progress_;
  Vertex grown_;
};

}  // namespace

std::size_t collapse_near(Edit& edit, const NearPoints& near, Progress& progress) {
  const Mesh& m = edit.mesh();
  Growth growth(edit, near.first, progress);
  std::size_t done = 0;
  for (std::uint32_t i = 0; i < m.vertex_slots() && progress.go_on(i, m.vertex_slots()); ++i)
    if (const Vertex p(i); m.is_alive(p) && point(m, p) == p) done += growth.grow(p);
  return done;
}

}  // namespace ryosen
