// The values of points that moved.
#include "ryosen/algo/remesh/remesher.h"
#include "ryosen/algo/remesh/value_shares.h"
#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/base/parallel.h"
#include "ryosen/ops/rules/corner_values.h"

namespace ryosen::remesh {

namespace {

// By face slot: a number that faces have in common which can be reached from each other without crossing a feature.
std::vector<std::uint32_t> charts_of(const Mesh& mesh, const Features& features) {
  DisjointSets sets(mesh.face_slots());
  for (Edge e(0); e.index < mesh.edge_slots(); ++e.index) {
    if (!mesh.is_alive(e) || features.edges[e.index]) continue;
    sets.join(mesh.face(halfedge(e)).index, mesh.face(twin(halfedge(e))).index);
  }
  std::vector<std::uint32_t> charts(mesh.face_slots());
  for (std::uint32_t f = 0; f < charts.size(); ++f) charts[f] = sets.root(f);
  return charts;
}

}  // namespace

// Where on the surface as it was each vertex lies that is no feature. What features enclose stays enclosed, and a face
// that stays keeps its number: so it is known to what chart of the surface each chart of the mesh belongs, and a point
// near a seam does not take values of its other side.
std::vector<std::optional<Target::Share>> Remesher::shares(const Mesh& before) const {
  const std::vector<std::uint32_t> old_charts = charts_of(before, begun_with_), charts = charts_of(mesh_, features_);
  std::vector<std::uint32_t> old_of(mesh_.face_slots(), no_index);
  for (Face f(0); f.index < before.face_slots(); ++f.index)
    if (mesh_.is_alive(f)) old_of[charts[f.index]] = old_charts[f.index];
  std::vector<std::optional<Target::Share>> found(mesh_.vertex_slots());
  constexpr std::size_t steps_for_each = 64;
  const std::uint32_t n = mesh_.vertex_slots();
  for_each_part(n, threads_for(steps_for_each * n), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (Vertex v(begin); v.index < end; ++v.index) {
      if (!mesh_.is_alive(v) || is_fixed(v)) continue;
      if (v.index < before.vertex_slots() && mesh_.position(v) == before.position(v)) {
        found[v.index] = share_of_corner(before, before.halfedge(v));
        continue;
      }
      const std::uint32_t chart = old_of[charts[mesh_.face(mesh_.halfedge(v)).index]];
      found[v.index] = target_.share(mesh_.position(v), normal_of(v), nearby_[v.index],
                                     [&](Face f) { return chart == no_index || old_charts[f.index] == chart; });
    }
  });
  return found;
}

void Remesher::share_corner_values(Vertex v) {
  CornerWriter corners(edit_);
  for (std::size_t k = 0; k < corners.count(); ++k) {
    const std::uint32_t index = corners.index(k, mesh_.halfedge(v));
    for (const Halfedge h : outgoing(mesh_, v)) corners.set(k, h, index);
  }
}

void Remesher::take_values(const Mesh& before) {
  if (before.attributes().empty()) return;
  const auto found = shares(before);
  ShareWriter writer(edit_, before);
  for (Vertex v(0); v.index < mesh_.vertex_slots(); ++v.index)
    if (found[v.index]) writer.write(v, *found[v.index]);
}

}  // namespace ryosen::remesh
