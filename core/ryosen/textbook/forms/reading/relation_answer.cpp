#include "ryosen/textbook/forms/reading/relation_answer.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/walk.h"

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

// Table 2, and the map of text 003 about a vertex: all faces are looked through, but for what stands in the face
// itself.
void answer_by_search(RecordReader& reader, const Asked& asked, Answer& out) {
  Corners own;
  if (asked.row.asks == ElementOf::face) {
    own = corners_of(reader, asked.element.face());
    add_own_sides(asked, own, out);
    if (asked.row.relation != Relation::face_faces) return;
  }
  for (const Face f : live_faces(reader.mesh())) add_from_face(asked, f.index, corners_of(reader, f), own, out);
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

// Table 4: along the wings.
class Wings {
 public:
  explicit Wings(RecordReader& reader) : reader_(reader) {}

  std::uint32_t get(std::uint32_t e, std::string_view key) { return reader_.link(Edge(e), key).index; }
  EdgeEnds ends(std::uint32_t e) { return edge_ends(get(e, "from"), get(e, "to")); }

  // Counter-clockwise up to a gap, then clockwise from the first edge.
  template <class Visit>
  void for_each_edge_at(std::uint32_t v, Visit visit) {
    const std::uint32_t first = reader_.link(Vertex(v), "edge").index;
    if (first == no_index) return;
    std::uint32_t e = first;
    do {
      visit(e);
      e = get(e, get(e, "from") == v ? "left_prev" : "right_prev");
    } while (e != first && e != no_index);
    if (e == first) return;
    for (e = clockwise(first, v); e != no_index; e = clockwise(e, v)) visit(e);
  }
  template <class Visit>
  void for_each_edge_of(std::uint32_t f, Visit visit) {
    const std::uint32_t first = reader_.link(Face(f), "edge").index;
    std::uint32_t e = first;
    do {
      const bool is_left = get(e, "left") == f;
      visit(e, is_left);
      e = get(e, is_left ? "left_next" : "right_next");
    } while (e != first);
  }

 private:
  std::uint32_t clockwise(std::uint32_t e, std::uint32_t v) {
    return get(e, get(e, "from") == v ? "right_next" : "left_next");
  }
  RecordReader& reader_;
};

// Where a point has copies: the copies one by one.
void answer_by_copies(RecordReader& reader, const RecordLinks& links, const Asked& asked, Answer& out) {
  const Mesh& mesh = reader.mesh();
  const auto point = [&](std::uint32_t v) { return mesh.copy_point(Vertex(v)).index; };
  const auto for_each_copy_read = [&](std::uint32_t v, const auto& visit) {
    Vertex copy(v);
    do {
      visit(copy.index);
      const Element next = reader.link(copy, "next_copy");
      copy = next.index == no_index ? Vertex(v) : next.vertex();
    } while (copy.index != v);
  };
  const auto add_neighbours = [&](std::uint32_t v) {
    for_each_copy_read(v, [&](std::uint32_t copy) {
      for_each_neighbour(links, links.at_vertex(copy), [&](std::uint32_t w) {
        if (asked.row.asks == ElementOf::edge && edge_ends(point(v), point(w)) == asked.ends) return;
        out.numbers.push_back(point(w));
        out.edges.push_back(edge_ends(point(v), point(w)));
      });
    });
  };
  const std::uint32_t x = asked.element.index;
  if (asked.row.relation == Relation::vertex_faces) {
    for_each_copy_read(x, [&](std::uint32_t copy) { answer_about_vertex(links, Relation::vertex_faces, copy, out); });
  } else if (asked.row.asks == ElementOf::vertex) {
    add_neighbours(x);
  } else if (asked.row.relation == Relation::edge_edges) {
    add_neighbours(asked.ends.a);
    add_neighbours(asked.ends.b);
  } else if (asked.row.relation == Relation::edge_faces || asked.row.relation == Relation::face_faces) {
    const auto add_sheets = [&](EdgeEnds ends) {
      for_each_copy_read(ends.a, [&](std::uint32_t copy) {
        for_each_leaving(links, links.at_vertex(copy), [&](std::uint32_t h) {
          if (point(links.from(links.next(h))) != ends.b) return;
          for (const std::uint32_t side : {h, links.pair(h)})
            if (links.face(side) != no_index && (asked.row.asks != ElementOf::face || links.face(side) != x))
              out.numbers.push_back(links.face(side));
        });
      });
    };
    if (asked.row.asks == ElementOf::edge) return add_sheets(asked.ends);
    std::vector<EdgeEnds> sides;
    for_each_in_face(links, x, [&](std::uint32_t h) {
      sides.push_back(edge_ends(point(links.from(h)), point(links.from(links.next(h)))));
    });
    for (const EdgeEnds side : sides) add_sheets(side);
  } else {
    answer_by_walk(links, asked.row.relation, x, out);
    for (EdgeEnds& side : out.edges) side = edge_ends(point(side.a), point(side.b));
    for (std::uint32_t& v : out.numbers) v = point(v);
  }
}

void answer_by_wings(RecordReader& reader, const Asked& asked, Answer& out) {
  Wings wings(reader);
  const std::uint32_t x = asked.element.index;
  const Relation relation = asked.row.relation;
  const auto add_face = [&](std::uint32_t f) {
    if (f != no_index && f != (asked.row.asks == ElementOf::face ? x : no_index)) out.numbers.push_back(f);
  };
  if (asked.row.asks == ElementOf::vertex) {
    wings.for_each_edge_at(x, [&](std::uint32_t e) {
      const EdgeEnds ends = wings.ends(e);
      out.edges.push_back(ends);
      if (relation == Relation::vertex_faces)
        add_face(wings.get(e, wings.get(e, "from") == x ? "left" : "right"));
      else
        out.numbers.push_back(ends.a == x ? ends.b : ends.a);
    });
  } else if (relation == Relation::edge_faces) {
    for (const std::string_view side : {"left", "right"}) add_face(wings.get(x, side));
  } else if (relation == Relation::edge_edges) {
    for (const std::string_view end : {"from", "to"})
      wings.for_each_edge_at(wings.get(x, end), [&](std::uint32_t e) {
        if (e != x) out.edges.push_back(wings.ends(e));
      });
  } else if (asked.row.asks == ElementOf::face) {
    wings.for_each_edge_of(x, [&](std::uint32_t e, bool is_left) {
      out.edges.push_back(wings.ends(e));
      if (relation == Relation::face_vertices) out.numbers.push_back(wings.get(e, is_left ? "from" : "to"));
      if (relation == Relation::face_faces) add_face(wings.get(e, is_left ? "right" : "left"));
    });
  }
}

// The halfedge by which a form with halfedges reaches an edge: what the edge's record says, else the one that it
// numbers.
std::uint32_t side_of_edge(RecordReader& reader, Edge e) {
  if (reader.stores(Element::Kind::edge, "left")) return reader.link(e, "left").index;
  if (reader.stores(Element::Kind::edge, "halfedges")) return reader.links(e, "halfedges").front().index;
  const Halfedge h = halfedge(e);
  return reader.mesh().is_outside(h) ? twin(h).index : h.index;
}

void answer_by_links(RecordReader& reader, const Asked& asked, Answer& out) {
  const RecordLinks links(reader);
  // A form of points holds no mesh with copies, though one that once had some keeps the column.
  if (reader.row().holds_copies && reader.mesh().has_copies()) return answer_by_copies(reader, links, asked, out);
  const std::uint32_t element =
      asked.row.asks == ElementOf::edge ? side_of_edge(reader, asked.element.edge()) : asked.element.index;
  const Relation relation = asked.row.relation == Relation::valence ? Relation::vertex_vertices : asked.row.relation;
  answer_by_walk(links, relation, element, out);
}

// By its record, or that of a halfedge; a form without either has an edge by its ends alone, and reads nothing.
void answer_ends(RecordReader& reader, const Asked& asked, Answer& out) {
  const Edge e = asked.element.edge();
  const auto point = [&](std::uint32_t v) { return reader.mesh().copy_point(Vertex(v)).index; };
  if (reader.stores(Element::Kind::edge, "from")) {
    out.numbers = {reader.link(e, "from").index, reader.link(e, "to").index};
  } else if (reader.stores(Element::Kind::halfedge, "from")) {
    const RecordLinks links(reader);
    const std::uint32_t h = side_of_edge(reader, e);
    out.numbers = {point(links.from(h)), point(links.from(links.next(h)))};
  } else {
    out.numbers = {asked.ends.a, asked.ends.b};
  }
}

}  // namespace

Asked asked_about(const Mesh& mesh, const RelationRow& row, Element element) {
  if (element.kind == Element::Kind::vertex) return {row, mesh.copy_point(element.vertex()), {}};
  if (element.kind != Element::Kind::edge) return {row, element, {}};
  const Halfedge h = halfedge(element.edge());
  return {row, element, edge_ends(mesh.copy_point(mesh.from(h)).index, mesh.copy_point(mesh.to(h)).index)};
}

bool answer_by_records(RecordReader& reader, const Asked& asked, Answer& out) {
  if (!reader.row().stores_vertices) return false;
  const bool leads_nowhere = asked.row.asks == ElementOf::vertex && !reader.stores(Element::Kind::vertex, "halfedge");
  if (asked.row.relation == Relation::edge_vertices)
    answer_ends(reader, asked, out);
  else if (reader.stores(Element::Kind::vertex, "face"))
    answer_by_faces(reader, asked, out);
  else if (reader.stores(Element::Kind::vertex, "edge"))
    answer_by_wings(reader, asked, out);
  else if (reader.stores(Element::Kind::halfedge, "from") && !leads_nowhere)
    answer_by_links(reader, asked, out);
  else
    answer_by_search(reader, asked, out);
  // What a face says of itself comes in its order.
  if (asked.row.relation == Relation::face_vertices || asked.row.relation == Relation::face_edges) return true;
  sort_unique(out.numbers);
  sort_unique(out.edges);
  return true;
}

}  // namespace ryosen::forms
