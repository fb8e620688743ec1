#include "core/ops/euler/make_edge.h"

#include <cassert>
#include <utility>

#include "core/mesh/copies.h"
#include "core/ops/arguments.h"
#include "core/ops/surgery.h"

namespace ryosen {

Parsed<MakeEdge> MakeEdge::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  MakeEdge op;
  op.a = in.vertex();
  op.b = in.vertex();
  if (in.failed()) return in.result(op);
  // One corner that is named belongs to the vertex that it arrives at.
  const std::vector<Halfedge> at_a = gaps_at(mesh, op.a), at_b = gaps_at(mesh, op.b);
  if (at_a.size() > 1 || (in.left() == 2 && !at_a.empty())) op.into_a = in.corner(op.a, at_a);
  if (op.into_a.is_none() && !at_a.empty()) op.into_a = at_a[0];
  op.into_b = in.corner(op.b, at_b);
  return in.result(op);
}

MakeEdge MakeEdge::at(const Mesh&, const OpTarget&) { return {}; }

std::string MakeEdge::command(const Mesh& mesh) const {
  std::string line = "make_edge " + name_of_copy(mesh, a) + " " + name_of_copy(mesh, b);
  // Both corners are named as soon as one has to be, as far as there are any.
  if (gaps_at(mesh, a).size() < 2 && gaps_at(mesh, b).size() < 2) return line;
  for (Halfedge into : {into_a, into_b})
    if (into) line += " " + name_of(mesh, into);
  return line;
}

Verdict MakeEdge::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, a, verdict) || is_gone(mesh, b, verdict)) return verdict;
  if (same_point(mesh, a, b)) {
    verdict.refuse(Rule::same_vertex, {a});
    return verdict;
  }
  for (const auto& [v, into] : {std::pair(a, into_a), std::pair(b, into_b)}) {
    const bool fits = into ? mesh.exists(into) && mesh.is_alive(into) && mesh.to(into) == v && mesh.is_outside(into)
                           : mesh.is_isolated(v);
    if (fits) continue;
    verdict.refuse(Rule::no_gap, {v});
    if (!mesh.is_isolated(v)) verdict.reasons.back().witnesses.push_back(mesh.face(mesh.halfedge(v)));
  }
  const std::vector<Halfedge> existing = sheets_between(mesh, a, b);
  if (!existing.empty()) verdict.refuse(Rule::edge_exists, {edge(existing.front())});
  return verdict;
}

std::vector<Reason> MakeEdge::warnings(const Mesh&) const { return {}; }

OpEffect MakeEdge::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  OpEffect effect;
  effect.created.push_back(edge(link_edge(edit, a, into_a, b, into_b)));
  return effect;
}

}  // namespace ryosen
