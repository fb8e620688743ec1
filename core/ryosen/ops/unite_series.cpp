#include "ryosen/ops/unite_series.h"

#include <array>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/ops/euler/unite_edge.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

std::uint32_t UniteSeries::corner_count(Face f) {
  bool is_new = false;
  const std::uint32_t count = known_.corner_count(mesh(), f, &is_new);
  if (is_new) looks_ += count;
  return count;
}

// A simple loop keeps being one. On the points that are left may lie another face at both neighbours: of one corner
// less, or of more where it meets a point twice.
UniteSeries::Answer UniteSeries::answer_of_face(Face f, Face beyond, Vertex a, Vertex b) {
  if (!known_.is_one_simple_loop(mesh(), f)) return Answer::unsure;
  const std::uint32_t corners = corner_count(f);
  if (corners == 3) return Answer::no;
  const std::array<std::uint32_t, 2> both{a.index, b.index};
  const bool is_unsure = any_of_copies(mesh(), loneliest_point(mesh(), both), [&](Vertex copy) {
    for (const Face other : faces_around(mesh(), copy)) {
      ++looks_;
      if (!other || other == f || other == beyond || corner_count(other) + 1 < corners) continue;
      if (corner_count(other) + 1 == corners || !known_.is_one_simple_loop(mesh(), other)) return true;
    }
    return false;
  });
  return is_unsure ? Answer::unsure : Answer::yes;
}

// In the order in which check() refuses.
std::optional<Rule> UniteSeries::broken_rule(Vertex v) {
  const Mesh& m = mesh();
  is_sure_ = false;
  if (!is_there(m, v)) return Rule::deleted;
  if (has_copies(m, v)) return Rule::copies;
  if (!has_two_edges(m, v)) return Rule::two_edges;
  const Halfedge out = m.halfedge(v), other = m.counter_clockwise(out);
  const Vertex a = m.to(out), b = m.to(other);
  if (any_sheet_between(m, a, b)) return Rule::edge_exists;
  const Face f = m.face(out), g = m.face(other);
  bool is_sure = true;
  for (const auto& [face, beyond] : {std::pair{f, g}, std::pair{g, f}}) {
    const Answer answer = face ? answer_of_face(face, beyond, a, b) : Answer::yes;
    if (answer == Answer::no && is_sure) return Rule::loop;
    is_sure = is_sure && answer == Answer::yes;
  }
  is_sure_ = is_sure;
  if (is_sure) return std::nullopt;
  return first_rule_of(UniteEdge{v}.check(m));
}

void UniteSeries::apply(Vertex v) {
  const OpEffect effect = UniteEdge{v}.apply(*edit_);
  if (!is_sure_) return forget(effect);
  for (const Face f : effect.changed) known_.lost_corner(f);
}

void UniteSeries::forget(const OpEffect& other) {
  for (const Face f : other.changed) known_.forget(f);
  for (const Element& e : other.deleted)
    if (e.kind == Element::Kind::face) known_.forget(e.face());
}

bool UniteSeries::unite(Vertex v) {
  if (broken_rule(v)) return false;
  apply(v);
  return true;
}

namespace {

class UnitedEdges : public OneByOne {
 public:
  explicit UnitedEdges(Edit& edit) : OneByOne(edit), series_(edit) {}
  std::optional<Rule> broken_rule(const AnyOp& op) override {
    return series_.broken_rule(std::get<UniteEdge>(op).vertex);
  }
  void apply(const AnyOp& op) override { series_.apply(std::get<UniteEdge>(op).vertex); }

 private:
  UniteSeries series_;
};

}  // namespace

std::unique_ptr<OpSeries> unites_edges_in_series(Edit& edit) { return std::make_unique<UnitedEdges>(edit); }

std::vector<Vertex> ends_with_more_edges(const Mesh& mesh, std::span<const Element> elements) {
  std::vector<Vertex> found;
  for (const Element& e : elements) {
    if (!is_alive(mesh, e) || (e.kind != Element::Kind::edge && e.kind != Element::Kind::halfedge)) continue;
    const auto [a, b] = ends(mesh, e.kind == Element::Kind::edge ? e.edge() : edge(e.halfedge()));
    for (const Vertex v : {a, b})
      if (!has_two_edges(mesh, v)) found.push_back(v);
  }
  sort_unique(found);
  return found;
}

std::size_t unite_ends(Edit& edit, std::span<const Vertex> ends) {
  UniteSeries series(edit);
  std::size_t taken = 0;
  for (const Vertex v : ends)
    if (edit.mesh().is_alive(v) && has_two_edges(edit.mesh(), v) && series.unite(v)) ++taken;
  return taken;
}

}  // namespace ryosen
