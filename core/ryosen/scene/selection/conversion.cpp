#include "ryosen/scene/selection/conversion.h"

#include <algorithm>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

using Slots = std::vector<bool>;

// The selection as sets by slot; of vertices it is the points that count.
class SelectedParts {
 public:
  SelectedParts(const Mesh& mesh, std::span<const Element> selection)
      : mesh_(mesh),
        vertices_(mesh.vertex_slots()),
        points_(mesh.vertex_slots()),
        corners_(mesh.vertex_slots()),
        edges_(mesh.edge_slots()),
        halfedges_(mesh.halfedge_slots()),
        faces_(mesh.face_slots()) {
    for (const Element& e : selection) take(e);
  }

  // A corner or an end of something selected, or selected itself.
  bool belongs(Vertex v) const { return corners_[at(v)]; }
  bool belongs(Edge e) const {
    const auto [f, g] = faces(mesh_, e);
    return edges_[e.index] || is_in(f) || is_in(g);
  }
  bool belongs(Halfedge h) const {
    return halfedges_[h.index] || is_in(mesh_.face(h)) || (edges_of_themselves(edge(h)) && mesh_.face(h));
  }
  bool belongs(Face f) const { return faces_[f.index]; }

  // By its ends or corners, which are vertices, or of edges for a face.
  bool lies_in(Vertex) const { return false; }
  bool lies_in(Edge e) const {
    const auto [a, b] = ends(mesh_, e);
    return vertices_[at(a)] && vertices_[at(b)];
  }
  bool lies_in(Halfedge h) const { return mesh_.face(h) && lies_in(edge(h)); }
  bool lies_in(Face f) const {
    const auto corners = vertices_around(mesh_, f);
    return std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return points_[at(v)]; });
  }

  bool meets(Vertex) const { return false; }
  bool meets(Edge e) const {
    const auto [a, b] = ends(mesh_, e);
    return vertices_[at(a)] || vertices_[at(b)];
  }
  bool meets(Halfedge h) const { return mesh_.face(h) && vertices_[at(mesh_.from(h))]; }
  bool meets(Face f) const {
    const auto corners = vertices_around(mesh_, f);
    return std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return points_[at(v)]; });
  }

 private:
  std::uint32_t at(Vertex v) const { return point(mesh_, v).index; }
  bool is_in(Face f) const { return f && faces_[f.index]; }
  bool edges_of_themselves(Edge e) const {
    return edges_[e.index] && !halfedges_[halfedge(e, 0).index] && !halfedges_[halfedge(e, 1).index];
  }
  void take(const Element& e) {
    const auto take_ends = [&](Edge side) {
      const auto [a, b] = ends(mesh_, side);
      for (const Vertex v : {a, b}) corners_[at(v)] = points_[at(v)] = true;
    };
    switch (e.kind) {
      case Element::Kind::vertex:
        vertices_[at(e.vertex())] = points_[at(e.vertex())] = corners_[at(e.vertex())] = true;
        break;
      case Element::Kind::edge:
        edges_[e.index] = true;
        take_ends(e.edge());
        break;
      case Element::Kind::halfedge:
        halfedges_[e.index] = edges_[edge(e.halfedge()).index] = true;
        take_ends(edge(e.halfedge()));
        break;
      case Element::Kind::face:
        faces_[e.index] = true;
        for (const Vertex v : vertices_around(mesh_, e.face())) corners_[at(v)] = true;
    }
  }

  const Mesh& mesh_;
  Slots vertices_, points_, corners_;  // selected; those too, or ends of edges; those too, or corners of faces
  Slots edges_, halfedges_, faces_;
};

template <class Handle, class IsAlive>
Elements converted_to(const SelectedParts& selected, std::uint32_t slots, IsAlive is_alive) {
  Elements found, meeting;
  for (Handle element(0); element.index < slots; ++element.index) {
    if (!is_alive(element)) continue;
    if (selected.belongs(element) || selected.lies_in(element))
      found.emplace_back(element);
    else if (found.empty() && selected.meets(element))
      meeting.emplace_back(element);
  }
  return found.empty() ? meeting : found;
}

}  // namespace

Elements converted(const Mesh& mesh, std::span<const Element> selection, Element::Kind to) {
  const SelectedParts selected(mesh, selection);
  const auto lives = [&](auto element) { return mesh.is_alive(element); };
  switch (to) {
    case Element::Kind::vertex:
      return converted_to<Vertex>(selected, mesh.vertex_slots(),
                                  [&](Vertex v) { return mesh.is_alive(v) && point(mesh, v) == v; });
    case Element::Kind::edge:
      return converted_to<Edge>(selected, mesh.edge_slots(), lives);
    case Element::Kind::halfedge:
      return converted_to<Halfedge>(selected, mesh.halfedge_slots(),
                                    [&](Halfedge h) { return mesh.is_alive(edge(h)); });
    case Element::Kind::face:
      return converted_to<Face>(selected, mesh.face_slots(), lives);
  }
  return {};
}

}  // namespace ryosen
