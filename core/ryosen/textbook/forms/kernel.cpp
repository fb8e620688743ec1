#include "ryosen/textbook/forms/kernel.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

Kernel::Kernel(const Mesh& mesh) {
  const Numbering numbers(mesh);
  mesh_ = without_gaps(mesh, numbers);
  if (!mesh_.has_copies()) return;
  points_.resize(numbers.vertices);
  vertices_.assign(numbers.points, no_index);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    if (numbers.vertex[i] == no_index) continue;
    points_[numbers.vertex[i]] = numbers.point[i];
    vertices_[numbers.point[i]] = std::min(vertices_[numbers.point[i]], numbers.vertex[i]);
  }
}

std::uint32_t Kernel::find_edge(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t found = no_index;
  for_each_copy(mesh_, vertex_of(a), [&](Vertex copy) {
    for (const Halfedge h : outgoing(mesh_, copy))
      if (point_of(mesh_.to(h)) == b) found = h.index;
  });
  return found;
}

// A neighbour joined by several sheets is added once for each.
void Kernel::add_neighbours(std::uint32_t point, std::vector<std::uint32_t>& out) const {
  for_each_copy(mesh_, vertex_of(point), [&](Vertex copy) {
    for (const Vertex v : neighbours(mesh_, copy)) out.push_back(point_of(v));
  });
  if (mesh_.has_copies()) sort_unique(out);
}

void Kernel::add_faces_beside(Halfedge h, std::vector<std::uint32_t>& out) const {
  const auto add = [&](Halfedge side) {
    for (const Face f : {mesh_.face(side), mesh_.face(twin(side))})
      if (f) out.push_back(f.index);
  };
  if (!mesh_.has_copies()) return add(h);
  for (const Halfedge side : sheets_between(mesh_, mesh_.from(h), mesh_.to(h))) add(side);
}

void Kernel::answer_about_vertex(Relation relation, std::uint32_t point, Answer& out) const {
  if (relation == Relation::vertex_faces) {
    for_each_face_at(mesh_, vertex_of(point), [&](Face f) { out.numbers.push_back(f.index); });
    return sort_unique(out.numbers);
  }
  add_neighbours(point, out.numbers);
  if (relation == Relation::valence) out.numbers = {static_cast<std::uint32_t>(out.numbers.size())};
  if (relation != Relation::vertex_edges) return;
  for (const std::uint32_t v : out.numbers) out.edges.push_back(edge_ends(point, v));
  out.numbers.clear();
}

void Kernel::answer_about_edge(Relation relation, Halfedge h, Answer& out) const {
  const EdgeEnds ends = ends_of(h);
  if (relation == Relation::edge_vertices) {
    out.numbers = {ends.a, ends.b};
  } else if (relation == Relation::edge_faces) {
    add_faces_beside(h, out.numbers);
    sort_unique(out.numbers);
  } else {
    std::vector<std::uint32_t> others;
    for (const std::uint32_t v : {ends.a, ends.b}) {
      others.clear();
      add_neighbours(v, others);
      for (const std::uint32_t w : others)
        if (edge_ends(v, w) != ends) out.edges.push_back(edge_ends(v, w));
    }
  }
}

void Kernel::answer_about_face(Relation relation, Face f, Answer& out) const {
  const auto add_loop = [&](Halfedge start) {
    for (const Halfedge h : loop(mesh_, start)) {
      if (relation == Relation::face_vertices) out.numbers.push_back(point_of(mesh_.from(h)));
      if (relation == Relation::face_edges) out.edges.push_back(ends_of(h));
      if (relation == Relation::face_faces) add_faces_beside(h, out.numbers);
    }
  };
  add_loop(mesh_.halfedge(f));
  for (const Halfedge start : inner_loops(mesh_, f)) add_loop(start);
  if (relation != Relation::face_faces) return;
  sort_unique(out.numbers);
  out.numbers.erase(std::remove(out.numbers.begin(), out.numbers.end(), f.index), out.numbers.end());
}

bool Kernel::answer(Relation relation, std::uint32_t element, Answer& out) const {
  return answer_by_element(
      relation, out, [&] { answer_about_vertex(relation, element, out); },
      [&] { answer_about_edge(relation, Halfedge(element), out); },
      [&] { answer_about_face(relation, Face(element), out); });
}

Fields Kernel::record(Element own) const {
  if (own.kind == Element::Kind::vertex) {
    const Vertex v = own.vertex();
    Fields fields{place("position", mesh_.position(v)), link("halfedge", "halfedge", mesh_.halfedge(v))};
    if (mesh_.next_copy(v) != v) fields.push_back(link("next_copy", "next_copy", mesh_.next_copy(v)));
    return fields;
  }
  if (own.kind == Element::Kind::edge)
    return {links("halfedges", "2e, 2e + 1", std::vector{halfedge(own.edge()), twin(halfedge(own.edge()))})};
  if (own.kind == Element::Kind::face)
    return {link("outer", "halfedge", mesh_.halfedge(own.face())),
            links("inner", "rings", inner_loops(mesh_, own.face()))};
  const Halfedge h = own.halfedge();
  return {link("from", "from", mesh_.from(h)), link("next", "next", mesh_.next(h)), link("prev", "prev", mesh_.prev(h)),
          link("face", "face", mesh_.face(h)), link("twin", "h ^ 1", twin(h)),      link("edge", "h >> 1", edge(h))};
}

}  // namespace ryosen::forms
