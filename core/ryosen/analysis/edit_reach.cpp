#include "ryosen/analysis/edit_reach.h"

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

bool is_live(const Mesh& mesh, Halfedge h) { return mesh.exists(h) && mesh.is_alive(h); }

void add_valued_cell(const Mesh& mesh, TouchedCell cell, EditReach& reach) {
  const std::size_t attribute = attribute_of_column(cell.column);
  if (attribute >= mesh.attributes().size()) return;  // before it was added
  switch (mesh.attributes()[attribute].element) {
    case ElementKind::vertex:
      reach.vertices.emplace_back(cell.index);
      break;
    case ElementKind::edge:
      reach.edges.emplace_back(cell.index);
      break;
    case ElementKind::corner:
      reach.edges.push_back(edge(Halfedge(cell.index)));
      break;
    case ElementKind::face:
      reach.faces.emplace_back(cell.index);
      if (mesh.exists(Face(cell.index)) && mesh.is_alive(Face(cell.index)))
        for (Vertex v : vertices_around(mesh, Face(cell.index))) reach.vertices.push_back(v);
      break;
    case ElementKind::pool:  // grows at its end alone
      break;
  }
}

void add_written_cell(const Mesh& mesh, TouchedCell cell, WrittenValues values, EditReach& reach) {
  switch (cell.column) {
    case Column::vertex_halfedge:
    case Column::position:
    case Column::next_copy:
    case Column::copy_point:
      reach.vertices.emplace_back(cell.index);
      break;
    case Column::from:
    case Column::next:
    case Column::prev:
    case Column::face:
      reach.edges.push_back(edge(Halfedge(cell.index)));
      break;
    case Column::face_halfedge:
    case Column::first_ring:
      reach.faces.emplace_back(cell.index);
      break;
    case Column::attribute_removed:
      break;
    case Column::ring:
      if (cell.index < mesh.lengths().rings && is_live(mesh, mesh.ring(cell.index).halfedge))
        reach.faces.push_back(mesh.face(mesh.ring(cell.index).halfedge));
      break;
    default:
      if (values == WrittenValues::counted) add_valued_cell(mesh, cell, reach);
      break;
  }
}

}  // namespace

// A predicate looks at the faces around the points of its element. Whatever changed there, some link, origin or
// position at one of these points was written, or one of a neighbour's copies; so it is enough to ask all elements at
// the points of what was written, and their neighbours.
EditReach edit_reach(const Journal& journal, std::size_t i, Neighbourhood& around, WrittenValues values) {
  const Mesh& mesh = around.mesh();
  const ColumnLengths before = journal.lengths_before(i);
  EditReach reach;
  for (TouchedCell cell : journal.touched(i)) add_written_cell(mesh, cell, values, reach);
  for (std::uint32_t k = before.vertices; k < mesh.vertex_slots(); ++k) reach.vertices.emplace_back(k);
  for (std::uint32_t k = before.halfedges / 2; k < mesh.edge_slots(); ++k) reach.edges.emplace_back(k);
  for (std::uint32_t k = before.faces; k < mesh.face_slots(); ++k) reach.faces.emplace_back(k);
  sort_unique(reach.edges);

  for (Edge e : reach.edges)
    if (is_live(mesh, halfedge(e)))
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

void add_whole_faces(Neighbourhood& around, EditReach& reach) {
  const Mesh& mesh = around.mesh();
  for (Face f : reach.faces) {
    if (!mesh.exists(f) || !mesh.is_alive(f)) continue;
    for (Halfedge h : halfedges_around(mesh, f)) {
      reach.vertices.push_back(around.point(mesh.from(h)));
      if (around.is_single_sheet(h)) {
        reach.edges.push_back(edge(h));
        continue;
      }
      for (Halfedge sheet : sheets_between(mesh, mesh.from(h), mesh.to(h))) reach.edges.push_back(edge(sheet));
    }
  }
  sort_unique(reach.vertices);
  sort_unique(reach.edges);
}

void add_neighbours(Neighbourhood& around, EditReach& reach) {
  const Mesh& mesh = around.mesh();
  const std::vector<Vertex> within = reach.vertices;
  for (Vertex v : within) {
    if (!mesh.exists(v) || !mesh.is_alive(v)) continue;
    for_each_copy(mesh, v, [&](Vertex copy) {
      reach.vertices.push_back(copy);
      if (mesh.is_isolated(copy)) return;
      for (Vertex w : neighbours(mesh, copy)) reach.vertices.push_back(w);
    });
  }
  sort_unique(reach.vertices);
}

}  // namespace ryosen
