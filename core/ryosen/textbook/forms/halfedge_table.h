// Table 5 of the source texts: halfedges with vertex, face, pair, next and prev.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen::forms {

// Plain records; no_index stands for the source texts' null. At a boundary the pair is either none (as in table 5) or a
// boundary halfedge without a face (the variant of the source texts' footnote).
struct HalfedgeTable {
  struct Record {
    std::uint32_t vertex, face, pair, next, prev;

    friend bool operator==(const Record&, const Record&) = default;
  };
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> vertex_halfedge;  // an outgoing halfedge, or none
  std::vector<Record> halfedges;
  std::vector<std::uint32_t> face_halfedge;

  friend bool operator==(const HalfedgeTable&, const HalfedgeTable&) = default;

  // The interface of walk.h.
  std::uint32_t from(std::uint32_t h) const { return halfedges[h].vertex; }
  std::uint32_t next(std::uint32_t h) const { return halfedges[h].next; }
  std::uint32_t prev(std::uint32_t h) const { return halfedges[h].prev; }
  std::uint32_t pair(std::uint32_t h) const { return halfedges[h].pair; }
  std::uint32_t face(std::uint32_t h) const { return halfedges[h].face; }
  std::uint32_t at_vertex(std::uint32_t v) const { return vertex_halfedge[v]; }
  std::uint32_t at_face(std::uint32_t f) const { return face_halfedge[f]; }
  std::uint32_t at_edge(std::uint32_t h) const { return h; }
  static std::span<const std::uint32_t> inner(std::uint32_t) { return {}; }

  std::size_t bytes() const;
};

// The halfedges are the corners, in the order of the faces. No copies, no wires, one fan at each vertex.
HalfedgeTable inner_halfedges(const Mesh& mesh);
// The halfedges are those of the mesh, including boundary ones and wires. No copies.
HalfedgeTable all_halfedges(const Mesh& mesh);

Mesh mesh_from_inner_halfedges(const HalfedgeTable& table);
// `inner`: the first halfedges of the inner loops of each face; empty where no face has any.
Mesh mesh_from_all_halfedges(const HalfedgeTable& table, const std::vector<std::vector<std::uint32_t>>& inner = {});

}  // namespace ryosen::forms
