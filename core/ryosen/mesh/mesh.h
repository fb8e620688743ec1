// The halfedge mesh: polygonal, with boundary, stored as plain columns. Read access here; written only through Edit.
//
//            to(h)
//              o            next(h), prev(h): along the loop of face(h), counter-clockwise
//      face   /|            twin(h) = h ^ 1, edge(h) = h >> 1
//       (h)  / |  twin(h)   face(h) none: a boundary halfedge (is_outside), along a hole, the outer border or a wire
//           h  |            a vertex stores one outgoing halfedge, a boundary one if it has any
//          /   |
//         o----o
//        from(h)
//
// A vertex is one cycle of outgoing halfedges, which may hold several fans of faces and wires (edges without a face)
// with gaps between them. Several vertices may stand for one point of the file: its copies (see copies.h). A face may
// have inner loops (see rings.h).
#pragma once

#include <cassert>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <utility>

#include "ryosen/mesh/columns.h"

namespace ryosen {

class Mesh {
 public:
  Mesh() = default;
  // The columns must satisfy the invariants (mesh/invariants.h); ryosen/indexed builds them.
  explicit Mesh(MeshColumns columns) : columns_(std::move(columns)) {}

  // Number of slots, live and dead. Handle indices are below these.
  std::uint32_t vertex_slots() const { return static_cast<std::uint32_t>(columns_.vertex_halfedge.size()); }
  std::uint32_t halfedge_slots() const { return static_cast<std::uint32_t>(columns_.halfedges.size()); }
  std::uint32_t edge_slots() const { return halfedge_slots() / 2; }
  std::uint32_t face_slots() const { return static_cast<std::uint32_t>(columns_.face_halfedge.size()); }
  const ElementCounts& live() const { return columns_.live; }

  bool exists(Vertex v) const { return v.index < vertex_slots(); }
  bool exists(Edge e) const { return e.index < edge_slots(); }
  bool exists(Halfedge h) const { return h.index < halfedge_slots(); }
  bool exists(Face f) const { return f.index < face_slots(); }
  // Whether the element of an existing slot has not been deleted. A quarantined face (indexed.h) occupies a dead slot.
  bool is_alive(Vertex v) const { return columns_.vertex_halfedge[v.index] != dead_halfedge; }
  bool is_alive(Edge e) const { return columns_.halfedges[2 * std::size_t{e.index}].from != dead_from; }
  bool is_alive(Halfedge h) const { return is_alive(edge(h)); }
  bool is_alive(Face f) const { return columns_.face_halfedge[f.index] != dead_halfedge; }

  // Links. Each is one memory access; the element must be alive.
  Vertex from(Halfedge h) const { return columns_.halfedges[h.index].from; }
  Vertex to(Halfedge h) const { return columns_.halfedges[h.index ^ 1u].from; }
  Halfedge next(Halfedge h) const { return columns_.halfedges[h.index].next; }
  Halfedge prev(Halfedge h) const { return columns_.halfedges[h.index].prev; }
  Face face(Halfedge h) const { return columns_.halfedges[h.index].face; }
  const HalfedgeLinks& links(Halfedge h) const { return columns_.halfedges[h.index]; }
  Halfedge halfedge(Vertex v) const { return columns_.vertex_halfedge[v.index]; }
  Halfedge halfedge(Face f) const { return columns_.face_halfedge[f.index]; }

  // The next outgoing halfedge around from(h).
  Halfedge counter_clockwise(Halfedge h) const { return twin(prev(h)); }
  Halfedge clockwise(Halfedge h) const { return next(twin(h)); }

  bool is_outside(Halfedge h) const { return face(h).is_none(); }
  bool is_boundary(Edge e) const { return is_outside(ryosen::halfedge(e, 0)) != is_outside(ryosen::halfedge(e, 1)); }
  // An edge without a face on either side.
  bool is_wire(Edge e) const { return is_outside(ryosen::halfedge(e, 0)) && is_outside(ryosen::halfedge(e, 1)); }
  bool is_isolated(Vertex v) const { return halfedge(v).is_none(); }
  bool is_boundary(Vertex v) const { return !is_isolated(v) && is_outside(halfedge(v)); }

  const glm::dvec3& position(Vertex v) const { return columns_.positions[v.index]; }
  std::span<const glm::dvec3> positions() const { return columns_.positions; }

  bool has_copies() const { return !columns_.next_copy.empty(); }
  Vertex next_copy(Vertex v) const { return columns_.next_copy.empty() ? v : columns_.next_copy[v.index]; }
  // The smallest copy of the point of v: v itself where it is the only one.
  Vertex copy_point(Vertex v) const { return columns_.copy_point.empty() ? v : columns_.copy_point[v.index]; }
  bool has_rings() const { return columns_.live.rings != 0; }
  // The first ring of a face (no_index if none) and the ring with a given number, see rings.h.
  std::uint32_t first_ring(Face f) const {
    return columns_.first_ring.empty() ? no_index : columns_.first_ring[f.index];
  }
  const Ring& ring(std::uint32_t number) const { return columns_.rings[number]; }
  bool has_rings(Face f) const { return first_ring(f) != no_index; }
  std::uint32_t file_vertices() const { return columns_.file_vertices; }

  // The index of the attribute with this name, or -1. See attribute.h for its values.
  int find_attribute(std::string_view name) const;
  // All attributes, removed ones included, in the order of their indices.
  std::span<const AttributeColumn> attributes() const { return columns_.attributes; }

  const MeshColumns& columns() const& { return columns_; }
  // A mesh that is used no more gives its columns away without a copy.
  MeshColumns columns() && { return std::move(columns_); }
  ColumnLengths lengths() const;
  // 64-bit hash of the live elements: slots, positions, corner lists, rings, wires, copies. Depends on element and
  // corner order; the same on all compilers.
  std::uint64_t hash() const;
  // Bytes held by connectivity and positions (no attributes, no copies).
  std::size_t core_bytes() const;

 private:
  friend class Edit;
  friend class Journal;

  // The first byte and the size in bytes of a cell.
  std::pair<std::byte*, std::size_t> cell(Column column, std::uint32_t index);

  MeshColumns columns_;
};

}  // namespace ryosen
