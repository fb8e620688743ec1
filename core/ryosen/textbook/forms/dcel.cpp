#include "ryosen/textbook/forms/dcel.h"

#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/halfedge_table.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

Dcel::Dcel(const Mesh& mesh) {
  const Numbering numbers(mesh);
  const auto number = [&](Halfedge h) { return numbers.halfedge(h).index; };
  for (const Vertex v : live_vertices(mesh)) records_.vertices.push_back({mesh.position(v), number(mesh.halfedge(v))});
  for (const Halfedge h : live_halfedges(mesh))
    records_.half_edges.push_back({numbers.vertex[mesh.from(h).index], number(twin(h)), number(mesh.next(h)),
                                   number(mesh.prev(h)), mesh.face(h) ? numbers.face[mesh.face(h).index] : no_index});
  for (const Face f : live_faces(mesh)) {
    records_.faces.push_back({number(mesh.halfedge(f)), {}});
    for (const Halfedge start : inner_loops(mesh, f)) records_.faces.back().inner_components.push_back(number(start));
  }
}

std::size_t Dcel::bytes() const {
  std::size_t bytes = bytes_of(records_.vertices) + bytes_of(records_.half_edges) + bytes_of(records_.faces);
  for (const DcelRecords::FaceRecord& face : records_.faces) bytes += bytes_of(face.inner_components);
  return bytes;
}

Mesh Dcel::to_mesh() const {
  HalfedgeTable table;
  std::vector<std::vector<std::uint32_t>> inner;
  for (const DcelRecords::VertexRecord& v : records_.vertices) {
    table.positions.push_back(v.coordinates);
    table.vertex_halfedge.push_back(v.incident_edge);
  }
  for (const DcelRecords::HalfEdgeRecord& h : records_.half_edges)
    table.halfedges.push_back({h.origin, h.face, h.twin, h.next, h.prev});
  for (const DcelRecords::FaceRecord& f : records_.faces) {
    table.face_halfedge.push_back(f.outer_component);
    inner.push_back(f.inner_components);
  }
  return mesh_from_all_halfedges(table, inner);
}

Fields Dcel::record(Element own) const {
  if (own.kind == Element::Kind::vertex) {
    const DcelRecords::VertexRecord& v = records_.vertices[own.index];
    return {place("x, y, z", v.coordinates), link("halfedge", "incident_edge", Halfedge(v.incident_edge))};
  }
  if (own.kind == Element::Kind::halfedge) {
    const DcelRecords::HalfEdgeRecord& h = records_.half_edges[own.index];
    return {link("from", "origin", Vertex(h.origin)), link("twin", "twin", Halfedge(h.twin)),
            link("next", "next", Halfedge(h.next)), link("prev", "prev", Halfedge(h.prev)),
            link("face", "face", Face(h.face))};
  }
  if (own.kind != Element::Kind::face) return {};
  const DcelRecords::FaceRecord& f = records_.faces[own.index];
  return {
      link("outer", "outer_component", Halfedge(f.outer_component)),
      links("inner", "inner_components", std::vector<Halfedge>(f.inner_components.begin(), f.inner_components.end()))};
}

}  // namespace ryosen::forms
