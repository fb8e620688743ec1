#include "ryosen/mesh/touched.h"

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

template <class Handle>
void add_range(std::vector<Handle>& handles, std::uint32_t begin, std::uint32_t end) {
  for (std::uint32_t i = begin; i < end; ++i) handles.push_back(Handle(i));
}

}  // namespace

TouchedElements touched_elements(const Mesh& mesh, const Journal& journal, std::size_t i) {
  TouchedElements touched;
  if (journal.replaces_everything(i)) {
    touched.everything = true;
    return touched;
  }
  for (const TouchedCell& cell : journal.touched(i)) {
    switch (cell.column) {
      case Column::position:
        touched.moved.push_back(Vertex(cell.index));
        [[fallthrough]];
      case Column::vertex_halfedge:
      case Column::next_copy:
      case Column::copy_point:
        touched.vertices.push_back(Vertex(cell.index));
        break;
      case Column::from:
      case Column::next:
      case Column::prev:
      case Column::face:
        touched.halfedges.push_back(Halfedge(cell.index));
        break;
      case Column::first_ring:
      case Column::face_halfedge:
        touched.faces.push_back(Face(cell.index));
        break;
      default:
        break;
    }
  }
  const ColumnLengths before = journal.lengths_before(i), after = journal.lengths_after(mesh, i);
  add_range(touched.vertices, before.vertices, after.vertices);
  add_range(touched.moved, before.vertices, after.vertices);
  add_range(touched.halfedges, before.halfedges, after.halfedges);
  add_range(touched.faces, before.faces, after.faces);
  sort_unique(touched.halfedges);
  for (Halfedge h : touched.halfedges) {
    if (!mesh.exists(h) || !mesh.is_alive(h)) continue;
    touched.vertices.push_back(mesh.from(h));
    if (!mesh.is_outside(h)) touched.faces.push_back(mesh.face(h));
  }
  sort_unique(touched.moved);
  for (Vertex v : touched.moved) {
    if (!mesh.exists(v) || !mesh.is_alive(v)) continue;
    for (Halfedge h : outgoing(mesh, v))
      if (!mesh.is_outside(h)) touched.faces.push_back(mesh.face(h));
  }
  sort_unique(touched.vertices);
  sort_unique(touched.faces);
  return touched;
}

}  // namespace ryosen
