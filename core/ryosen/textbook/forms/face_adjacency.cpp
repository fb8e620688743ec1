#include "ryosen/textbook/forms/face_adjacency.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/faces_at.h"

namespace ryosen::forms {

FaceAdjacency::FaceAdjacency(const Mesh& mesh) {
  const Numbering numbers(mesh);
  list_ = polygons_of(mesh, numbers);
  vertex_face_.assign(list_.positions.size(), no_index);
  for (const std::uint32_t corner : corners_across(mesh))
    face_across_.push_back(corner == no_index ? no_index : face_of(corner));
  for (std::uint32_t f = 0; f < list_.face_count(); ++f)
    for (std::uint32_t c = list_.offsets[f]; c < list_.offsets[f + 1]; ++c) vertex_face_[list_.corners[c]] = f;
}

std::size_t FaceAdjacency::bytes() const {
  return bytes_of(list_.positions) + bytes_of(vertex_face_) + bytes_of(list_.corners) + bytes_of(list_.offsets) +
         bytes_of(face_across_);
}

// The corner across a side is that of the adjacent face which traverses the side in the opposite direction.
Mesh FaceAdjacency::to_mesh() const {
  std::vector<std::uint32_t> across(list_.corners.size(), no_index);
  for (std::uint32_t f = 0; f < list_.face_count(); ++f)
    for (std::uint32_t c = list_.offsets[f]; c < list_.offsets[f + 1]; ++c)
      if (face_across_[c] != no_index) across[c] = place_of(face_across_[c], list_.corners[next_corner({f, c})]).corner;
  return mesh_from_sides(list_, across);
}

std::uint32_t FaceAdjacency::next_corner(Place at) const {
  return at.corner + 1 < list_.offsets[at.face + 1] ? at.corner + 1 : list_.offsets[at.face];
}

std::uint32_t FaceAdjacency::previous_corner(Place at) const {
  return at.corner > list_.offsets[at.face] ? at.corner - 1 : list_.offsets[at.face + 1] - 1;
}

FaceAdjacency::Place FaceAdjacency::place_of(std::uint32_t face, std::uint32_t v) const {
  std::uint32_t corner = list_.offsets[face];
  while (list_.corners[corner] != v) ++corner;
  return {face, corner};
}

std::uint32_t FaceAdjacency::face_of(std::uint32_t corner) const {
  const auto after = std::upper_bound(list_.offsets.begin(), list_.offsets.end(), corner);
  return static_cast<std::uint32_t>(after - list_.offsets.begin()) - 1;
}

EdgeEnds FaceAdjacency::ends_of(Place side) const {
  return edge_ends(list_.corners[side.corner], list_.corners[next_corner(side)]);
}

template <class Visit>
void FaceAdjacency::for_each_face_at(std::uint32_t v, Visit visit) const {
  const std::uint32_t first = vertex_face_[v];
  if (first == no_index) return;
  std::uint32_t face = first;
  do {
    const Place at = place_of(face, v);
    visit(at);
    face = face_across_[previous_corner(at)];
  } while (face != first && face != no_index);
  if (face == first) return;
  for (face = face_across_[place_of(first, v).corner]; face != no_index;) {
    const Place at = place_of(face, v);
    visit(at);
    face = face_across_[at.corner];
  }
}

// In each face the end of the side that leaves v, and the start of the incoming side if that is a boundary.
template <class Visit>
void FaceAdjacency::for_each_neighbour(std::uint32_t v, Visit visit) const {
  for_each_face_at(v, [&](Place at) {
    visit(list_.corners[next_corner(at)], at);
    const Place before{at.face, previous_corner(at)};
    if (face_across_[before.corner] == no_index) visit(list_.corners[before.corner], before);
  });
}

std::uint32_t FaceAdjacency::find_edge(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t found = no_index;
  for_each_neighbour(a, [&](std::uint32_t v, Place side) {
    if (v == b) found = side.corner;
  });
  return found;
}

void FaceAdjacency::answer_about_vertex(Relation relation, std::uint32_t v, Answer& out) const {
  std::uint32_t valence = 0;
  if (relation == Relation::vertex_faces) return for_each_face_at(v, [&](Place at) { out.numbers.push_back(at.face); });
  for_each_neighbour(v, [&](std::uint32_t w, Place) {
    ++valence;
    if (relation == Relation::vertex_edges) out.edges.push_back(edge_ends(v, w));
    if (relation == Relation::vertex_vertices) out.numbers.push_back(w);
  });
  if (relation == Relation::valence) out.numbers.push_back(valence);
}

void FaceAdjacency::answer_about_edge(Relation relation, std::uint32_t corner, Answer& out) const {
  const Place side{face_of(corner), corner};
  const EdgeEnds ends = ends_of(side);
  if (relation == Relation::edge_vertices) {
    out.numbers = {ends.a, ends.b};
  } else if (relation == Relation::edge_faces) {
    out.numbers.push_back(side.face);
    if (face_across_[corner] != no_index) out.numbers.push_back(face_across_[corner]);
  } else {
    for (const std::uint32_t v : {ends.a, ends.b})
      for_each_neighbour(v, [&](std::uint32_t w, Place) {
        if (edge_ends(v, w) != ends) out.edges.push_back(edge_ends(v, w));
      });
  }
}

void FaceAdjacency::answer_about_face(Relation relation, std::uint32_t f, Answer& out) const {
  for (std::uint32_t c = list_.offsets[f]; c < list_.offsets[f + 1]; ++c) {
    if (relation == Relation::face_vertices)
      out.numbers.push_back(list_.corners[c]);
    else if (relation == Relation::face_edges)
      out.edges.push_back(ends_of({f, c}));
    else if (face_across_[c] != no_index)
      out.numbers.push_back(face_across_[c]);
  }
  if (relation == Relation::face_faces) sort_unique(out.numbers);
}

bool FaceAdjacency::answer(Relation relation, std::uint32_t element, Answer& out) const {
  return answer_by_element(
      relation, out, [&] { answer_about_vertex(relation, element, out); },
      [&] { answer_about_edge(relation, element, out); }, [&] { answer_about_face(relation, element, out); });
}

Fields FaceAdjacency::record(Element own) const {
  if (own.kind == Element::Kind::vertex)
    return {place("x, y, z", list_.positions[own.index]), link("face", "Face", Face(vertex_face_[own.index]))};
  if (own.kind != Element::Kind::face) return {};
  std::vector<Face> across;
  for (std::uint32_t c = list_.offsets[own.index]; c < list_.offsets[own.index + 1]; ++c)
    across.emplace_back(face_across_[c]);
  return {links("vertices", "vertices", vertices_of(list_, own.face())), links("faces", "faces", across)};
}

}  // namespace ryosen::forms
