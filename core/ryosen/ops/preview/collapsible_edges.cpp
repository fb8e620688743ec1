#include "ryosen/ops/preview/collapsible_edges.h"

#include <algorithm>

#include "ryosen/base/column_memory.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/rules/plain_check.h"

namespace ryosen {

namespace {

constexpr std::uint32_t highest_valence = 64;

// The one-rings of all vertices, concatenated and padded to blocks.
class Stars {
 public:
  struct Star {
    std::uint32_t first = 0;  // in the list of neighbours
    std::uint8_t valence = 0;
    std::uint8_t gaps = 0;
    bool is_plain = false;  // all faces are triangles, no point here has copies, and the valence is not high
  };

  explicit Stars(const Mesh& mesh)
      : stars_(mesh.vertex_slots()),
        neighbours_(mesh.halfedge_slots() + std::size_t{ring_block} * mesh.vertex_slots()) {
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) gather(mesh, Vertex(i));
  }

  const Star& operator[](Vertex v) const { return stars_[v.index]; }
  std::uint32_t count_common(const Star& a, const Star& b) const {
    return ryosen::count_common(neighbours_.data() + a.first, a.valence, neighbours_.data() + b.first, b.valence);
  }

 private:
  void gather(const Mesh& mesh, Vertex v) {
    if (!mesh.is_alive(v) || mesh.is_isolated(v)) return;
    const HalfedgeLinks* links = mesh.columns().halfedges.data();
    std::uint32_t valence = 0, gaps = 0;
    bool is_odd = mesh.next_copy(v) != v;
    const bool has_copies = mesh.has_copies();
    std::uint32_t* out = neighbours_.data() + end_;
    const Halfedge start = mesh.halfedge(v);
    Halfedge h = start;
    do {
      const HalfedgeLinks& at = links[h.index];
      const HalfedgeLinks& before = links[at.prev.index];
      const bool is_gap = at.face.is_none();
      gaps += is_gap;
      is_odd |= !is_gap & (at.next != before.prev);
      if (has_copies) is_odd |= mesh.next_copy(before.from) != before.from;
      *out++ = before.from.index;
      h = twin(at.prev);
      ++valence;
    } while (h != start && valence < highest_valence);
    const bool is_high = h != start;
    std::fill_n(out, ring_block, no_index);
    stars_[v.index] = {end_, static_cast<std::uint8_t>(valence), static_cast<std::uint8_t>(gaps), !is_odd && !is_high};
    end_ += (valence + ring_block - 1) / ring_block * ring_block;
  }

  ColumnVector<Star> stars_;
  UnwrittenVector<std::uint32_t> neighbours_;
  std::uint32_t end_ = 0;  // end of the neighbours collected so far
};

// Only for cases where the common neighbours decide: an interior edge of two triangles with at most one end on a
// boundary.
bool is_surely_legal(const Mesh& mesh, const Stars& stars, Halfedge h) {
  if (mesh.is_outside(h) || mesh.is_outside(twin(h))) return false;
  const Stars::Star &a = stars[mesh.from(h)], &b = stars[mesh.to(h)];
  if (!a.is_plain || !b.is_plain) return false;
  return is_ordinary_inner_edge(std::uint32_t{a.gaps} + b.gaps, a.valence, b.valence) && stars.count_common(a, b) == 2;
}

}  // namespace

std::vector<std::uint8_t> collapsible_edges(const Mesh& mesh) {
  std::vector<std::uint8_t> legal(mesh.edge_slots(), 0);
  const Stars stars(mesh);
  const bool has_rings = mesh.has_rings();
  for (const Edge e : live_edges(mesh)) {
    const Halfedge h = halfedge(e);
    legal[e.index] = (!has_rings && is_surely_legal(mesh, stars, h)) || CollapseEdge{h}.is_legal(mesh);
  }
  return legal;
}

}  // namespace ryosen
