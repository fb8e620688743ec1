#include "ryosen/ops/delete.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/pinch.h"
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

constexpr OpParameter delete_vertex[] = {with_words(
    {"vertex", "Vertex", "頂点", "the vertex that is deleted, with all faces and wires there",
     "削除する頂点（そこの面と、面のない稜線も）"},
    required(vertex<&Delete::element>("vN")))},
                      delete_edge[] = {with_words(
                          {"edge", "Edge", "稜線", "the edge whose faces are deleted, or the wire",
                           "面を削除する稜線、または面のない稜線"},
                          required(edge<&Delete::element, find_any_sheet>("A-B")))},
                      delete_face[] = {with_words({"face", "Face", "面", "the face that is deleted", "削除する面"},
                                                  required(face<&Delete::element>("fN")))};

}  // namespace

constinit const OpInfo Delete::info{
    .id = "delete",
    .name_en = "Delete",
    .name_ja = "削除",
    .line = {.lists = {delete_vertex, delete_edge, delete_face}},
    .help_en = "deletes the faces at a vertex or edge, a face, or a wire, and what becomes unused",
    .help_ja = "頂点・稜線に接する面、面、面のない稜線を、不要になる要素とともに削除する",
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

namespace {

// Points from which faces are taken away one after another: what is to be cut and joined there is found at the edges
// that lose a face, not at all copies of the points. In between nothing else changes the mesh.
//
// Around a manifold point (Sheets::make_manifold) the loss of a face changes two things: an edge may be left with two
// faces in opposite directions, which are joined; and where a closed fan opens, an edge at which two faces of it were
// not cut apart may have to be. Both are rare, and then all is made manifold as for a single deletion.
class ManifoldPoints {
 public:
  explicit ManifoldPoints(Sheets& sheets) : sheets_(sheets) {}

  // Before the face is taken away.
  void loses(Face f) {
    const Mesh& m = mesh();
    if (!m.has_copies()) return;
    for (const Halfedge h : halfedges_around(m, f)) {
      const Vertex v = m.from(h);
      points_.push_back(point(m, v));
      if (!m.is_boundary(v)) opened_.emplace_back(v, points_.back());
      if (!has_copies(m, v) && !has_copies(m, m.to(h))) continue;  // at most one face is left there
      sides_.push_back(side_of(h));
      faces_at(sides_.back());
    }
  }
  // Afterwards: as Sheets::make_manifold() at the points of these faces.
  void make_manifold() {
    sort_unique(points_);
    std::vector<Vertex> others;
    for (const Vertex p : points_)
      if (!manifold_.contains(p)) others.push_back(p);
    if (is_manifold_where_lost() && sheets_.is_manifold(others)) {
      manifold_.insert(others.begin(), others.end());
    } else {
      for (const Vertex v : sheets_.make_manifold(points_))
        if (mesh().is_alive(v)) manifold_.erase(point(mesh(), v));
    }
    sides_.clear();
    points_.clear();
    opened_.clear();
  }

 private:
  struct Side {
    Vertex low, high;  // points
    bool is_forward;
  };

  const Mesh& mesh() const { return sheets_.mesh(); }
  Side side_of(Halfedge h) const {
    const Vertex a = point(mesh(), mesh().from(h)), b = point(mesh(), mesh().to(h));
    return {std::min(a, b), std::max(a, b), a < b};
  }
  // The faces along the edge, counted at the first call.
  PointEdge& faces_at(const Side& side) {
    const auto [edge, is_new] = edges_.try_emplace(std::uint64_t{side.low.index} << 32 | side.high.index);
    PointEdge& faces = edge->second;
    if (!is_new) return faces;
    const Mesh& m = mesh();
    const std::array<std::uint32_t, 2> ends{side.low.index, side.high.index};
    const bool is_low = loneliest_point(m, ends) == side.low;
    for (Halfedge h : sheets_between(m, is_low ? side.low : side.high, is_low ? side.high : side.low)) {
      faces.forward += !m.is_outside(is_low ? h : twin(h));
      faces.backward += !m.is_outside(is_low ? twin(h) : h);
    }
    return faces;
  }
  bool is_manifold_where_lost() {
    for (const Side& side : sides_) {
      PointEdge& faces = faces_at(side);
      --(side.is_forward ? faces.forward : faces.backward);
    }
    const bool has_pair = std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
      const PointEdge& faces = faces_at(side);
      return faces.forward == 1 && faces.backward == 1;
    });
    if (has_pair) return false;
    return std::none_of(opened_.begin(), opened_.end(),
                        [&](const auto& at) { return opens_an_edge(at.first, at.second); });
  }
  // Whether an edge at the vertex, whose fan has a gap now, is to be cut. A copy may have taken the number of its
  // point.
  bool opens_an_edge(Vertex v, Vertex p) const {
    const Mesh& m = mesh();
    if (!m.is_alive(v)) return m.is_alive(p) && opens_an_edge(p, p);
    if (m.is_isolated(v)) return false;
    for (const Halfedge h : outgoing(m, v))
      if (!m.is_outside(h) && !m.is_outside(twin(h)) && is_cut_on_points(m, h)) return true;
    return false;
  }

  Sheets& sheets_;
  std::unordered_set<Vertex> manifold_;
  std::unordered_map<std::uint64_t, PointEdge> edges_;
  // Sides and points of the deleted faces, and the vertices where a closed fan opens, with their points.
  std::vector<Side> sides_;
  std::vector<Vertex> points_;
  std::vector<std::pair<Vertex, Vertex>> opened_;
};

// The same as the one without it or, where it is one of several in a row, which share what they know, at the cost of
// what is near the faces.
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

}  // namespace

void delete_elements(Edit& edit, Sheets& sheets, const Deletion& deletion) {
  delete_elements(edit, sheets, deletion, nullptr);
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
