#include "core/ops/remedy.h"

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"

namespace ryosen {

namespace {

constexpr std::size_t longest_remedy = 4;
constexpr std::size_t most_sides_tried = 12;
constexpr std::size_t longest_hole_filled = 64;

// Splits of the sides of faces named as witnesses.
void add_splits_of_sides(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face) continue;
    std::size_t tried = 0;
    for (Halfedge h : halfedges_around(m, witness.face()))
      if (tried++ < most_sides_tried) candidates.push_back(SplitEdge{h});
  }
}

// Splits of the edges named as witnesses.
void add_splits_of_edges(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses)
    if (witness.kind == Element::Kind::edge) candidates.push_back(SplitEdge{halfedge(witness.edge())});
}

// Cuts through the faces named as witnesses.
void add_triangulations(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses)
    if (witness.kind == Element::Kind::face) candidates.push_back(Triangulate{witness.face()});
}

// Turning faces helps only where some edge at the points of the witnesses is misoriented.
bool is_beside_misoriented_edge(const Mesh& m, const Reason& reason) {
  for (const Element& witness : reason.witnesses) {
    const Vertex v = witness.kind == Element::Kind::vertex ? witness.vertex()
                     : witness.kind == Element::Kind::edge ? m.from(halfedge(witness.edge()))
                                                           : Vertex();
    if (!v) continue;
    bool found = false;
    for_each_copy(m, v, [&](Vertex copy) {
      for (Halfedge h : outgoing(m, copy)) found = found || point_edge(m, h).is_misoriented();
    });
    if (found) return true;
  }
  return false;
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

// Faces in the holes along edges that are witnesses.
void add_fillings_at_edges(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::edge) continue;
    for (unsigned side : {0u, 1u})
      if (const Halfedge h = halfedge(witness.edge(), side); m.is_outside(h) && is_small_hole(m, h))
        candidates.push_back(Fill{h});
  }
}

// Faces in the holes at vertices that are witnesses.
void add_fillings_at_vertices(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::vertex) continue;
    for (Halfedge h : outgoing(m, witness.vertex()))
      if (m.is_outside(h) && is_small_hole(m, h)) candidates.push_back(Fill{h});
  }
}

// Triangles beside an edge on the boundary, with the vertex after it or before it.
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

// Triangles that close the gaps of vertices that are witnesses.
void add_triangles_in_gaps(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::vertex) continue;
    const Vertex v = witness.vertex();
    for (Halfedge h : outgoing(m, v))
      if (m.is_outside(h)) candidates.push_back(MakeFace{{m.from(m.prev(h)), v, m.to(h)}});
  }
}

// Diagonals of the faces named as witnesses.
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

void add_removals(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face || witness.face().is_none()) continue;
    candidates.push_back(DeleteLoop{witness.face()});
    candidates.push_back(Delete{witness.face()});
  }
}

// The sheets at points named as witnesses come off, those on the edge between two of them first, or their fans come
// apart.
void add_detachments(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  std::vector<Vertex> points;
  for (const Element& witness : reason.witnesses)
    for (Vertex v : vertices_of(m, witness)) points.push_back(v);
  const auto add = [&](Face f) {
    if (f && candidates.size() < most_sides_tried) candidates.push_back(Detach{{f}});
  };
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

// Vertices in the sides of faces named as witnesses, which cut no triangle.
void add_divisions_of_sides(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face) continue;
    for (Halfedge h : halfedges_around(m, witness.face()))
      if (candidates.size() < most_sides_tried) candidates.push_back(SeparateEdge{h});
  }
}

// The wires at vertices named as witnesses go, the faces there become wires.
void add_edges_away(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::vertex) continue;
    for (Halfedge h : outgoing(m, witness.vertex()))
      if (m.is_wire(edge(h)) && candidates.size() < most_sides_tried) candidates.push_back(DeleteEdge{h});
    for (Face f : faces_around(m, witness.vertex()))
      if (f && candidates.size() < most_sides_tried) candidates.push_back(DeleteLoop{f});
  }
}

// Wires from the ends of a lone edge to a vertex with room.
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

// Bridges between the loops of a face named as witness.
void add_bridges(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face || !m.has_rings(witness.face())) continue;
    const Halfedge ring = m.ring(m.first_ring(witness.face())).halfedge;
    for (Halfedge outer : loop(m, m.halfedge(witness.face())))
      for (Halfedge inner : loop(m, ring))
        if (candidates.size() < most_sides_tried) candidates.push_back(UniteRing{outer, inner});
  }
}

// What may help against a reason; each is tried before it is named. What adds or cuts comes before what takes away.
std::vector<AnyOp> candidates_for(const Mesh& m, const Reason& reason) {
  std::vector<AnyOp> candidates;
  switch (reason.rule) {
    case Rule::copies:
      if (is_beside_misoriented_edge(m, reason)) candidates.push_back(Orient{});
      add_detachments(m, reason, candidates);
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
      add_detachments(m, reason, candidates);
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
      add_detachments(m, reason, candidates);
      add_splits_of_sides(m, reason, candidates);
      break;
    case Rule::loses_duplicate:
      add_splits_of_sides(m, reason, candidates);
      break;
    case Rule::has_rings:
      add_triangulations(reason, candidates);
      break;
    default:
      break;
  }
  return candidates;
}

// The reasons against the operator that a script line names, as the mesh is now; none when it names none any more.
std::optional<std::size_t> reasons_against(const Mesh& mesh, const std::string& line) {
  const Parsed<AnyOp> parsed = parse_line(mesh, line);
  if (!parsed.op) return std::nullopt;
  return check(mesh, *parsed.op).reasons.size();
}

// How many reasons a candidate would leave; none when it cannot be done or the line names nothing afterwards.
std::optional<std::size_t> reasons_after(Mesh& mesh, const std::string& line, const AnyOp& candidate) {
  if (!check(mesh, candidate).legal()) return std::nullopt;
  Journal scratch;
  Edit trial(mesh, &scratch);
  apply(trial, candidate);
  return reasons_against(mesh, line);
}

// The first candidate that leaves no reason, else the first that leaves fewer. Of several sheets on one edge each comes
// off for itself, of several edges at a vertex each goes for itself, and the reason stays until the last.
std::optional<AnyOp> choose_step(Mesh& mesh, const std::string& line, const Verdict& verdict) {
  std::optional<AnyOp> best, onward;
  for (const Reason& reason : verdict.reasons) {
    for (const AnyOp& candidate : candidates_for(mesh, reason)) {
      const auto left = reasons_after(mesh, line, candidate);
      if (left == 0u) return candidate;
      if (left && *left < verdict.reasons.size() && !best) best = candidate;
      const bool is_one_of_many = std::holds_alternative<Detach>(candidate) || reason.rule == Rule::has_edges;
      if (left == verdict.reasons.size() && !onward && is_one_of_many) onward = candidate;
    }
  }
  return best ? best : onward;
}

}  // namespace

std::vector<std::string> find_remedy(Mesh& mesh, const AnyOp& op) {
  if (check(mesh, op).has(Rule::deleted)) return {};
  // Remedies may renumber edges, so the operator is spoken of by its script line.
  const std::string line = command_of(mesh, op);
  Journal steps;
  std::vector<std::string> commands;
  bool legal = false;
  while (!legal && commands.size() < longest_remedy) {
    const Parsed<AnyOp> now = parse_line(mesh, line);
    const std::optional<AnyOp> step = now.op ? choose_step(mesh, line, check(mesh, *now.op)) : std::nullopt;
    if (!step) break;
    commands.push_back(command_of(mesh, *step));
    Edit edit(mesh, &steps);
    apply(edit, *step);
    edit.commit();
    legal = reasons_against(mesh, line) == 0u;
  }
  while (steps.can_undo()) steps.undo(mesh);
  return legal ? commands : std::vector<std::string>();
}

}  // namespace ryosen
