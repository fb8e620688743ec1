#include "ryosen/ops/euler/unite_edge.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/shares.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter unite_edge_parameters[] = {
    with_words({"vertex", "Vertex", "頂点", "the vertex between the two edges", "二本の稜線の間の頂点"},
               required(vertex<&UniteEdge::vertex>("vN")))};

}  // namespace

constinit const OpInfo UniteEdge::info{.id = "unite_edge",
                                       .name_en = "Unite edges",
                                       .name_ja = "稜線結合",
                                       .line = {.lists = {unite_edge_parameters}},
                                       .help_en = "removes a vertex with exactly two edges and unites them",
                                       .help_ja = "稜線がちょうど二本の頂点を取り除く",
                                       .target = OpTargetKind::vertex,
                                       .group = OpGroup::euler,
                                       .aliases = "jekv",
                                       .topology = Topology::kept,
                                       .in_series = unites_edges_in_series};

namespace {

// The two outgoing halfedges.
std::pair<Halfedge, Halfedge> both_out(const Mesh& mesh, Vertex v) {
  return {mesh.halfedge(v), mesh.counter_clockwise(mesh.halfedge(v))};
}

// Checks the corner list of the face on one side of the vertex. An existing duplicate can only be the face on the other
// side, which loses the vertex too.
void check_face(const Mesh& mesh, Face f, Vertex v, Verdict& verdict) {
  CornerLoops after;
  for_each_loop(mesh, f, [&](Halfedge start) {
    std::vector<std::uint32_t> points = points_along(mesh, start);
    std::erase(points, v.index);
    after.add(points);
  });
  if (!take_out_bridges(after)) {
    verdict.refuse(Rule::loop, {f, v});
    return;
  }
  const Face except[] = {f};
  if (const Face other = face_on(mesh, point_set(after.corners), except))
    verdict.refuse(Rule::duplicate_face, {std::min(f, other), std::max(f, other)});
}

}  // namespace

Verdict UniteEdge::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, vertex, verdict)) return verdict;
  if (has_copies(mesh, vertex)) verdict.refuse(Rule::copies, {vertex});
  if (!has_two_edges(mesh, vertex)) verdict.refuse(Rule::two_edges, {vertex});
  if (!verdict.legal()) return verdict;
  const auto [out, other] = both_out(mesh, vertex);
  const std::vector<Halfedge> existing = sheets_between(mesh, mesh.to(out), mesh.to(other));
  if (!existing.empty()) verdict.refuse(Rule::edge_exists, {edge(existing.front())});
  const Face f = mesh.face(out), g = mesh.face(other);
  if (f) check_face(mesh, f, vertex, verdict);
  if (g && g != f) check_face(mesh, g, vertex, verdict);
  return verdict;
}

//     a --back--> m --out--> b      out and its twin are removed; back is extended to b
OpEffect UniteEdge::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  const Halfedge out = m.halfedge(vertex), out_twin = twin(out), back = m.prev(out), back_twin = twin(back);
  const Vertex b = m.to(out);
  OpEffect effect;
  effect.deleted = {vertex, edge(out)};
  const Edge both[] = {edge(back), edge(out)};
  edit.unite<Edge>(both[0], both, [&] { return lengths_of(m, both); });
  if (!m.is_outside(out_twin)) edit.derive(back_twin, out_twin, Derivation::copies);
  if (m.face(out)) replace_start(edit, m.face(out), out, back);
  if (m.face(out_twin)) replace_start(edit, m.face(out_twin), out_twin, back_twin);
  const Halfedge after = m.next(out), before = m.prev(out_twin);
  edit.connect(back, after == out_twin ? back_twin : after);
  if (after != out_twin) edit.connect(before, back_twin);
  edit.set_from(back_twin, b);
  if (m.halfedge(b) == out_twin) edit.set_halfedge(b, back_twin);
  edit.remove(edge(out));
  edit.drop(vertex);
  for (Halfedge side : {back, back_twin})
    if (!m.is_outside(side)) effect.changed.push_back(m.face(side));
  return effect;
}

}  // namespace ryosen
