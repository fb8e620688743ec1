#include "ryosen/ops/preview/remedy_candidates.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

constexpr std::size_t largest_sheet = 1000;

bool touches_others(const Mesh& m, const std::vector<Face>& sheet) {
  const std::unordered_set<Face> own(sheet.begin(), sheet.end());
  const auto touches = [&](Vertex copy) {
    for (Face other : faces_around(m, copy))
      if (other && !own.contains(other)) return true;
    return false;
  };
  for (Face f : sheet)
    for (Vertex v : vertices_around(m, f))
      if (any_of_copies(m, v, touches)) return true;
  return false;
}

}  // namespace

std::uint32_t KnownSheets::key(const Mesh& mesh, Face f) {
  const Sheet& sheet = find(mesh, f);
  return sheet.number == large || sheet.touches ? sheet.number : f.index;
}

const KnownSheets::Sheet& KnownSheets::find(const Mesh& mesh, Face f) {
  if (const auto known = sheets_.find(f); known != sheets_.end()) return known->second;
  const auto is_on_large = [&](Face other) {
    const auto known = sheets_.find(other);
    return known != sheets_.end() && known->second.number == large;
  };
  const std::vector<Face> sheet = faces_of_sheet(mesh, f, largest_sheet, is_on_large);
  if (sheet.size() >= largest_sheet || is_on_large(sheet.back())) {
    for (Face other : sheet) sheets_[other] = {large, true};
  } else {
    const bool touches = touches_others(mesh, sheet);
    for (Face other : sheet) sheets_[other] = {f.index, touches};
  }
  return sheets_[f];
}

namespace {

constexpr std::size_t most_sides_tried = 12;
// A trial costs the copies of its points; with more than these it is not made.
constexpr std::size_t most_copies_tried = 64;
constexpr std::size_t longest_hole_filled = 64;

// Collects the operators that may help against one reason: each way looks at the witnesses of the kind that it is
// about.
class Candidates {
 public:
  Candidates(const Mesh& mesh, const Reason& reason, KnownSheets& sheets)
      : m_(mesh), witnesses_(reason.witnesses), sheets_(sheets) {
    for (const Element& witness : witnesses_) {
      if (witness.kind == Element::Kind::vertex) vertices_.push_back(witness.vertex());
      if (witness.kind == Element::Kind::edge) edges_.push_back(witness.edge());
      if (witness.kind == Element::Kind::face && !witness.face().is_none()) faces_.push_back(witness.face());
    }
  }

  std::vector<AnyOp> take() { return std::move(found_); }

  void split_sides() {
    for (Face f : faces_) {
      std::size_t tried = 0;
      for (Halfedge h : halfedges_around(m_, f))
        if (tried++ < most_sides_tried && !(has_many_copies(m_.from(h)) && has_many_copies(m_.to(h))))
          found_.push_back(SplitEdge{h});
    }
  }

  void split_edges() {
    for (Edge e : edges_) found_.push_back(SplitEdge{halfedge(e)});
  }

  void triangulate_faces() {
    for (Face f : faces_) found_.push_back(Triangulate{f});
  }

  void fill_at_edges() {
    for (Edge e : edges_)
      for (Halfedge h : {halfedge(e), twin(halfedge(e))}) fill(h);
  }

  void fill_at_vertices() {
    for (Vertex v : vertices_)
      for (Halfedge h : outgoing(m_, v)) fill(h);
  }

  // Triangles at a boundary edge, with the next or the previous vertex of the boundary.
  void put_triangles_beside() {
    for (Edge e : edges_)
      for (Halfedge h : {halfedge(e), twin(halfedge(e))}) {
        if (!m_.is_outside(h)) continue;
        for (Vertex third : {m_.to(m_.next(h)), m_.from(m_.prev(h))})
          found_.push_back(MakeFace{{m_.from(h), m_.to(h), third}});
      }
  }

  // Triangles that close the gaps of vertices.
  void put_triangles_in_gaps() {
    for (Vertex v : vertices_)
      for (Halfedge h : outgoing(m_, v))
        if (m_.is_outside(h)) found_.push_back(MakeFace{{m_.from(m_.prev(h)), v, m_.to(h)}});
  }

  void divide_faces() {
    for (Face f : faces_) {
      std::vector<Halfedge> sides;
      for (Halfedge h : loop(m_, m_.halfedge(f)))
        if (sides.size() < most_sides_tried) sides.push_back(h);
      for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t k = i + 2; k < sides.size(); ++k) found_.push_back(SeparateLoop{sides[i], sides[k]});
    }
  }

  // Last witness first: it is usually the face in the way.
  void remove_faces() {
    for (std::size_t i = faces_.size(); i-- > 0;) {
      found_.push_back(DeleteLoop{{faces_[i]}});
      found_.push_back(Delete{faces_[i]});
    }
  }

  void detach_faces() {
    for (std::size_t i = faces_.size(); i-- > 0;) detach(faces_[i]);
  }

  // Separated fans of the points of vertices and edges, and detachments of the sheets there, those at the edge between
  // two of them first.
  void detach_sheets() {
    std::vector<Vertex> points;
    for (const Element& witness : witnesses_) {
      if (witness.kind == Element::Kind::vertex) points.push_back(witness.vertex());
      if (witness.kind != Element::Kind::edge) continue;
      const auto [a, b] = ends(m_, witness.edge());
      points.insert(points.end(), {a, b});
    }
    if (std::any_of(points.begin(), points.end(), [&](Vertex v) { return has_many_copies(v); })) return;
    for (Vertex v : points) found_.push_back(SeparateFans{{v}});
    if (points.size() == 2)
      for (Halfedge h : sheets_between(m_, points[0], points[1])) {
        detach(m_.face(h));
        detach(m_.face(twin(h)));
      }
    for (Vertex v : points)
      any_of_copies(m_, v, [&](Vertex copy) {
        for (Face f : faces_around(m_, copy)) detach(f);
        return has_enough_sheets();
      });
  }

  // Vertices in the sides of faces, without cutting triangles.
  void divide_sides() {
    for (Face f : faces_)
      for (Halfedge h : halfedges_around(m_, f)) try_one(SeparateEdge{h});
  }

  // Deletions of the wires and (leaving wires) of the faces at vertices.
  void take_edges_away() {
    for (Vertex v : vertices_) {
      for (Halfedge h : outgoing(m_, v))
        if (m_.is_wire(edge(h))) try_one(DeleteEdge{{h}});
      for (Face f : faces_around(m_, v))
        if (f) try_one(DeleteLoop{{f}});
    }
  }

  // Wires from the end of a lone edge to a vertex that is isolated or has a gap.
  void put_wires_beside() {
    for (Edge e : edges_) {
      const Halfedge h = halfedge(e);
      for (std::uint32_t i = 0; i < m_.vertex_slots() && found_.size() < most_sides_tried; ++i) {
        const Vertex v(i);
        if (!m_.is_alive(v) || v == m_.from(h) || v == m_.to(h) || (!m_.is_isolated(v) && !m_.is_boundary(v))) continue;
        found_.push_back(MakeEdge{m_.to(h), v, h, m_.is_isolated(v) ? Halfedge() : m_.prev(m_.halfedge(v))});
      }
    }
  }

  // Bridges between the loops of a face.
  void bridge_loops() {
    for (Face f : faces_) {
      if (!m_.has_rings(f)) continue;
      for (Halfedge outer : loop(m_, m_.halfedge(f)))
        for (Halfedge inner : loop(m_, m_.ring(m_.first_ring(f)).halfedge)) try_one(UniteRing{outer, inner});
    }
  }

 private:
  void try_one(AnyOp op) {
    if (found_.size() < most_sides_tried) found_.push_back(std::move(op));
  }

  void fill(Halfedge h) {
    if (!m_.is_outside(h)) return;
    std::size_t sides = 0;
    for ([[maybe_unused]] Halfedge side : loop(m_, h))
      if (++sides > longest_hole_filled) return;
    found_.push_back(Fill{{h}});
  }

  bool has_many_copies(Vertex v) const {
    std::size_t copies = 0;
    return any_of_copies(m_, v, [&](Vertex) { return ++copies > most_copies_tried; });
  }

  bool has_enough_sheets() const { return found_.size() + repeated_ >= most_sides_tried; }

  // The sheet of a face. Large sheets are skipped: every trial would cost O(mesh). A sheet is tried once, but counts
  // towards the limit each time it is added.
  void detach(Face f) {
    if (!f || has_enough_sheets()) return;
    const std::uint32_t key = sheets_.key(m_, f);
    if (key == KnownSheets::large) return;
    if (std::find(detached_.begin(), detached_.end(), key) != detached_.end()) {
      ++repeated_;
      return;
    }
    detached_.push_back(key);
    found_.push_back(Detach{{f}});
  }

  const Mesh& m_;
  const std::vector<Element>& witnesses_;
  KnownSheets& sheets_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<AnyOp> found_;
  std::vector<std::uint32_t> detached_;  // keys
  std::size_t repeated_ = 0;
};

// The ways that may help against a rule, in the order in which they are tried.
struct Ways {
  Rule rule;
  void (Candidates::*first)();
  void (Candidates::*second)() = nullptr;
};
constexpr Ways ways_against[] = {
    {Rule::copies, &Candidates::detach_sheets},
    {Rule::boundary, &Candidates::fill_at_edges, &Candidates::put_triangles_beside},
    {Rule::wire, &Candidates::fill_at_edges, &Candidates::put_triangles_beside},
    {Rule::inner_edge, &Candidates::fill_at_vertices, &Candidates::put_triangles_in_gaps},
    {Rule::common_face, &Candidates::divide_faces},
    {Rule::same_apex, &Candidates::remove_faces},
    {Rule::has_face, &Candidates::remove_faces},
    {Rule::no_gap, &Candidates::remove_faces},
    {Rule::closes_hole, &Candidates::split_edges},
    {Rule::common_neighbour, &Candidates::split_edges},
    {Rule::edge_exists, &Candidates::split_edges},
    {Rule::vanishes, &Candidates::divide_sides, &Candidates::detach_sheets},
    {Rule::has_edges, &Candidates::take_edges_away},
    {Rule::lone_edge, &Candidates::put_wires_beside},
    {Rule::different_loops, &Candidates::bridge_loops},
    {Rule::isolated_apex, &Candidates::detach_sheets, &Candidates::split_sides},
    {Rule::duplicate_face, &Candidates::detach_sheets, &Candidates::split_sides},
    {Rule::corner_twice, &Candidates::detach_sheets, &Candidates::split_sides},
    {Rule::loses_duplicate, &Candidates::remove_faces, &Candidates::detach_faces},
    {Rule::has_rings, &Candidates::triangulate_faces},
};

}  // namespace

std::vector<AnyOp> remedy_candidates(const Mesh& m, const Reason& reason, KnownSheets& sheets) {
  Candidates candidates(m, reason, sheets);
  for (const Ways& ways : ways_against) {
    if (ways.rule != reason.rule) continue;
    (candidates.*ways.first)();
    if (ways.second) (candidates.*ways.second)();
  }
  return candidates.take();
}

}  // namespace ryosen
