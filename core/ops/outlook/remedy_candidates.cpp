#include "core/ops/outlook/remedy_candidates.h"

#include <algorithm>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/rules/sheets.h"

namespace ryosen {

namespace {

constexpr std::size_t most_sides_tried = 12;
constexpr std::size_t longest_hole_filled = 64;

// The faces named as witnesses, the last first.
std::vector<Face> faces_of(const Reason& reason) {
  std::vector<Face> faces;
  for (const Element& witness : reason.witnesses)
    if (witness.kind == Element::Kind::face && !witness.face().is_none()) faces.insert(faces.begin(), witness.face());
  return faces;
}

// Splits of the sides of witness faces.
void add_splits_of_sides(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face) continue;
    std::size_t tried = 0;
    for (Halfedge h : halfedges_around(m, witness.face()))
      if (tried++ < most_sides_tried) candidates.push_back(SplitEdge{h});
  }
}

// Splits of witness edges.
void add_splits_of_edges(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses)
    if (witness.kind == Element::Kind::edge) candidates.push_back(SplitEdge{halfedge(witness.edge())});
}

// Triangulations of witness faces.
void add_triangulations(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses)
    if (witness.kind == Element::Kind::face) candidates.push_back(Triangulate{witness.face()});
}

std::vector<Vertex> vertices_of(const Mesh& m, const Element& witness) {
  if (witness.kind == Element::Kind::vertex) return {witness.vertex()};
  if (witness.kind != Element::Kind::edge) return {};
  const auto [a, b] = ends(m, witness.edge());
  return {a, b};
}

bool is_small_hole(const Mesh& m, Halfedge h) {
  std::size_t sides = 0;
  for ([[maybe_unused]] Halfedge side : loop(m, h))
    if (++sides > longest_hole_filled) return false;
  return true;
}

// Fills of the holes at witness edges.
void add_fillings_at_edges(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::edge) continue;
    for (unsigned side : {0u, 1u})
      if (const Halfedge h = halfedge(witness.edge(), side); m.is_outside(h) && is_small_hole(m, h))
        candidates.push_back(Fill{h});
  }
}

// Fills of the holes at witness vertices.
void add_fillings_at_vertices(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::vertex) continue;
    for (Halfedge h : outgoing(m, witness.vertex()))
      if (m.is_outside(h) && is_small_hole(m, h)) candidates.push_back(Fill{h});
  }
}

// Triangles at a boundary edge, with the next or the previous vertex of the boundary.
void add_triangles_beside(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::edge) continue;
    for (unsigned side : {0u, 1u}) {
      const Halfedge h = halfedge(witness.edge(), side);
      if (!m.is_outside(h)) continue;
      for (Vertex third : {m.to(m.next(h)), m.from(m.prev(h))})
        candidates.push_back(MakeFace{{m.from(h), m.to(h), third}});
    }
  }
}

// Triangles that close the gaps of witness vertices.
void add_triangles_in_gaps(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::vertex) continue;
    const Vertex v = witness.vertex();
    for (Halfedge h : outgoing(m, v))
      if (m.is_outside(h)) candidates.push_back(MakeFace{{m.from(m.prev(h)), v, m.to(h)}});
  }
}

// Diagonals of witness faces.
void add_diagonals(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face) continue;
    std::vector<Halfedge> sides;
    for (Halfedge h : loop(m, m.halfedge(witness.face())))
      if (sides.size() < most_sides_tried) sides.push_back(h);
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t k = i + 2; k < sides.size(); ++k) candidates.push_back(SeparateLoop{sides[i], sides[k]});
  }
}

// Last witness first: it is usually the face in the way.
void add_removals(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Face f : faces_of(reason)) {
    candidates.push_back(DeleteLoop{f});
    candidates.push_back(Delete{f});
  }
}

// Detachments of sheets, each given by one face. Large sheets are skipped: every trial would cost O(mesh). A sheet is
// tried once, but counts towards the limit each time it is added.
class Detachments {
 public:
  Detachments(const Mesh& mesh, KnownSheets& sheets, std::vector<AnyOp>& candidates)
      : mesh_(mesh), sheets_(sheets), candidates_(candidates) {}

  void add(Face f) {
    if (!f || candidates_.size() + repeated_ >= most_sides_tried) return;
    const std::uint32_t key = sheets_.key(mesh_, f);
    if (key == KnownSheets::large) return;
    if (std::find(tried_.begin(), tried_.end(), key) != tried_.end()) {
      ++repeated_;
      return;
    }
    tried_.push_back(key);
    candidates_.push_back(Detach{{f}});
  }

 private:
  const Mesh& mesh_;
  KnownSheets& sheets_;
  std::vector<AnyOp>& candidates_;
  std::vector<std::uint32_t> tried_;  // keys
  std::size_t repeated_ = 0;
};

void add_detachments_of_faces(const Mesh& m, const Reason& reason, KnownSheets& sheets,
                              std::vector<AnyOp>& candidates) {
  Detachments detachments(m, sheets, candidates);
  for (const Face f : faces_of(reason)) detachments.add(f);
}

// Separated fans of the witness points, and detachments of the sheets there, those at the edge between two witnesses
// first.
void add_detachments(const Mesh& m, const Reason& reason, KnownSheets& sheets, std::vector<AnyOp>& candidates) {
  std::vector<Vertex> points;
  for (const Element& witness : reason.witnesses)
    for (Vertex v : vertices_of(m, witness)) points.push_back(v);
  Detachments detachments(m, sheets, candidates);
  const auto add = [&](Face f) { detachments.add(f); };
  for (Vertex v : points) candidates.push_back(SeparateFans{v});
  if (points.size() == 2)
    for (Halfedge h : sheets_between(m, points[0], points[1])) {
      add(m.face(h));
      add(m.face(twin(h)));
    }
  for (Vertex v : points)
    for_each_copy(m, v, [&](Vertex copy) {
      for (Face f : faces_around(m, copy)) add(f);
    });
}

// Vertices inserted into the sides of witness faces, without cutting triangles.
void add_divisions_of_sides(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face) continue;
    for (Halfedge h : halfedges_around(m, witness.face()))
      if (candidates.size() < most_sides_tried) candidates.push_back(SeparateEdge{h});
  }
}

// Deletions of the wires and (leaving wires) of the faces at witness vertices.
void add_edges_away(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::vertex) continue;
    for (Halfedge h : outgoing(m, witness.vertex()))
      if (m.is_wire(edge(h)) && candidates.size() < most_sides_tried) candidates.push_back(DeleteEdge{h});
    for (Face f : faces_around(m, witness.vertex()))
      if (f && candidates.size() < most_sides_tried) candidates.push_back(DeleteLoop{f});
  }
}

// Wires from the end of a lone edge to a vertex that is isolated or has a gap.
void add_wires_beside(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::edge) continue;
    const Halfedge h = halfedge(witness.edge());
    for (std::uint32_t i = 0; i < m.vertex_slots() && candidates.size() < most_sides_tried; ++i) {
      const Vertex v(i);
      if (!m.is_alive(v) || v == m.from(h) || v == m.to(h) || (!m.is_isolated(v) && !m.is_boundary(v))) continue;
      candidates.push_back(MakeEdge{m.to(h), v, h, m.is_isolated(v) ? Halfedge() : m.prev(m.halfedge(v))});
    }
  }
}

// Bridges between the loops of a witness face.
void add_bridges(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face || !m.has_rings(witness.face())) continue;
    const Halfedge ring = m.ring(m.first_ring(witness.face())).halfedge;
    for (Halfedge outer : loop(m, m.halfedge(witness.face())))
      for (Halfedge inner : loop(m, ring))
        if (candidates.size() < most_sides_tried) candidates.push_back(UniteRing{outer, inner});
  }
}

}  // namespace

std::vector<AnyOp> remedy_candidates(const Mesh& m, const Reason& reason, KnownSheets& sheets) {
  std::vector<AnyOp> candidates;
  switch (reason.rule) {
    case Rule::copies:
      add_detachments(m, reason, sheets, candidates);
      break;
    case Rule::boundary:
    case Rule::wire:
      add_fillings_at_edges(m, reason, candidates);
      add_triangles_beside(m, reason, candidates);
      break;
    case Rule::inner_edge:
      add_fillings_at_vertices(m, reason, candidates);
      add_triangles_in_gaps(m, reason, candidates);
      break;
    case Rule::common_face:
      add_diagonals(m, reason, candidates);
      break;
    case Rule::same_apex:
    case Rule::has_face:
    case Rule::no_gap:
      add_removals(reason, candidates);
      break;
    case Rule::closes_hole:
    case Rule::common_neighbour:
    case Rule::edge_exists:
      add_splits_of_edges(reason, candidates);
      break;
    case Rule::vanishes:
      add_divisions_of_sides(m, reason, candidates);
      add_detachments(m, reason, sheets, candidates);
      break;
    case Rule::has_edges:
      add_edges_away(m, reason, candidates);
      break;
    case Rule::lone_edge:
      add_wires_beside(m, reason, candidates);
      break;
    case Rule::different_loops:
      add_bridges(m, reason, candidates);
      break;
    case Rule::isolated_apex:
    case Rule::duplicate_face:
    case Rule::corner_twice:
      add_detachments(m, reason, sheets, candidates);
      add_splits_of_sides(m, reason, candidates);
      break;
    case Rule::loses_duplicate:
      add_removals(reason, candidates);
      add_detachments_of_faces(m, reason, sheets, candidates);
      break;
    case Rule::has_rings:
      add_triangulations(reason, candidates);
      break;
    default:
      break;
  }
  return candidates;
}

}  // namespace ryosen
