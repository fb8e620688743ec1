// Relations asked of forms that are lists of faces: by a search through all of them, or from face to face.
#include <algorithm>

#include "ryosen/textbook/forms/reading/relation_answer.h"

namespace ryosen::forms {

namespace {

using Corners = std::vector<std::uint32_t>;

std::uint32_t behind(const Corners& corners, std::size_t i) { return corners[i + 1 < corners.size() ? i + 1 : 0]; }
std::uint32_t before(const Corners& corners, std::size_t i) { return corners[i > 0 ? i - 1 : corners.size() - 1]; }

// Adds what a face that has been read tells, by its corner list alone.
void add_from_face(const Asked& asked, std::uint32_t f, const Corners& corners, const Corners& of_asked, Answer& out) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const EdgeEnds side = edge_ends(corners[i], behind(corners, i));
    switch (asked.row.asks) {
      case ElementOf::vertex:
        if (side.a != asked.element.index && side.b != asked.element.index) break;
        out.edges.push_back(side);
        out.numbers.push_back(asked.row.relation == Relation::vertex_faces ? f
                              : side.a == asked.element.index              ? side.b
                                                                           : side.a);
        break;
      case ElementOf::edge:
        if (asked.row.relation == Relation::edge_faces && side == asked.ends) out.numbers.push_back(f);
        if (asked.row.relation == Relation::edge_edges && side != asked.ends &&
            (side.a == asked.ends.a || side.a == asked.ends.b || side.b == asked.ends.a || side.b == asked.ends.b))
          out.edges.push_back(side);
        break;
      case ElementOf::face:
        for (std::size_t k = 0; k < of_asked.size() && f != asked.element.index; ++k)
          if (edge_ends(of_asked[k], behind(of_asked, k)) == side) out.numbers.push_back(f);
        break;
    }
  }
}

Corners corners_of(RecordReader& reader, Face f) {
  Corners corners;
  for (const Element v : reader.links(f, "vertices")) corners.push_back(v.index);
  return corners;
}

void add_own_sides(const Asked& asked, const Corners& corners, Answer& out) {
  if (asked.row.relation == Relation::face_vertices) out.numbers = corners;
  for (std::size_t i = 0; i < corners.size() && asked.row.relation == Relation::face_edges; ++i)
    out.edges.push_back(edge_ends(corners[i], behind(corners, i)));
}

// Table 3: from face to face around a vertex. visit(face, its corners, the faces across, place of the vertex).
template <class Visit>
void for_each_face_at(RecordReader& reader, std::uint32_t v, Visit visit) {
  const std::uint32_t first = reader.link(Vertex(v), "face").index;
  const auto walk = [&](std::uint32_t face, bool clockwise) {
    while (face != no_index) {
      const Corners corners = corners_of(reader, Face(face));
      const std::vector<Element> across = reader.links(Face(face), "faces");
      const std::size_t at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
      if (!clockwise || face != first) visit(face, corners, across, at);
      face = across[clockwise ? at : at > 0 ? at - 1 : corners.size() - 1].index;
      if (face == first) return true;
    }
    return false;
  };
  if (first != no_index && !walk(first, false)) walk(first, true);
}

// The other end of each edge at a vertex.
template <class Visit>
void for_each_neighbour_by_faces(RecordReader& reader, std::uint32_t v, Visit visit) {
  for_each_face_at(reader, v,
                   [&](std::uint32_t, const Corners& corners, const std::vector<Element>& across, std::size_t at) {
                     visit(behind(corners, at));
                     if (across[at > 0 ? at - 1 : corners.size() - 1].index == no_index) visit(before(corners, at));
                   });
}

}  // namespace

// Table 2, and the map of text 003 about a vertex: all faces are looked through, but for what stands in the face
// itself.
void answer_by_search(RecordReader& reader, const Asked& asked, Answer& out) {
  Corners own;
  if (asked.row.asks == ElementOf::face) {
    own = corners_of(reader, asked.element.face());
    add_own_sides(asked, own, out);
    if (asked.row.relation != Relation::face_faces) return;
  }
  for (std::uint32_t f = 0; f < reader.mesh().face_slots(); ++f)
    if (reader.mesh().is_alive(Face(f))) add_from_face(asked, f, corners_of(reader, Face(f)), own, out);
}

void answer_by_faces(RecordReader& reader, const Asked& asked, Answer& out) {
  const std::uint32_t x = asked.element.index;
  const Relation relation = asked.row.relation;
  if (relation == Relation::vertex_faces) {
    for_each_face_at(reader, x, [&](std::uint32_t f, const Corners&, const std::vector<Element>&, std::size_t) {
      out.numbers.push_back(f);
    });
  } else if (asked.row.asks == ElementOf::vertex) {
    for_each_neighbour_by_faces(reader, x, [&](std::uint32_t w) {
      out.numbers.push_back(w);
      out.edges.push_back(edge_ends(x, w));
    });
  } else if (relation == Relation::edge_edges) {
    for (const std::uint32_t end : {asked.ends.a, asked.ends.b})
      for_each_neighbour_by_faces(reader, end, [&](std::uint32_t w) {
        if (edge_ends(end, w) != asked.ends) out.edges.push_back(edge_ends(end, w));
      });
  } else if (relation == Relation::edge_faces) {
    for_each_face_at(reader, asked.ends.a,
                     [&](std::uint32_t f, const Corners& corners, const std::vector<Element>&, std::size_t at) {
                       if (behind(corners, at) == asked.ends.b || before(corners, at) == asked.ends.b)
                         out.numbers.push_back(f);
                     });
  } else if (relation == Relation::face_faces) {
    for (const Element across : reader.links(asked.element, "faces"))
      if (across.index != no_index) out.numbers.push_back(across.index);
  } else {
    add_own_sides(asked, corners_of(reader, asked.element.face()), out);
  }
}

}  // namespace ryosen::forms
