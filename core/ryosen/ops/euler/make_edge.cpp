#include "ryosen/ops/euler/make_edge.h"

#include <cassert>
#include <utility>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

// The boundary halfedges that end at v (its gaps), at most `most` of them.
std::vector<Halfedge> some_gaps_at(const Mesh& mesh, Vertex v, std::size_t most) {
  std::vector<Halfedge> gaps;
  for (Halfedge h : outgoing(mesh, v)) {
    if (mesh.is_outside(h)) gaps.push_back(mesh.prev(h));
    if (gaps.size() == most) break;
  }
  return gaps;
}

// If the gap is named, avoids listing all gaps of a vertex with many wires.
Halfedge read_gap(const Mesh& mesh, Vertex v, ArgumentReader& in) {
  if (in.failed() || in.at_end()) return in.corner(v, gaps_at(mesh, v));
  const Named<Halfedge> named = find_edge(mesh, in.peek());
  if (!named.ok() || mesh.to(named.element) != v || !mesh.is_outside(named.element))
    return in.corner(v, gaps_at(mesh, v));
  return in.halfedge();
}

}  // namespace

Parsed<MakeEdge> MakeEdge::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  MakeEdge op;
  op.a = in.vertex();
  op.b = in.vertex();
  if (in.failed()) return in.result(op);
  // A single named corner belongs to the vertex at which it ends.
  const std::vector<Halfedge> at_a = some_gaps_at(mesh, op.a, 2);
  const Named<Halfedge> named = in.at_end() ? Named<Halfedge>() : find_edge(mesh, in.peek());
  const bool is_for_a = in.left() == 2 || (!in.at_end() && named.ok() && mesh.to(named.element) == op.a);
  if (at_a.size() > 1 || (is_for_a && !at_a.empty())) op.into_a = read_gap(mesh, op.a, in);
  if (op.into_a.is_none() && !at_a.empty()) op.into_a = at_a[0];
  op.into_b = read_gap(mesh, op.b, in);
  return in.result(op);
}

std::string MakeEdge::command(const Mesh& mesh) const {
  std::string line = "make_edge " + name_of_copy(mesh, a) + " " + name_of_copy(mesh, b);
  // If one corner must be named, name both (where they exist).
  const auto has_choice = [&](Vertex v) { return is_there(mesh, v) && some_gaps_at(mesh, v, 2).size() == 2; };
  if (!has_choice(a) && !has_choice(b)) return line;
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
  if (are_joined(mesh, a, b)) verdict.refuse(Rule::edge_exists, {edge(sheets_between(mesh, a, b).front())});
  return verdict;
}

OpEffect MakeEdge::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  OpEffect effect;
  effect.created.push_back(edge(link_edge(edit, a, into_a, b, into_b)));
  return effect;
}

}  // namespace ryosen
