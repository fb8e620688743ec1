#include "ryosen/ops/euler/make_edge.h"

#include <cassert>
#include <utility>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter make_edge_parameters[] = {
    with_words({"first", "First vertex", "最初の頂点", "where the edge begins", "稜線の始点"},
               required(copy<&MakeEdge::a>("A"))),
    with_words({"second", "Second vertex", "二番目の頂点", "where the edge ends", "稜線の終点"},
               required(copy<&MakeEdge::b>("B"))),
    with_words(
        {"into_first", "Corner at the first", "最初の頂点の角",
         "the halfedge that ends in the corner, where A has several corners", "A に角が複数あるとき、角に着く半稜線"},
        optional(element(OpValueKind::edge, "P-A"))),
    with_words(
        {"into_second", "Corner at the second", "二番目の頂点の角",
         "the halfedge that ends in the corner, where B has several corners", "B に角が複数あるとき、角に着く半稜線"},
        optional(element(OpValueKind::edge, "Q-B")))};

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
  const Named<Halfedge> named = in.peek_halfedge();
  if (!named.ok() || mesh.to(named.element) != v || !mesh.is_outside(named.element))
    return in.corner(v, gaps_at(mesh, v));
  return in.halfedge();
}

// A single named corner belongs to the vertex at which it ends.
void read_gaps(const Mesh& mesh, ArgumentReader& in, void* op) {
  auto& [a, b, into_a, into_b] = *static_cast<MakeEdge*>(op);
  const std::vector<Halfedge> at_a = some_gaps_at(mesh, a, 2);
  const Named<Halfedge> named = in.at_end() ? Named<Halfedge>() : in.peek_halfedge();
  const bool is_for_a = in.left() == 2 || (!in.at_end() && named.ok() && mesh.to(named.element) == a);
  if (at_a.size() > 1 || (is_for_a && !at_a.empty())) into_a = read_gap(mesh, a, in);
  if (into_a.is_none() && !at_a.empty()) into_a = at_a[0];
  into_b = read_gap(mesh, b, in);
}

// If one corner must be named, prints both (where they exist).
void print_gaps(const Mesh& mesh, const void* op, std::string& line) {
  const auto& [a, b, into_a, into_b] = *static_cast<const MakeEdge*>(op);
  const auto has_choice = [&](Vertex v) { return is_there(mesh, v) && some_gaps_at(mesh, v, 2).size() == 2; };
  if (!has_choice(a) && !has_choice(b)) return;
  for (const Halfedge into : {into_a, into_b})
    if (into) line += " " + name_of(mesh, into);
}

}  // namespace

constinit const OpInfo MakeEdge::info{
    .id = "make_edge",
    .name_en = "Make edge",
    .name_ja = "稜線生成",
    .line = {.lists = {make_edge_parameters}, .read_rest = read_gaps, .print_rest = print_gaps},
    .help_en = "joins two vertices by an edge, in the corners that P-A and Q-B arrive at",
    .help_ja = "二頂点を稜線で結ぶ。角は着く半稜線 P-A と Q-B で指定する",
    .target = OpTargetKind::selection,
    .group = OpGroup::euler,
    .on_selection = OnSelection::all};

Verdict MakeEdge::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, a, verdict) || is_gone(mesh, b, verdict)) return verdict;
  if (same_point(mesh, a, b)) return refused_by(Rule::same_vertex, {a});
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
  return {.created = {edge(link_edge(edit, a, into_a, b, into_b))}};
}

}  // namespace ryosen
