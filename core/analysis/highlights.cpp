#include "core/analysis/highlights.h"

#include <optional>

#include "core/base/parallel.h"
#include "core/base/sort_unique.h"
#include "core/mesh/circulate.h"

namespace ryosen {

namespace {

bool holds(const ProblemRow& row, Neighbourhood& around, Vertex v) { return row.vertex(around, v); }
bool holds(const ProblemRow& row, Neighbourhood& around, Edge e) { return row.edge(around, e); }
bool holds(const ProblemRow& row, Neighbourhood& around, Face f) { return row.face(around, f); }

bool speaks_of(const ProblemRow& row, Vertex) { return row.vertex != nullptr; }
bool speaks_of(const ProblemRow& row, Edge) { return row.edge != nullptr; }
bool speaks_of(const ProblemRow& row, Face) { return row.face != nullptr; }

using Members = std::array<std::vector<std::uint32_t>, problem_kinds>;

template <class Element>
void search(const ProblemRow& row, Neighbourhood& around, std::uint32_t slots, unsigned part, unsigned parts,
            std::vector<std::uint32_t>& members) {
  if (!speaks_of(row, Element())) return;
  const std::uint32_t end = part_begin(slots, part + 1, parts);
  for (std::uint32_t i = part_begin(slots, part, parts); i < end; ++i)
    if (around.mesh().is_alive(Element(i)) && holds(row, around, Element(i))) members.push_back(i);
}

// Asks one of `parts` parts of the vertices, of the edges and of the faces.
void search_part(Neighbourhood& around, unsigned part, unsigned parts, Members& members) {
  const Mesh& mesh = around.mesh();
  for (const ProblemRow& row : problem_table()) {
    if (row.find_all) continue;
    std::vector<std::uint32_t>& found = members[static_cast<std::size_t>(row.kind)];
    search<Vertex>(row, around, mesh.vertex_slots(), part, parts, found);
    search<Edge>(row, around, mesh.edge_slots(), part, parts, found);
    search<Face>(row, around, mesh.face_slots(), part, parts, found);
  }
}

void search_whole(Neighbourhood& around, Members& members) {
  for (const ProblemRow& row : problem_table())
    if (row.find_all) members[static_cast<std::size_t>(row.kind)] = row.find_all(around);
}

// The elements whose answer a transaction may have changed. Dead ones and those past the end are among them.
struct Reach {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
};

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
  sort_unique(reach.edges);

  for (Edge e : reach.edges)
    if (mesh.exists(e) && mesh.is_alive(e))
      for (Vertex v : {mesh.from(halfedge(e, 0)), mesh.from(halfedge(e, 1))}) reach.vertices.push_back(v);
  sort_unique(reach.vertices);

  std::vector<Vertex> points;
  for (Vertex v : reach.vertices)
    if (mesh.exists(v) && mesh.is_alive(v)) points.push_back(around.point(v));
  sort_unique(points);
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
  sort_unique(reach.vertices);
  sort_unique(reach.edges);
  sort_unique(reach.faces);
  return reach;
}

bool is_further(Neighbourhood& around, Vertex v) {
  const Mesh& mesh = around.mesh();
  return mesh.exists(v) && mesh.is_alive(v) && around.point(v) != v;
}

// Sheets with a face come first, then the lower ones.
bool is_further(Neighbourhood& around, Edge e) {
  const Mesh& mesh = around.mesh();
  if (!mesh.exists(e) || !mesh.is_alive(e) || around.is_single_sheet(halfedge(e))) return false;
  const auto has_face = [&](Edge sheet) {
    return !mesh.is_outside(halfedge(sheet, 0)) || !mesh.is_outside(halfedge(sheet, 1));
  };
  if (has_face(e)) return !around.is_first_sheet(e);
  const auto [p, q] = ends(mesh, e);
  for (Halfedge h : sheets_between(mesh, p, q))
    if (has_face(edge(h)) || edge(h) < e) return true;
  return false;
}

void put(IndexSet& set, std::uint32_t index, bool is_member) {
  if (is_member)
    set.insert(index);
  else
    set.erase(index);
}

std::vector<std::uint32_t> members_from(const IndexSet& set, std::uint32_t first) {
  std::vector<std::uint32_t> members;
  set.for_each_from(first, [&](std::uint32_t i) { members.push_back(i); });
  return members;
}

}  // namespace

HighlightSets::HighlightSets(const Mesh& mesh, unsigned threads) : had_copies_(mesh.has_copies()) {
  if (threads == 0) threads = threads_for(mesh.halfedge_slots());
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  const unsigned parts = threads == 1 ? 1 : 2 * threads;
  std::vector<Members> found(parts + 1);
  for_each_task(parts + 1, threads, [&](unsigned task) {
    std::optional<Neighbourhood> own;  // what is gathered must not be shared
    if (threads > 1) own.emplace(mesh, Neighbourhood::Reach::whole);
    if (task == 0)
      search_whole(own ? *own : around, found[parts]);
    else
      search_part(own ? *own : around, task - 1, parts, found[task - 1]);
  });
  for (const Members& members : found)
    for (std::size_t kind = 0; kind < problem_kinds; ++kind)
      for (const std::uint32_t i : members[kind]) sets_[kind].insert(i);
  find_further(around);
}

void HighlightSets::find_further(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  if (!mesh.has_copies()) return;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (is_further(around, Vertex(i))) further_copies_.insert(i);
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i)
    if (is_further(around, Edge(i))) further_sheets_.insert(i);
}

void HighlightSets::set(ProblemKind kind, std::uint32_t index, bool is_member) {
  IndexSet& members = sets_[static_cast<std::size_t>(kind)];
  if (is_member ? members.insert(index) : members.erase(index)) changes_.push_back({kind, index, is_member});
}

void HighlightSets::leave_out(ProblemKind kind, std::span<const Vertex> vertices) {
  for (Vertex v : vertices) sets_[static_cast<std::size_t>(kind)].erase(v.index);
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
    for (std::uint32_t k : members_from(of(row.kind), slots)) set(row.kind, k, false);
  }
  if (had_copies_) {
    for (Vertex v : reach.vertices) put(further_copies_, v.index, is_further(around, v));
    for (Edge e : reach.edges) put(further_sheets_, e.index, is_further(around, e));
    for (std::uint32_t k : members_from(further_copies_, mesh.vertex_slots())) further_copies_.erase(k);
    for (std::uint32_t k : members_from(further_sheets_, mesh.edge_slots())) further_sheets_.erase(k);
  }
  list_edges_asked(mesh, reach.vertices, reach.edges);
}

void HighlightSets::list_edges_asked(const Mesh& mesh, std::span<const Vertex> vertices, std::span<const Edge> edges) {
  edges_asked_.assign(edges.begin(), edges.end());
  for (const Change& change : changes_)
    if (row_of(change.kind).edge) edges_asked_.emplace_back(change.index);
  // Which sheets are one edge changes with the copies at either end.
  for (Vertex v : vertices) {
    if (!mesh.exists(v) || !mesh.is_alive(v) || !has_copies(mesh, v)) continue;
    for_each_copy(mesh, v, [&](Vertex copy) {
      for (Edge e : edges_around(mesh, copy)) edges_asked_.push_back(e);
    });
  }
  sort_unique(edges_asked_);
}

}  // namespace ryosen
