#include "ryosen/textbook/forms/growth/collapse.h"

#include <algorithm>
#include <array>
#include <list>
#include <numeric>

#include "ryosen/base/stopwatch.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/forms/source_operators.h"

namespace ryosen::forms {

namespace {

constexpr std::uint32_t most_edges = 8;

// Edges that may collapse and that the listing can: between two faces, with no boundary in sight. They lie apart, so
// that one goes with the others.
std::vector<Halfedge> edges_to_collapse(const Mesh& mesh) {
  std::vector<Halfedge> found;
  std::vector<bool> is_near(mesh.vertex_slots(), false);
  const auto is_free = [&](Vertex v) {
    for (const Halfedge h : outgoing(mesh, v))
      if (is_near[mesh.to(h).index] || mesh.is_outside(h) || mesh.is_outside(twin(h))) return false;
    return !is_near[v.index];
  };
  const std::uint32_t stride = mesh.edge_slots() / (4 * most_edges) + 1;
  for (std::uint32_t e = 0; e < mesh.edge_slots() && found.size() < most_edges; e += stride) {
    if (!mesh.is_alive(Edge(e))) continue;
    const Halfedge h = halfedge(Edge(e));
    if (!is_free(mesh.from(h)) || !is_free(mesh.to(h)) || !CollapseEdge{h}.check(mesh).legal()) continue;
    for (const Vertex end : {mesh.from(h), mesh.to(h)}) {
      is_near[end.index] = true;
      for (const Vertex v : neighbours(mesh, end)) is_near[v.index] = true;
    }
    found.push_back(h);
  }
  return found;
}

void add_seconds(double taken, CollapseFigures& sum) {
  sum.seconds = sum.seconds > 0 ? std::min(sum.seconds, taken) : taken;
}

// The lists of the listing, whose remove() looks at every entry.
class Lists {
 public:
  explicit Lists(const HalfedgeTable& table)
      : vertices_(table.vertex_halfedge.size()), faces_(table.face_halfedge.size()) {
    std::iota(vertices_.begin(), vertices_.end(), 0u);
    std::iota(faces_.begin(), faces_.end(), 0u);
  }
  void remove_vertex(std::uint32_t v) { remove(vertices_, v); }
  void remove_face(std::uint32_t f) { remove(faces_, f); }
  std::size_t compared() const { return compared_; }

 private:
  void remove(std::list<std::uint32_t>& list, std::uint32_t element) {
    list.remove_if([&](std::uint32_t one) {
      ++compared_;
      return one == element;
    });
  }
  std::list<std::uint32_t> vertices_, faces_;
  std::size_t compared_ = 0;
};

std::optional<CollapseFigures> by_listing(const Mesh& mesh, bool has_lists) {
  if (why_unsuitable(mesh, find_form("halfedge")->needs | triangles)) return {};
  const std::vector<Halfedge> edges = edges_to_collapse(mesh), corners = corner_halfedges(mesh);
  if (edges.empty()) return {};
  std::vector<std::uint32_t> corner_of(mesh.halfedge_slots(), no_index);
  for (std::uint32_t c = 0; c < corners.size(); ++c) corner_of[corners[c].index] = c;
  HalfedgeTable table = inner_halfedges(mesh);
  std::optional<Lists> lists;
  if (has_lists) lists.emplace(table);
  CollapseFigures sum;
  for (const Halfedge edge : edges) {
    const std::uint32_t h = corner_of[edge.index];
    const std::uint32_t start = table.from(h), left = table.face(h), right = table.face(table.pair(h));
    const Stopwatch watch;
    const SourceOutcome outcome = source_collapse(table, h);
    if (lists) {
      lists->remove_vertex(start);
      lists->remove_face(right);
      lists->remove_face(left);
    }
    add_seconds(watch.seconds(), sum);
    sum.count += static_cast<double>(outcome.links_followed);
  }
  if (lists) sum.count += static_cast<double>(lists->compared());
  const auto n = static_cast<double>(edges.size());
  return CollapseFigures{sum.count / n, sum.seconds};
}

std::optional<CollapseFigures> in_lists(const Mesh& mesh) { return by_listing(mesh, true); }
std::optional<CollapseFigures> in_arrays(const Mesh& mesh) { return by_listing(mesh, false); }

// With its check, and recorded so that it can be undone.
std::optional<CollapseFigures> by_kernel(const Mesh& mesh) {
  const std::vector<Halfedge> edges = edges_to_collapse(mesh);
  if (edges.empty()) return {};
  Mesh changed = mesh;
  Journal journal;
  CollapseFigures sum;
  for (const Halfedge h : edges) {
    const Stopwatch watch;
    const CollapseEdge collapse{h};
    if (!collapse.check(changed).legal()) continue;
    Edit edit(changed, &journal);
    collapse.apply(edit);
    edit.commit();
    add_seconds(watch.seconds(), sum);
    sum.count += static_cast<double>(journal.touched(journal.size() - 1).size());
  }
  const auto n = static_cast<double>(journal.size());
  if (n == 0) return {};
  return CollapseFigures{sum.count / n, sum.seconds};
}

constexpr std::array ways{
    CollapseWay{"halfedge_lists", "halfedge, with the listing's lists", "半稜線（テキストのリスト）", in_lists},
    CollapseWay{"halfedge", "halfedge, in arrays", "半稜線（配列）", in_arrays},
    CollapseWay{"ryosen", "Ryosen, with its check", "Ryosen（判定も含む）", by_kernel},
};

}  // namespace

std::span<const CollapseWay> collapse_ways() { return ways; }

}  // namespace ryosen::forms
