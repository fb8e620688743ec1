#include "core/analysis/highlights.h"

#include <algorithm>

#include "core/mesh/circulate.h"

namespace ryosen {

namespace {

bool holds(const ProblemRow& row, Neighbourhood& around, Vertex v) { return row.vertex(around, v); }
bool holds(const ProblemRow& row, Neighbourhood& around, Edge e) { return row.edge(around, e); }
bool holds(const ProblemRow& row, Neighbourhood& around, Face f) { return row.face(around, f); }

bool speaks_of(const ProblemRow& row, Vertex) { return row.vertex != nullptr; }
bool speaks_of(const ProblemRow& row, Edge) { return row.edge != nullptr; }
bool speaks_of(const ProblemRow& row, Face) { return row.face != nullptr; }

template <class Element>
void search(const ProblemRow& row, Neighbourhood& around, std::uint32_t slots, IndexSet& set) {
  if (!speaks_of(row, Element())) return;
  for (std::uint32_t i = 0; i < slots; ++i)
    if (around.mesh().is_alive(Element(i)) && holds(row, around, Element(i))) set.insert(i);
}

// The elements whose answer a transaction may have changed. Dead ones and those past the end are among them.
struct Reach {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
};

template <class Handle>
void remove_repetitions(std::vector<Handle>& handles) {
  std::sort(handles.begin(), handles.end());
  handles.erase(std::unique(handles.begin(), handles.end()), handles.end());
}

void add_touched_cell(TouchedCell cell, Reach& reach) {
  switch (cell.column) {
    case Column::vertex_halfedge:
    case Column::position:
    case Column::next_copy:
      reach.vertices.emplace_back(cell.index);
      break;
    case Column::from:
    case Column::next:
    case Column::prev:
    case Column::face:
      reach.edges.push_back(edge(Halfedge(cell.index)));
      break;
    case Column::face_halfedge:
      reach.faces.emplace_back(cell.index);
      break;
    default:  // attributes decide nothing here
      break;
  }
}

// A predicate looks at the faces around the points of its element. Whatever changed there, some link, origin or
// position at one of these points was written, or one of a neighbour's copies; so it is enough to ask all elements at
// the points of what was written, and their neighbours.
Reach reach_of(const Mesh& mesh, std::span<const TouchedCell> cells, const ColumnLengths& before,
               Neighbourhood& around) {
  Reach reach;
  for (TouchedCell cell : cells) add_touched_cell(cell, reach);
  for (std::uint32_t i = before.vertices; i < mesh.vertex_slots(); ++i) reach.vertices.emplace_back(i);
  for (std::uint32_t i = before.halfedges / 2; i < mesh.edge_slots(); ++i) reach.edges.emplace_back(i);
  for (std::uint32_t i = before.faces; i < mesh.face_slots(); ++i) reach.faces.emplace_back(i);
  remove_repetitions(reach.edges);

  for (Edge e : reach.edges)
    if (mesh.exists(e) && mesh.is_alive(e))
      for (Vertex v : {mesh.from(halfedge(e, 0)), mesh.from(halfedge(e, 1))}) reach.vertices.push_back(v);
  remove_repetitions(reach.vertices);

  std::vector<Vertex> points;
  for (Vertex v : reach.vertices)
    if (mesh.exists(v) && mesh.is_alive(v)) points.push_back(around.point(v));
  remove_repetitions(points);
  for (Vertex p : points)
    for_each_copy(mesh, p, [&](Vertex copy) {
      reach.vertices.push_back(copy);
      if (mesh.is_isolated(copy)) return;
      for (Halfedge h : outgoing(mesh, copy)) {
        reach.edges.push_back(edge(h));
        reach.vertices.push_back(around.point(mesh.to(h)));
        if (!mesh.is_outside(h)) reach.faces.push_back(mesh.face(h));
      }
    });
  remove_repetitions(reach.vertices);
  remove_repetitions(reach.edges);
  remove_repetitions(reach.faces);
  return reach;
}

}  // namespace

HighlightSets::HighlightSets(const Mesh& mesh) {
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  *this = HighlightSets(around);
}

HighlightSets::HighlightSets(Neighbourhood& around) : had_copies_(around.mesh().has_copies()) {
  const Mesh& mesh = around.mesh();
  for (const ProblemRow& row : problem_table()) {
    IndexSet& set = sets_[static_cast<std::size_t>(row.kind)];
    if (row.find_all) {
      for (std::uint32_t i : row.find_all(around)) set.insert(i);
      continue;
    }
    search<Vertex>(row, around, mesh.vertex_slots(), set);
    search<Edge>(row, around, mesh.edge_slots(), set);
    search<Face>(row, around, mesh.face_slots(), set);
  }
}

void HighlightSets::set(ProblemKind kind, std::uint32_t index, bool is_member) {
  IndexSet& members = sets_[static_cast<std::size_t>(kind)];
  if (is_member ? members.insert(index) : members.erase(index)) changes_.push_back({kind, index, is_member});
}

void HighlightSets::update(const Mesh& mesh, const Journal& journal, std::size_t i) {
  // The journal does not list the cells of a column of copies that came or went as a whole.
  if (journal.replaces_everything(i) || had_copies_ != mesh.has_copies()) {
    *this = HighlightSets(mesh);
    return;
  }
  changes_.clear();
  changed_everything_ = false;
  Neighbourhood around(mesh);
  const std::vector<TouchedCell> cells = journal.touched(i);
  const ColumnLengths& before = journal.lengths_before(i);
  const Reach reach = reach_of(mesh, cells, before, around);
  const auto ask = [&](const ProblemRow& row, const auto& elements) {
    for (const auto element : elements)
      if (speaks_of(row, element))
        set(row.kind, element.index, mesh.exists(element) && mesh.is_alive(element) && holds(row, around, element));
  };
  for (const ProblemRow& row : problem_table()) {
    ask(row, reach.vertices);
    ask(row, reach.edges);
    ask(row, reach.faces);
    // Slots that undoing took away.
    if (!row.is_local()) continue;
    const std::uint32_t slots = row.vertex ? mesh.vertex_slots() : row.edge ? mesh.edge_slots() : mesh.face_slots();
    std::vector<std::uint32_t> gone;
    sets_[static_cast<std::size_t>(row.kind)].for_each_from(slots, [&](std::uint32_t k) { gone.push_back(k); });
    for (std::uint32_t k : gone) set(row.kind, k, false);
  }
}

}  // namespace ryosen
