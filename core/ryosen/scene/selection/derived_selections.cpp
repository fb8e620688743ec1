#include "ryosen/scene/selection/derived_selections.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "ryosen/base/index_set.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/scene/highlights/feature_edges.h"

namespace ryosen {

namespace {

// The elements of a kind that touch a point; of vertices, those that an edge joins to it. Some more than once.
template <class Visit>
void for_each_at(const Mesh& mesh, Element::Kind kind, Vertex of_point, Visit visit) {
  for_each_copy(mesh, of_point, [&](Vertex copy) {
    for (Halfedge h : outgoing(mesh, copy)) switch (kind) {
        case Element::Kind::vertex:
          visit(point(mesh, mesh.to(h)));
          break;
        case Element::Kind::halfedge:
          visit(h);
          visit(twin(h));
          break;
        case Element::Kind::edge:
          visit(edge(h));
          break;
        case Element::Kind::face:
          if (mesh.face(h)) visit(mesh.face(h));
      }
  });
}

// Asks each point once for the elements of a kind, so that a point which many elements share costs no more than them.
class Growth {
 public:
  Growth(const Mesh& mesh, std::span<const Element> selection)
      : mesh_(mesh), selected_(selection), found_(selection.begin(), selection.end()) {}

  // With the neighbours of the elements from `first` on.
  void grow_from(std::size_t first) {
    const std::size_t last = found_.size();
    for (std::size_t i = first; i < last; ++i) {
      const Element e = found_[i];
      for_each_vertex(mesh_, e, [&](Vertex v) {
        const Vertex p = point(mesh_, v);
        if (!asked_[static_cast<std::size_t>(e.kind)].insert(p.index)) return;
        for_each_at(mesh_, e.kind, p, [&](Element other) {
          if (selected_.insert(other)) found_.push_back(other);
        });
      });
    }
    std::sort(found_.begin() + static_cast<std::ptrdiff_t>(last), found_.end());
  }
  std::size_t size() const { return found_.size(); }
  Elements take() { return std::move(found_); }

 private:
  const Mesh& mesh_;
  ElementSet selected_;
  Elements found_;
  std::array<IndexSet, 4> asked_;  // points, by kind
};

// Follows edges from the selected ones both ways, each edge once.
template <class Next>
Elements followed(const Mesh& mesh, std::span<const Element> selection, Next next) {
  Elements found(selection.begin(), selection.end());
  ElementSet selected(selection);
  const std::size_t before = found.size();
  for (std::size_t i = 0; i < before; ++i) {
    const Element e = found[i];
    if (e.kind != Element::Kind::edge && e.kind != Element::Kind::halfedge) continue;
    const Edge first = e.kind == Element::Kind::edge ? e.edge() : edge(e.halfedge());
    if (selected.insert(first)) found.emplace_back(first);
    for (int side = 0; side < 2; ++side)
      for (Halfedge h = next(mesh, halfedge(first, side)); h && selected.insert(edge(h)); h = next(mesh, h))
        found.emplace_back(edge(h));
  }
  return found;
}

// The halfedge that runs straight on, or along the boundary; none where there is none.
Halfedge straight_on(const Mesh& mesh, Halfedge h) {
  if (!mesh.face(h)) return mesh.next(h);
  if (!mesh.face(twin(h))) return twin(mesh.prev(twin(h)));
  if (has_copies(mesh, mesh.to(h))) return {};
  const Halfedge start = twin(h);
  Halfedge out = start;
  for (int i = 0; i < 4; ++i) {
    if (!mesh.face(out)) return {};
    out = mesh.counter_clockwise(out);
    if ((out == start) != (i == 3)) return {};
  }
  return mesh.counter_clockwise(mesh.counter_clockwise(start));
}

// The halfedge across the quad to its left, as seen from the next one; none where that is no quad.
Halfedge across(const Mesh& mesh, Halfedge h) {
  const Face f = mesh.face(h);
  if (!f || mesh.first_ring(f) != no_index) return {};
  const Halfedge opposite = mesh.next(mesh.next(h));
  if (opposite == h || mesh.next(mesh.next(opposite)) != h) return {};
  return twin(opposite);
}

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

template <class Handle>
Elements converted_to(const Mesh& mesh, const SelectedParts& selected) {
  Elements found, meeting;
  for (Handle element(0); mesh.exists(element); ++element.index) {
    if (!mesh.is_alive(element)) continue;
    if constexpr (std::is_same_v<Handle, Vertex>)
      if (point(mesh, element) != element) continue;
    if (selected.belongs(element) || selected.lies_in(element))
      found.emplace_back(element);
    else if (found.empty() && selected.meets(element))
      meeting.emplace_back(element);
  }
  return found.empty() ? meeting : found;
}

}  // namespace

Elements grown(const Mesh& mesh, std::span<const Element> selection) {
  Growth growth(mesh, selection);
  growth.grow_from(0);
  return growth.take();
}

Elements linked(const Mesh& mesh, std::span<const Element> selection) {
  Growth growth(mesh, selection);
  for (std::size_t first = 0; first < growth.size();) {
    const std::size_t before = growth.size();
    growth.grow_from(first);
    first = before;
  }
  Elements found = growth.take();
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(selection.size()), found.end());
  return found;
}

Elements shrunk(const Mesh& mesh, std::span<const Element> selection) {
  const ElementSet selected(selection);
  std::array<IndexSet, 4> asked, open;  // points, by kind; open: one that touches an element which is not selected
  const auto is_open = [&](Element::Kind kind, Vertex p) {
    const std::size_t k = static_cast<std::size_t>(kind);
    if (!asked[k].insert(p.index)) return open[k].contains(p.index);
    for_each_at(mesh, kind, p, [&](Element other) {
      bool is_in = selected.contains(other);
      if (!is_in && kind == Element::Kind::vertex)  // a copy may be selected in place of its point
        is_in = any_of_copies(mesh, other.vertex(), [&](Vertex copy) { return selected.contains(copy); });
      if (!is_in) open[k].insert(p.index);
    });
    return open[k].contains(p.index);
  };
  Elements left;
  for (const Element& e : selection) {
    bool is_inside = true;
    for_each_vertex(mesh, e, [&](Vertex v) { is_inside = is_inside && !is_open(e.kind, point(mesh, v)); });
    if (is_inside) left.push_back(e);
  }
  return left;
}

Elements edge_loops(const Mesh& mesh, std::span<const Element> selection) {
  return followed(mesh, selection, straight_on);
}

Elements edge_rings(const Mesh& mesh, std::span<const Element> selection) { return followed(mesh, selection, across); }

Elements flat_regions(const Mesh& mesh, std::span<const Element> selection, double angle_deg) {
  const double cosine = std::cos(angle_deg * std::numbers::pi / 180);
  Neighbourhood around(mesh);
  ElementSet selected(selection);
  Elements found(selection.begin(), selection.end());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].kind != Element::Kind::face) continue;
    for (Halfedge h : halfedges_around(mesh, found[i].face())) {
      const Halfedge other = around.across(h);
      if (!other || cosine_of_bend(around, h, other) < cosine) continue;
      if (selected.insert(mesh.face(other))) found.emplace_back(mesh.face(other));
    }
  }
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(selection.size()), found.end());
  return found;
}

Elements converted(const Mesh& mesh, std::span<const Element> selection, Element::Kind to) {
  const SelectedParts selected(mesh, selection);
  return Element(to).visit([&](auto none) { return converted_to<decltype(none)>(mesh, selected); });
}

}  // namespace ryosen
