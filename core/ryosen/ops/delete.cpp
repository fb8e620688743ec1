#include "ryosen/ops/delete.h"

#include <algorithm>
#include <cassert>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/manifold_points.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/pinch_watch.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

using namespace parameters;

// An edge named by its points stands for all its sheets; returns any of them.
Named<Halfedge> find_any_sheet(const Mesh& mesh, std::string_view name) {
  Named<Halfedge> found = find_edge(mesh, name);
  if (found.error != NameError::ambiguous) return found;
  const std::size_t dash = name.find('-');
  const Named<Vertex> a = find_vertex(mesh, name.substr(0, dash)), b = find_vertex(mesh, name.substr(dash + 1));
  if (!a.ok() || !b.ok()) return found;
  return {sheets_between(mesh, a.element, b.element).front(), NameError::none, {}};
}

constexpr OpParameter delete_vertex[] = {required(vertex<&Delete::element>("vN"))},
                      delete_edge[] = {required(edge<&Delete::element, find_any_sheet>("A-B"))},
                      delete_face[] = {required(face<&Delete::element>("fN"))};

}  // namespace

constinit const OpInfo Delete::info{
    .id = "delete",
    .name_en = "Delete",
    .name_ja = "削除",
    .line = {.lists = {delete_vertex, delete_edge, delete_face}},
    .help_en = "deletes the faces at a vertex or edge, a face, or a wire, and what becomes unused",
    .help_ja = "頂点・稜線に接する面、面、面のない稜線を、不要になる要素とともに削除する",
    .key = '\0',
    .target = OpTargetKind::any,
    .group = OpGroup::fill,
    .aliases = "remove",
    .in_series = deletes_in_series};

namespace {

// The faces and wires to delete, and for a vertex the copies of its point.
Deletion deletion_of(const Mesh& mesh, Element element) {
  Deletion deletion;
  const auto add_edge = [&](Halfedge h) {
    for (Halfedge side : {h, twin(h)})
      if (!mesh.is_outside(side)) deletion.faces.push_back(mesh.face(side));
    if (mesh.is_wire(edge(h))) deletion.wires.push_back(h);
  };
  if (element.kind == Element::Kind::face) deletion.faces.push_back(element.face());
  if (element.kind == Element::Kind::edge) {
    const auto [a, b] = ends(mesh, element.edge());
    for (Halfedge h : sheets_between(mesh, a, b)) add_edge(h);
  }
  if (element.kind == Element::Kind::vertex)
    for_each_copy(mesh, element.vertex(), [&](Vertex copy) {
      deletion.vertices.push_back(copy);
      for (Halfedge h : outgoing(mesh, copy)) add_edge(h);
    });
  sort_unique(deletion.faces);
  return deletion;
}

}  // namespace

Delete Delete::at(const Mesh&, const OpTarget& target) {
  if (target.vertex) return {target.vertex};
  if (target.face) return {target.face};
  return {edge(target.halfedge)};
}

Verdict Delete::check(const Mesh& mesh) const {
  Verdict verdict;
  if (element.kind == Element::Kind::vertex) is_gone(mesh, element.vertex(), verdict);
  if (element.kind == Element::Kind::edge) is_gone(mesh, halfedge(element.edge()), verdict);
  if (element.kind == Element::Kind::face) is_gone(mesh, element.face(), verdict);
  return verdict;
}

std::vector<Reason> Delete::warnings(const Mesh& mesh) const {
  std::vector<Reason> reasons;
  warn_of_pinch(pinched_without(mesh, deletion_of(mesh, element).faces), reasons);
  return reasons;
}

void delete_elements(Edit& edit, Sheets& sheets, const Deletion& deletion, ManifoldPoints* known) {
  const Mesh& m = edit.mesh();
  std::vector<Halfedge> unused = deletion.wires;
  std::vector<Vertex> bare = deletion.vertices, points;
  for (Face f : deletion.faces)
    for (Halfedge h : halfedges_around(m, f)) {
      unused.push_back(h);
      points.push_back(point(m, m.from(h)));
    }
  for (Face f : deletion.faces) {
    if (known) known->loses(f);
    sheets.remove_face(f);
  }
  for (Halfedge h : unused) {
    if (!m.is_alive(h) || !m.is_wire(edge(h))) continue;
    bare.insert(bare.end(), {m.from(h), m.to(h)});
    sheets.remove_edge(h);
  }
  // Descending, so that the representative of a point comes last and a copy can take over its number.
  std::sort(bare.begin(), bare.end(), std::greater<>());
  bare.erase(std::unique(bare.begin(), bare.end()), bare.end());
  std::erase_if(bare, [&](Vertex v) { return !m.is_alive(v) || !m.is_isolated(v); });
  sheets.remove_vertices(bare);
  if (known)
    known->make_manifold();
  else
    sheets.make_manifold(points);
}

OpEffect Delete::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  Sheets sheets(edit);
  delete_elements(edit, sheets, deletion_of(edit.mesh(), element));
  return sheets.finish();
}

namespace {

class Deletes : public OneByOne {
 public:
  explicit Deletes(Edit& edit) : OneByOne(edit), sheets_(edit), known_(sheets_), pinches_(edit.mesh()) {}
  std::optional<Rule> doubt(const AnyOp& op) override {
    const Deletion deletion = deletion_of(edit_.mesh(), std::get<Delete>(op).element);
    return pinches_.is_pinched_without(deletion.faces) ? std::optional(Rule::pinch) : std::nullopt;
  }
  void apply(const AnyOp& op) override {
    const Deletion deletion = deletion_of(edit_.mesh(), std::get<Delete>(op).element);
    pinches_.loses(deletion.faces);
    delete_elements(edit_, sheets_, deletion, &known_);
  }

 private:
  Sheets sheets_;
  ManifoldPoints known_;
  PinchWatch pinches_;
};

}  // namespace

std::unique_ptr<OpSeries> deletes_in_series(Edit& edit) { return std::make_unique<Deletes>(edit); }

}  // namespace ryosen
