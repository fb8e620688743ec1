#include "ryosen/ops/dissolve.h"

#include <algorithm>
#include <cassert>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/euler/unite_edge.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/local_facts.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter dissolve_parameters[] = {
    with_words({"element", "Edge or vertex", "稜線または頂点",
                "the edge between the faces, or the vertex that they surround", "面の間の稜線、または面に囲まれた頂点"},
               required(edge<&Dissolve::halfedge>("A-B"), one_copy<&Dissolve::vertex>("vN")))};

}  // namespace

constinit const OpInfo Dissolve::info{
    .id = "dissolve",
    .name_en = "Dissolve",
    .name_ja = "溶解",
    .line = {.lists = {dissolve_parameters}},
    .help_en = "unites the faces at an edge or around a vertex, or all that are selected side by side",
    .help_ja = "稜線の両側または頂点の周りの面、または隣り合う選択面をすべて一つにまとめる",
    .target = OpTargetKind::edge,
    .group = OpGroup::join,
    .topology = Topology::kept,
    .in_place_of = &edges_of_faces_side_by_side,
    .in_series = dissolves_in_series,
    .takes_ends_along = true};

namespace {

// What is removed: edges and the vertices between them, and the faces that are merged.
struct Plan {
  std::vector<std::vector<Halfedge>> chains;
  std::vector<Vertex> vertices;  // interior ones of the chains, and the common one
  std::vector<Face> faces;       // ascending
  bool is_star = false;          // the chains start at one interior vertex
};

void add_chain(const Mesh& m, std::vector<Halfedge> chain, Plan& plan) {
  for (std::size_t i = 1; i < chain.size(); ++i) plan.vertices.push_back(m.from(chain[i]));
  for (Halfedge h : {chain[0], twin(chain[0])})
    if (m.face(h)) plan.faces.push_back(m.face(h));
  plan.chains.push_back(std::move(chain));
}

Plan plan_of_edge(const Mesh& m, Halfedge h) {
  Plan plan;
  add_chain(m, chain_through(m, h), plan);
  std::sort(plan.faces.begin(), plan.faces.end());
  return plan;
}

// The vertex has at most one gap.
Plan plan_of_vertex(const Mesh& m, Vertex v) {
  Plan plan;
  plan.is_star = !m.is_boundary(v);
  if (plan.is_star) plan.vertices.push_back(v);
  for (Halfedge h : outgoing(m, v))
    if (!m.is_outside(h) && !m.is_outside(twin(h))) add_chain(m, chain_from(m, h), plan);
  sort_unique(plan.faces);
  return plan;
}

std::vector<Edge> edges_taken(const Plan& plan) {
  std::vector<Edge> taken;
  for (const auto& chain : plan.chains)
    for (Halfedge h : chain) taken.push_back(edge(h));
  std::sort(taken.begin(), taken.end());
  return taken;
}

// The loops of the resulting face, on points.
CornerLoops loops_after(const Mesh& m, const Plan& plan) {
  const std::vector<Edge> taken = edges_taken(plan);
  const auto is_taken = [&](Halfedge h) { return std::binary_search(taken.begin(), taken.end(), edge(h)); };
  std::vector<Halfedge> left;
  for (Face f : plan.faces)
    for (Halfedge h : halfedges_around(m, f))
      if (!is_taken(h)) left.push_back(h);
  std::sort(left.begin(), left.end());
  std::vector<bool> done(left.size(), false);
  CornerLoops loops;
  for (std::size_t i = 0; i < left.size(); ++i) {
    std::vector<std::uint32_t> points;
    for (Halfedge h = left[i];;) {
      const auto at = static_cast<std::size_t>(std::lower_bound(left.begin(), left.end(), h) - left.begin());
      if (done[at]) break;
      done[at] = true;
      points.push_back(point(m, m.from(h)).index);
      h = m.next(h);
      while (is_taken(h)) h = m.next(twin(h));
    }
    if (!points.empty()) loops.add(points);
  }
  return loops;
}

void check_copies(const Mesh& m, const Plan& plan, Verdict& verdict) {
  for (Vertex v : plan.vertices)
    if (has_copies(m, v)) verdict.refuse(Rule::copies, {point(m, v)});
  for (const auto& chain : plan.chains)
    for (Halfedge h : chain)
      if (is_cut_on_points(m, h)) verdict.refuse(Rule::copies, {point(m, m.from(h)), point(m, m.to(h))});
}

void check_plan(const Mesh& m, const Plan& plan, Verdict& verdict) {
  std::vector<Element> faces(plan.faces.begin(), plan.faces.end());
  const CornerLoops after = loops_after(m, plan);
  std::size_t loops = 0, bridges = 0;
  for (Face f : plan.faces) {
    const CornerLoops own = loops_of(m, f);
    loops += own.ends.size();
    bridges += bridges_of(own);
  }
  const auto parts = take_out_bridges(after);
  // Each merged face but the first removes one loop, and existing bridges stay; a further shared edge would become a
  // new bridge, which is not allowed.
  const bool is_one = after.ends.size() + plan.faces.size() == loops + 1;
  if (!parts || !is_one || parts->size() - after.ends.size() != bridges) {
    verdict.reasons.push_back({Rule::loop, faces});
    return;
  }
  for (Face f : plan.faces)
    if (const Face other = equal_face(m, f)) verdict.refuse(Rule::loses_duplicate, {f, other});
  if (const Face other = face_on(m, point_set(after.corners), plan.faces))
    verdict.refuse(Rule::duplicate_face, {plan.faces[0], other});
}

void check_edge(const Mesh& m, Halfedge h, Verdict& verdict) {
  const Face f = m.face(h), g = m.face(twin(h));
  if (!f || !g) verdict.refuse(Rule::boundary, {edge(h)});
  if (f && f == g) verdict.refuse(Rule::same_face, {edge(h), f});
  if (is_cut_on_points(m, h)) verdict.refuse(Rule::copies, {point(m, m.from(h)), point(m, m.to(h))});
  if (!verdict.legal()) return;
  const Plan plan = plan_of_edge(m, h);
  check_copies(m, plan, verdict);
  if (verdict.legal()) check_plan(m, plan, verdict);
}

void check_vertex(const Mesh& m, Vertex v, Verdict& verdict) {
  if (has_two_edges(m, v)) {
    verdict = UniteEdge{v}.check(m);
    return;
  }
  std::size_t fans = 0, faces = 0;
  for (Halfedge h : outgoing(m, v)) {
    fans += m.is_outside(twin(h)) && !m.is_outside(h);
    faces += !m.is_outside(h);
  }
  if (faces == 0) verdict.refuse(Rule::nothing_between, {v});
  if (fans > 1) verdict.refuse(Rule::copies, {point(m, v)});
  if (!verdict.legal()) return;
  const Plan plan = plan_of_vertex(m, v);
  if (plan.chains.empty()) verdict.refuse(Rule::nothing_between, {v});
  for (Halfedge h : outgoing(m, v))
    if (is_bridge(m, h)) verdict.refuse(Rule::same_face, {edge(h), m.face(h)});
  check_copies(m, plan, verdict);
  if (verdict.legal()) check_plan(m, plan, verdict);
}

void remove_inner_vertices(Edit& edit, const std::vector<Halfedge>& chain, const std::vector<Vertex>& inner,
                           OpEffect& effect) {
  for (Halfedge h : chain) effect.deleted.push_back(edge(h));
  for (Vertex v : inner) {
    edit.drop(v);
    effect.deleted.push_back(v);
  }
}

void unite_along(Edit& edit, const std::vector<Halfedge>& chain, OpEffect& effect) {
  const std::vector<Vertex> inner = inner_vertices(edit.mesh(), chain);
  effect.deleted.push_back(unite_faces(edit, chain));
  remove_inner_vertices(edit, chain, inner, effect);
}

// The last chain of an interior vertex has the same face on both sides.
void take_spike_away(Edit& edit, Vertex v, const std::vector<Halfedge>& chain, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  const Face f = m.face(chain.front());
  const Halfedge after = m.next(chain.back());
  const std::vector<Vertex> inner = inner_vertices(m, chain);
  for (Halfedge h : chain) {
    replace_start(edit, f, h, after);
    replace_start(edit, f, twin(h), after);
  }
  for (Halfedge h : chain) unlink_edge(edit, h);
  remove_inner_vertices(edit, chain, inner, effect);
  edit.drop(v);
  effect.deleted.push_back(v);
}

}  // namespace

std::vector<Element> edges_between_faces(const Mesh& mesh, std::span<const Element> selected) {
  std::vector<Face> faces;
  for (const Element& e : selected)
    if (e.kind == Element::Kind::face) faces.push_back(e.face());
  sort_unique(faces);
  std::vector<Edge> edges;
  for (const Face f : faces)
    for (const Halfedge h : halfedges_around(mesh, f)) {
      const Face other = mesh.face(twin(h));
      if (other && f < other && std::binary_search(faces.begin(), faces.end(), other)) edges.push_back(edge(h));
    }
  sort_unique(edges);
  return {edges.begin(), edges.end()};
}

// Without a chain of further edges it unites two faces.
Verdict Dissolve::check(const Mesh& mesh, LocalFacts& known) const {
  const bool is_edge = vertex.is_none() && is_there(mesh, halfedge);
  if (is_edge && !has_two_edges(mesh, mesh.from(halfedge)) && !has_two_edges(mesh, mesh.to(halfedge)) &&
      unite_plainly(mesh, halfedge, known))
    return {};
  return check(mesh);
}

Verdict Dissolve::check(const Mesh& mesh) const {
  Verdict verdict;
  if (vertex ? is_gone(mesh, vertex, verdict) : is_gone(mesh, halfedge, verdict)) return verdict;
  if (vertex)
    check_vertex(mesh, vertex, verdict);
  else
    check_edge(mesh, halfedge, verdict);
  return verdict;
}

std::vector<Reason> Dissolve::warnings(const Mesh& mesh) const {
  if (vertex && has_two_edges(mesh, vertex)) return {};
  const Plan plan = vertex ? plan_of_vertex(mesh, vertex) : plan_of_edge(mesh, halfedge);
  std::vector<Element> seams;
  for (const auto& chain : plan.chains)
    for (Halfedge h : chain)
      if (is_seam(mesh, h)) seams.push_back(edge(h));
  if (seams.empty()) return {};
  return {{Rule::seam, seams}};
}

OpEffect Dissolve::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  if (vertex && has_two_edges(m, vertex)) return UniteEdge{vertex}.apply(edit);
  const Plan plan = vertex ? plan_of_vertex(m, vertex) : plan_of_edge(m, halfedge);
  merge_corner_values(edit, edges_taken(plan));
  OpEffect effect;
  effect.changed = {plan.faces[0]};
  for (const std::vector<Halfedge>& chain : plan.chains) {
    if (m.face(chain[0]) != m.face(twin(chain[0])))
      unite_along(edit, chain, effect);
    else
      take_spike_away(edit, vertex, chain, effect);
  }
  const bool is_left_over = vertex && !plan.is_star && has_two_edges(m, vertex);
  if (!is_left_over || !UniteEdge{vertex}.check(m).legal()) return effect;
  const OpEffect united = UniteEdge{vertex}.apply(edit);
  effect.deleted.insert(effect.deleted.end(), united.deleted.begin(), united.deleted.end());
  return effect;
}

bool dissolve_together(Edit& edit, std::vector<Halfedge> sides) {
  const Mesh& m = edit.mesh();
  // Lower faces first: the lowest takes the common face, and the others come to it.
  std::sort(sides.begin(), sides.end(), [&](Halfedge a, Halfedge b) { return m.face(a) < m.face(b); });
  Plan plan;
  for (Halfedge h : sides) {
    if (!m.face(h) || !m.face(twin(h)) || has_two_edges(m, m.from(h)) || has_two_edges(m, m.to(h))) return false;
    add_chain(m, {h}, plan);
  }
  sort_unique(plan.faces);
  if (plan.faces.size() != sides.size() + 1) return false;
  Verdict verdict;
  check_copies(m, plan, verdict);
  if (verdict.legal()) check_plan(m, plan, verdict);
  if (!verdict.legal()) return false;
  merge_corner_values(edit, edges_taken(plan));
  OpEffect effect;
  for (const std::vector<Halfedge>& chain : plan.chains) unite_along(edit, chain, effect);
  return true;
}

}  // namespace ryosen
