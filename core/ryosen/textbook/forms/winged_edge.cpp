#include "ryosen/textbook/forms/winged_edge.h"

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

WingedEdge::WingedEdge(const Mesh& mesh) {
  const Numbering numbers(mesh);
  vertex_edge_.assign(numbers.points, no_index);
  for (const Edge e : live_edges(mesh)) {
    const Halfedge h = halfedge(e), t = twin(h);
    const bool has_left = !mesh.is_outside(h), has_right = !mesh.is_outside(t);
    const auto number = [&](Halfedge wing, bool exists) { return exists ? numbers.edge[edge(wing).index] : no_index; };
    const auto added = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back({numbers.vertex[mesh.from(h).index], numbers.vertex[mesh.to(h).index],
                      has_left ? numbers.face[mesh.face(h).index] : no_index,
                      has_right ? numbers.face[mesh.face(t).index] : no_index, number(mesh.next(h), has_left),
                      number(mesh.prev(h), has_left), number(mesh.next(t), has_right),
                      number(mesh.prev(t), has_right)});
    vertex_edge_[edges_.back().start] = vertex_edge_[edges_.back().end] = added;
  }
  for (const Vertex v : live_vertices(mesh)) positions_.push_back(mesh.position(v));
  for (const Face f : live_faces(mesh)) face_edge_.push_back(numbers.edge[edge(mesh.halfedge(f)).index]);
}

std::size_t WingedEdge::bytes() const {
  return bytes_of(positions_) + bytes_of(vertex_edge_) + bytes_of(edges_) + bytes_of(face_edge_);
}

Mesh WingedEdge::to_mesh() const {
  Polygons polygons;
  polygons.positions = positions_;
  std::vector<std::uint32_t> corner_of(2 * edges_.size(), no_index);  // per edge: of its left and right side
  std::vector<std::uint32_t> side_of;
  for (std::uint32_t f = 0; f < face_edge_.size(); ++f) {
    for_each_edge_of(f, [&](std::uint32_t e, bool is_left) {
      const std::uint32_t side = 2 * e + (is_left ? 0 : 1);
      corner_of[side] = static_cast<std::uint32_t>(polygons.corners.size());
      side_of.push_back(side);
      polygons.corners.push_back(is_left ? edges_[e].start : edges_[e].end);
    });
    polygons.offsets.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  std::vector<std::uint32_t> across;
  for (const std::uint32_t side : side_of) across.push_back(corner_of[side ^ 1u]);
  return mesh_from_sides(polygons, across);
}

// Counter-clockwise up to a gap, then clockwise from the first edge.
template <class Visit>
void WingedEdge::for_each_edge_at(std::uint32_t v, Visit visit) const {
  const std::uint32_t first = vertex_edge_[v];
  if (first == no_index) return;
  std::uint32_t e = first;
  do {
    visit(e);
    e = edges_[e].start == v ? edges_[e].left_prev : edges_[e].right_prev;
  } while (e != first && e != no_index);
  if (e == first) return;
  const auto clockwise = [&](std::uint32_t at) {
    return edges_[at].start == v ? edges_[at].right_next : edges_[at].left_next;
  };
  for (e = clockwise(first); e != no_index; e = clockwise(e)) visit(e);
}

template <class Visit>
void WingedEdge::for_each_edge_of(std::uint32_t f, Visit visit) const {
  std::uint32_t e = face_edge_[f];
  do {
    const bool is_left = edges_[e].left == f;
    visit(e, is_left);
    e = is_left ? edges_[e].left_next : edges_[e].right_next;
  } while (e != face_edge_[f]);
}

std::uint32_t WingedEdge::find_edge(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t found = no_index;
  for_each_edge_at(a, [&](std::uint32_t e) {
    if (other_end(e, a) == b) found = e;
  });
  return found;
}

void WingedEdge::answer_about_vertex(Relation relation, std::uint32_t v, Answer& out) const {
  std::uint32_t valence = 0;
  for_each_edge_at(v, [&](std::uint32_t e) {
    ++valence;
    const std::uint32_t face = edges_[e].start == v ? edges_[e].left : edges_[e].right;
    if (relation == Relation::vertex_vertices) out.numbers.push_back(other_end(e, v));
    if (relation == Relation::vertex_edges) out.edges.push_back(ends_of(e));
    if (relation == Relation::vertex_faces && face != no_index) out.numbers.push_back(face);
  });
  if (relation == Relation::valence) out.numbers.push_back(valence);
}

void WingedEdge::answer_about_edge(Relation relation, std::uint32_t e, Answer& out) const {
  const EdgeRecord& edge = edges_[e];
  if (relation == Relation::edge_vertices) {
    out.numbers = {edge.start, edge.end};
  } else if (relation == Relation::edge_faces) {
    for (const std::uint32_t face : {edge.left, edge.right})
      if (face != no_index) out.numbers.push_back(face);
  } else {
    for (const std::uint32_t v : {edge.start, edge.end})
      for_each_edge_at(v, [&](std::uint32_t other) {
        if (other != e) out.edges.push_back(ends_of(other));
      });
  }
}

void WingedEdge::answer_about_face(Relation relation, std::uint32_t f, Answer& out) const {
  for_each_edge_of(f, [&](std::uint32_t e, bool is_left) {
    const std::uint32_t across = is_left ? edges_[e].right : edges_[e].left;
    if (relation == Relation::face_vertices) out.numbers.push_back(is_left ? edges_[e].start : edges_[e].end);
    if (relation == Relation::face_edges) out.edges.push_back(ends_of(e));
    if (relation == Relation::face_faces && across != no_index) out.numbers.push_back(across);
  });
  if (relation == Relation::face_faces) sort_unique(out.numbers);
}

bool WingedEdge::answer(Relation relation, std::uint32_t element, Answer& out) const {
  return answer_by_element(
      relation, out, [&] { answer_about_vertex(relation, element, out); },
      [&] { answer_about_edge(relation, element, out); }, [&] { answer_about_face(relation, element, out); });
}

Fields WingedEdge::record(Element own) const {
  if (own.kind == Element::Kind::vertex)
    return {place("x, y, z", positions_[own.index]), link("edge", "edge", Edge(vertex_edge_[own.index]))};
  if (own.kind == Element::Kind::face) return {link("edge", "edge", Edge(face_edge_[own.index]))};
  if (own.kind != Element::Kind::edge) return {};
  const EdgeRecord& e = edges_[own.index];
  return {link("from", "start", Vertex(e.start)),
          link("to", "end", Vertex(e.end)),
          link("left", "left", Face(e.left)),
          link("right", "right", Face(e.right)),
          link("left_next", "leftNext", Edge(e.left_next)),
          link("left_prev", "leftPrev", Edge(e.left_prev)),
          link("right_next", "rightNext", Edge(e.right_next)),
          link("right_prev", "rightPrev", Edge(e.right_prev))};
}

}  // namespace ryosen::forms
