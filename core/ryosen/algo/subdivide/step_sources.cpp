#include "ryosen/algo/subdivide/step_sources.h"

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::subdivide {

namespace {

SourceList with_old_vertices(const Mesh& mesh, std::size_t vertices) {
  return SourceList::kept(mesh.vertex_slots(), vertices - mesh.vertex_slots());
}

void put_on_edge(const Mesh& mesh, Vertex to, Halfedge h, double t, SourceList& list) {
  const std::uint32_t ends[] = {mesh.from(h).index, mesh.to(h).index};
  const double weights[] = {1 - t, t};
  list.between(to.index, ends, weights);
}

void put_in_centre(const Mesh& mesh, Vertex to, Face f, SourceList& list) {
  std::vector<std::uint32_t> corners;
  for (const Vertex v : vertices_around(mesh, f)) corners.push_back(v.index);
  list.between(to.index, corners, std::vector<double>(corners.size(), 1.0 / static_cast<double>(corners.size())));
}

double area_of(const MeshColumns& columns, Face f) {
  std::vector<glm::dvec3> places;
  Halfedge h = columns.face_halfedge[f.index];
  do {
    places.push_back(columns.positions[columns.halfedges[h.index].from.index]);
    h = columns.halfedges[h.index].next;
  } while (h != columns.face_halfedge[f.index]);
  return polygon_area(places);
}

// One part keeps the number of its face; child(h) is that of a halfedge.
template <class Child>
SourceList parts_of_faces(const Mesh& mesh, const MeshColumns& next, bool by_area, const Child& child) {
  SourceList list(next.face_halfedge.size());
  const auto put = [&](Face part, Face whole) {
    list.part(part.index, whole.index, by_area ? area_of(next, part) : 1);
  };
  for (const Face f : live_faces(mesh)) put(f, f);
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index)
    if (!mesh.is_outside(h)) put(child(h), mesh.face(h));
  return list;
}

}  // namespace

SourceList vertex_sources(const Mesh& mesh, const SplitNumbers& n) {
  SourceList list = with_old_vertices(mesh, n.vertex_slots());
  for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
    Halfedge h = halfedge(Edge(e));
    if (point(mesh, mesh.from(h)) > point(mesh, mesh.to(h))) h = twin(h);  // the same end first on all sheets
    put_on_edge(mesh, n.on_edge(h), h, 0.5, list);
  }
  if (n.split() == Split::into_quads)
    for (const Face f : live_faces(mesh)) put_in_centre(mesh, n.centre(f), f, list);
  return list;
}

SourceList vertex_sources(const Mesh& mesh, const Sqrt3Numbers& n) {
  SourceList list = with_old_vertices(mesh, n.vertex_slots());
  for (const Face f : live_faces(mesh))
    if (n.has_centre(f)) put_in_centre(mesh, n.centre(f), f, list);
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index)
    if (n.is_cut(h)) put_on_edge(mesh, n.third(h, 0), h, 1 / 3.0, list);
  return list;
}

std::vector<Edge> parts_of_edge(const SplitNumbers&, Halfedge h) { return {edge(first_half(h)), edge(second_half(h))}; }

std::vector<Edge> parts_of_edge(const Sqrt3Numbers& n, Halfedge h) {
  if (!n.is_kept(h)) return {};
  if (!n.is_cut(h)) return {edge(n.part(h, 0))};
  return {edge(n.part(h, 0)), edge(n.part(h, 1)), edge(n.part(h, 2))};
}

SourceList face_sources(const Mesh& mesh, const SplitNumbers& n, const MeshColumns& next, bool by_area) {
  return parts_of_faces(mesh, next, by_area, [&](Halfedge h) { return n.at_corner(h); });
}

SourceList face_sources(const Mesh& mesh, const Sqrt3Numbers& n, const MeshColumns& next, bool by_area) {
  return parts_of_faces(mesh, next, by_area, [&](Halfedge h) { return n.triangle(h); });
}

}  // namespace ryosen::subdivide
