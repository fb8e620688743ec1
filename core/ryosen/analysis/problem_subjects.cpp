#include "ryosen/analysis/problem_subjects.h"

#include <algorithm>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/equal_faces.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

std::vector<Face> faces_at(const Mesh& m, Vertex v) {
  std::vector<Face> faces;
  for_each_copy(m, v, [&](Vertex copy) {
    for (Face f : faces_around(m, copy))
      if (f) faces.push_back(f);
  });
  sort_unique(faces);
  return faces;
}

std::vector<std::uint32_t> points_of(const Mesh& m, Face f) {
  std::vector<std::uint32_t> points;
  for (Vertex v : vertices_around(m, f)) points.push_back(point(m, v).index);
  sort_unique(points);
  return points;
}

}  // namespace

std::vector<Element> loop_of_edge(Neighbourhood& around, const IndexSet& boundary, Element element) {
  const BoundaryLoops loops = find_boundary_loops(around, boundary);
  const auto at = std::find_if(loops.halfedges.begin(), loops.halfedges.end(),
                               [&](Halfedge h) { return edge(h) == element.edge(); });
  if (at == loops.halfedges.end()) return {element};
  const auto place = static_cast<std::size_t>(at - loops.halfedges.begin());
  const auto behind = std::upper_bound(loops.offsets.begin(), loops.offsets.end(), place);
  const std::span<const Halfedge> loop = loops[static_cast<std::size_t>(behind - loops.offsets.begin()) - 1];
  std::vector<Element> found;
  for (Halfedge h : loop) found.emplace_back(edge(h));
  std::rotate(found.begin(), std::find(found.begin(), found.end(), element), found.end());
  return found;
}

std::vector<Element> edge_with_faces(Neighbourhood& around, const IndexSet&, Element element) {
  const Mesh& m = around.mesh();
  const auto [a, b] = ends(m, element.edge());
  std::vector<Face> faces;
  for (Halfedge h : sheets_between(m, a, b))
    for (Halfedge side : {h, twin(h)})
      if (const Face f = m.face(side)) faces.push_back(f);
  sort_unique(faces);
  std::vector<Element> found{element};
  found.insert(found.end(), faces.begin(), faces.end());
  return found;
}

std::vector<Element> vertex_with_fans(Neighbourhood& around, const IndexSet&, Element element) {
  const std::vector<Face> faces = faces_at(around.mesh(), element.vertex());
  std::vector<Element> found{element};
  found.insert(found.end(), faces.begin(), faces.end());
  return found;
}

std::vector<Element> equal_faces_of(Neighbourhood& around, const IndexSet&, Element element) {
  const Mesh& m = around.mesh();
  const std::vector<std::uint32_t> points = points_of(m, element.face());
  std::vector<Element> found{element};
  for (Face f : faces_at(m, Vertex(points[0])))
    if (f != element.face() && points_of(m, f) == points) found.emplace_back(f);
  return found;
}

std::vector<Element> points_at_place(Neighbourhood& around, const IndexSet& members, Element element) {
  const Mesh& m = around.mesh();
  std::vector<Element> found{element};
  members.for_each([&](std::uint32_t i) {
    if (i != element.index && m.position(Vertex(i)) == m.position(element.vertex())) found.emplace_back(Vertex(i));
  });
  return found;
}

std::vector<Element> pair_of_face(Neighbourhood& around, const IndexSet&, Element element) {
  const Face partner = hanging_partner(around, element.face());
  return partner ? std::vector<Element>{element, partner} : std::vector<Element>{element};
}

}  // namespace ryosen
