// The halfedge structure of text 002: vertices, edges, halfedges and loops. A halfedge stores no pair: it is the other
// one of its parent edge.
#pragma once

#include "ryosen/textbook/forms/halfedge_table.h"
#include "ryosen/textbook/forms/walk.h"

namespace ryosen::forms {

// The halfedges are those of the mesh, also where there is no face. The handle of an edge is its number.
class HalfedgeLoop : public LinkedForm<HalfedgeLoop> {
 public:
  explicit HalfedgeLoop(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  Fields record(Element own) const override;

  // The interface of walk.h.
  std::uint32_t from(std::uint32_t h) const { return halfedges_[h].start; }
  std::uint32_t next(std::uint32_t h) const { return halfedges_[h].next; }
  std::uint32_t prev(std::uint32_t h) const { return halfedges_[h].prev; }
  std::uint32_t pair(std::uint32_t h) const {
    const EdgeRecord& parent = edges_[halfedges_[h].edge];
    return parent.left == h ? parent.right : parent.left;
  }
  std::uint32_t face(std::uint32_t h) const { return halfedges_[h].loop; }
  std::uint32_t at_vertex(std::uint32_t v) const { return vertices_[v].halfedge; }
  std::uint32_t at_face(std::uint32_t f) const { return loop_halfedge_[f]; }
  std::uint32_t at_edge(std::uint32_t e) const { return edges_[e].left; }

 private:
  struct VertexRecord {
    glm::dvec3 position;
    std::uint32_t halfedge;
  };
  struct EdgeRecord {
    std::uint32_t left, right;
  };
  struct HalfedgeRecord {
    std::uint32_t edge, start, next, prev, loop;
  };
  std::vector<VertexRecord> vertices_;
  std::vector<EdgeRecord> edges_;
  std::vector<HalfedgeRecord> halfedges_;
  std::vector<std::uint32_t> loop_halfedge_;
};

}  // namespace ryosen::forms
