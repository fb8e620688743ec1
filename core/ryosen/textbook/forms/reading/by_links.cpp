// Relations asked of forms that are linked: along the wings of edges, or by halfedges.
#include "ryosen/mesh/copies.h"
#include "ryosen/textbook/forms/reading/relation_answer.h"
#include "ryosen/textbook/forms/walk.h"

namespace ryosen::forms {

namespace {

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

}  // namespace

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

}  // namespace ryosen::forms
