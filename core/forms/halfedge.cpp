#include "core/forms/halfedge.h"

#include "core/forms/polygons.h"
#include "core/forms/walk.h"

namespace ryosen::forms {

template <bool outside, bool edge_records>
HalfedgeForm<outside, edge_records>::HalfedgeForm(const Mesh& mesh)
    : table_(outside ? all_halfedges(mesh) : inner_halfedges(mesh)) {
  if constexpr (!edge_records) return;
  halfedge_edge_.resize(table_.halfedges.size());
  for (std::uint32_t h = 0; h < table_.halfedges.size(); ++h) {
    const std::uint32_t pair = table_.pair(h);
    if (pair < h) {
      halfedge_edge_[h] = halfedge_edge_[pair];
      continue;
    }
    halfedge_edge_[h] = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back({table_.from(h), table_.from(table_.next(h)), h, pair});
  }
}

template <bool outside, bool edge_records>
std::size_t HalfedgeForm<outside, edge_records>::bytes() const {
  return table_.bytes() + bytes_of(halfedge_edge_) + bytes_of(edges_);
}

template <bool outside, bool edge_records>
Mesh HalfedgeForm<outside, edge_records>::to_mesh() const {
  return outside ? mesh_from_all_halfedges(table_) : mesh_from_inner_halfedges(table_);
}

template <bool outside, bool edge_records>
std::uint32_t HalfedgeForm<outside, edge_records>::find_edge(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t h = find_side(table_, a, b);
  return edge_records && h != no_index ? halfedge_edge_[h] : h;
}

template <bool outside, bool edge_records>
bool HalfedgeForm<outside, edge_records>::answer(Relation relation, std::uint32_t element, Answer& out) const {
  if constexpr (edge_records) {
    if (relation == Relation::edge_vertices) {
      out.clear();
      out.numbers = {edges_[element].start, edges_[element].end};
      return true;
    }
    if (relation == Relation::edge_edges || relation == Relation::edge_faces) element = edges_[element].left;
  }
  answer_by_walk(table_, relation, element, out);
  return true;
}

template class HalfedgeForm<false, false>;
template class HalfedgeForm<false, true>;
template class HalfedgeForm<true, false>;
template class HalfedgeForm<true, true>;

}  // namespace ryosen::forms
