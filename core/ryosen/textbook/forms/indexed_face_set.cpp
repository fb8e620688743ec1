#include "ryosen/textbook/forms/indexed_face_set.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

IndexedFaceSet::IndexedFaceSet(const Mesh& mesh) : list_(polygons_of(mesh, Numbering(mesh))) {}

std::size_t IndexedFaceSet::bytes() const {
  return bytes_of(list_.positions) + bytes_of(list_.corners) + bytes_of(list_.offsets);
}

Mesh IndexedFaceSet::to_mesh() const {
  IndexedMesh list;
  list.positions = list_.positions;
  list.corners = list_.corners;
  list.face_offsets = list_.offsets;
  return from_indexed(std::move(list));
}

template <class Visit>
void IndexedFaceSet::for_each_side(Visit visit) const {
  for (std::uint32_t f = 0; f < list_.face_count(); ++f) {
    const std::uint32_t begin = list_.offsets[f], end = list_.offsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c)
      visit(f, c, edge_ends(list_.corners[c], list_.corners[c + 1 < end ? c + 1 : begin]));
  }
}

EdgeEnds IndexedFaceSet::ends_of_corner(std::uint32_t corner) const {
  const auto after = std::upper_bound(list_.offsets.begin(), list_.offsets.end(), corner);
  const std::uint32_t next = corner + 1 < *after ? corner + 1 : after[-1];
  return edge_ends(list_.corners[corner], list_.corners[next]);
}

std::uint32_t IndexedFaceSet::find_edge(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t found = no_index;
  for_each_side([&](std::uint32_t, std::uint32_t corner, EdgeEnds ends) {
    if (ends == edge_ends(a, b)) found = std::min(found, corner);
  });
  return found;
}

void IndexedFaceSet::answer_about_vertex(Relation relation, std::uint32_t v, Answer& out) const {
  const auto all_sides = [&](auto visit) {
    for_each_side([&](std::uint32_t f, std::uint32_t, EdgeEnds ends) { visit(f, ends); });
  };
  answer_by_all_sides(relation, v, all_sides, out);
}

void IndexedFaceSet::answer_about_edge(Relation relation, std::uint32_t corner, Answer& out) const {
  const EdgeEnds edge = ends_of_corner(corner);
  if (relation == Relation::edge_vertices) {
    out.numbers = {edge.a, edge.b};
    return;
  }
  for_each_side([&](std::uint32_t f, std::uint32_t, EdgeEnds ends) {
    if (relation == Relation::edge_faces) {
      if (ends == edge) out.numbers.push_back(f);
    } else if (ends != edge && (ends.a == edge.a || ends.a == edge.b || ends.b == edge.a || ends.b == edge.b)) {
      out.edges.push_back(ends);
    }
  });
  sort_unique(out.numbers);
  sort_unique(out.edges);
}

void IndexedFaceSet::answer_about_face(Relation relation, std::uint32_t f, Answer& out) const {
  const std::uint32_t begin = list_.offsets[f], end = list_.offsets[f + 1];
  if (relation == Relation::face_vertices) {
    out.numbers.assign(list_.corners.begin() + begin, list_.corners.begin() + end);
    return;
  }
  for (std::uint32_t c = begin; c < end; ++c) out.edges.push_back(ends_of_corner(c));
  if (relation == Relation::face_edges) return;
  std::vector<EdgeEnds> sides;
  sides.swap(out.edges);
  for_each_side([&](std::uint32_t other, std::uint32_t, EdgeEnds ends) {
    if (other != f && std::find(sides.begin(), sides.end(), ends) != sides.end()) out.numbers.push_back(other);
  });
  sort_unique(out.numbers);
}

bool IndexedFaceSet::answer(Relation relation, std::uint32_t element, Answer& out) const {
  return answer_by_element(
      relation, out, [&] { answer_about_vertex(relation, element, out); },
      [&] { answer_about_edge(relation, element, out); }, [&] { answer_about_face(relation, element, out); });
}

Fields IndexedFaceSet::record(Element own) const {
  if (own.kind == Element::Kind::vertex) return {place("x, y, z", list_.positions[own.index])};
  if (own.kind == Element::Kind::face) return {links("vertices", "Vertices", vertices_of(list_, own.face()))};
  return {};
}

}  // namespace ryosen::forms
