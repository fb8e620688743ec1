#include "ryosen/textbook/forms/reading/relation_answer.h"

#include "ryosen/base/sort_unique.h"

namespace ryosen::forms {

namespace {

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
