#include "ryosen/textbook/forms/halfedge_loop.h"

#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

HalfedgeLoop::HalfedgeLoop(const Mesh& mesh) {
  const HalfedgeTable table = all_halfedges(mesh);
  for (std::uint32_t v = 0; v < table.positions.size(); ++v)
    vertices_.push_back({table.positions[v], table.vertex_halfedge[v]});
  for (std::uint32_t h = 0; h < table.halfedges.size(); ++h) {
    if (h % 2 == 0) edges_.push_back({h, table.pair(h)});
    halfedges_.push_back({h / 2, table.from(h), table.next(h), table.prev(h), table.face(h)});
  }
  loop_halfedge_ = table.face_halfedge;
}

std::size_t HalfedgeLoop::bytes() const {
  return bytes_of(vertices_) + bytes_of(edges_) + bytes_of(halfedges_) + bytes_of(loop_halfedge_);
}

Mesh HalfedgeLoop::to_mesh() const {
  HalfedgeTable table;
  for (const VertexRecord& v : vertices_) {
    table.positions.push_back(v.position);
    table.vertex_halfedge.push_back(v.halfedge);
  }
  for (std::uint32_t h = 0; h < halfedges_.size(); ++h)
    table.halfedges.push_back({from(h), face(h), pair(h), next(h), prev(h)});
  table.face_halfedge = loop_halfedge_;
  return mesh_from_all_halfedges(table);
}

std::uint32_t HalfedgeLoop::find_edge(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t side = find_side(*this, a, b);
  return side == no_index ? side : halfedges_[side].edge;
}

Fields HalfedgeLoop::record(Element own) const {
  const std::uint32_t i = own.index;
  if (own.kind == Element::Kind::vertex)
    return {place("頂点座標値", vertices_[i].position),
            link("halfedge", "自身を始点とする半稜線", Halfedge(vertices_[i].halfedge))};
  if (own.kind == Element::Kind::edge)
    return {links("halfedges", "両側の半稜線", std::vector{Halfedge(edges_[i].left), Halfedge(edges_[i].right)})};
  if (own.kind == Element::Kind::face) return {link("halfedge", "構成する半稜線", Halfedge(loop_halfedge_[i]))};
  const HalfedgeRecord& h = halfedges_[i];
  return {link("edge", "親稜線", Edge(h.edge)), link("from", "始点頂点", Vertex(h.start)),
          link("next", "次の半稜線", Halfedge(h.next)), link("prev", "前の半稜線", Halfedge(h.prev)),
          link("face", "属する面", Face(h.loop))};
}

}  // namespace ryosen::forms
