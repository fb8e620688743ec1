#include "ryosen/textbook/forms/halfedge.h"

#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/forms/walk.h"

namespace ryosen::forms {

HalfedgeForm::HalfedgeForm(const Mesh& mesh, bool outside, bool edge_records)
    : outside_(outside), edge_records_(edge_records), table_(outside ? all_halfedges(mesh) : inner_halfedges(mesh)) {
  if (!edge_records) return;
  if (outside)
    for (std::uint32_t h = 0; h < table_.halfedges.size(); ++h) halfedge_edge_.push_back(h / 2);
  else
    for (const Numbering numbers(mesh); const Halfedge h : corner_halfedges(mesh))
      halfedge_edge_.push_back(numbers.edge[edge(h).index]);
  edges_.resize(mesh.live().edges);
  for (std::uint32_t h = 0; h < table_.halfedges.size(); ++h)
    if (const std::uint32_t pair = table_.pair(h); pair > h)
      edges_[halfedge_edge_[h]] = {table_.from(h), table_.from(table_.next(h)), h, pair};
}

std::size_t HalfedgeForm::bytes() const { return table_.bytes() + bytes_of(halfedge_edge_) + bytes_of(edges_); }

Mesh HalfedgeForm::to_mesh() const {
  return outside_ ? mesh_from_all_halfedges(table_) : mesh_from_inner_halfedges(table_);
}

std::uint32_t HalfedgeForm::find_edge(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t h = find_side(table_, a, b);
  return edge_records_ && h != no_index ? halfedge_edge_[h] : h;
}

bool HalfedgeForm::answer(Relation relation, std::uint32_t element, Answer& out) const {
  if (edge_records_ && relation == Relation::edge_vertices) {
    out.clear();
    out.numbers = {edges_[element].start, edges_[element].end};
    return true;
  }
  if (edge_records_ && (relation == Relation::edge_edges || relation == Relation::edge_faces))
    element = edges_[element].left;
  return answer_by_walk(table_, relation, element, out);
}

Fields HalfedgeForm::record(Element own) const {
  const std::uint32_t i = own.index;
  if (own.kind == Element::Kind::vertex)
    return {place("x, y, z", table_.positions[i]), link("halfedge", "halfedge", Halfedge(table_.vertex_halfedge[i]))};
  if (own.kind == Element::Kind::face) return {link("halfedge", "halfedge", Halfedge(table_.face_halfedge[i]))};
  if (own.kind == Element::Kind::halfedge) {
    const HalfedgeTable::Record& h = table_.halfedges[i];
    Fields fields{link("from", "vertex", Vertex(h.vertex)), link("face", "face", Face(h.face)),
                  link("twin", "pair", Halfedge(h.pair)), link("next", "next", Halfedge(h.next)),
                  link("prev", "prev", Halfedge(h.prev))};
    if (edge_records_) fields.push_back(link("edge", "edge", Edge(halfedge_edge_[i])));
    return fields;
  }
  if (!edge_records_) return {};
  const EdgeRecord& e = edges_[i];
  return {link("from", "start", Vertex(e.start)), link("to", "end", Vertex(e.end)),
          link("left", "left", Halfedge(e.left)), link("right", "right", Halfedge(e.right))};
}

}  // namespace ryosen::forms
