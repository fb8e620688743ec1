// The columns (arrays) that make up a mesh, their lengths, and the column ids by which the journal addresses cells.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/handle.h"
#include "ryosen/mesh/value_type.h"

namespace ryosen {

// 16 bytes, so the two halves of an edge share half a cache line. face is none outside the surface.
struct HalfedgeLinks {
  Vertex from;
  Halfedge next;
  Halfedge prev;
  Face face;

  friend bool operator==(const HalfedgeLinks&, const HalfedgeLinks&) = default;
};

// Marks a deleted element in vertex_halfedge and face_halfedge. A deleted edge has `dead_from` as origin of its even
// half.
inline constexpr Halfedge dead_halfedge{0xfffffffeu};
inline constexpr Vertex dead_from{0xfffffffeu};

enum class ElementKind : std::uint8_t { vertex, edge, corner, face, pool };
// The rule by which an element gets a value from others: value_rules.h has the table.
enum class ValueRule : std::uint8_t { blend, first, greatest, sum, own };
// copies: the sources stay, and the element is like them or lies between them. unites: it replaces its sources, which
// are removed, or is one of them itself. divides: it is a part of one source.
enum class Derivation : std::uint8_t { copies, unites, divides };
// The input of an own rule: the values of the sources, as words, and their weights (see derive_value). A part has one
// source, the value that is divided, and its share as weight.
struct ValueSources {
  Derivation derivation;
  std::span<const std::uint32_t* const> values;
  std::span<const double> weights;

  template <AttributeValue T>
  T value(std::size_t source) const {
    T value;
    std::memcpy(&value, values[source], sizeof value);
    return value;
  }
};
// Writes the value, of as many words as its type has, which are 0 before. It must give the same for the same sources.
using OwnRule = void (*)(const ValueSources& sources, std::uint32_t* value);

// An attribute: a value per vertex, edge, corner (= halfedge) or face, or an append-only pool of values that another
// column refers to by index.
struct AttributeColumn {
  std::string name;
  ElementKind element = ElementKind::vertex;
  ValueType type;
  ValueRule rule = ValueRule::first;
  std::vector<std::uint32_t> data;
  std::vector<std::uint32_t> fill;  // the value of a new element, words() long
  std::uint32_t is_removed = 0;     // 1: it keeps its place and its length, so that it can come back
  OwnRule own_rule = nullptr;       // of ValueRule::own

  std::uint32_t words() const { return type.words(); }
  // Whether it has values of this kind of elements and is not removed.
  bool is_of(ElementKind kind) const { return element == kind && is_removed == 0; }
  friend bool operator==(const AttributeColumn&, const AttributeColumn&) = default;
};

// The number of values in a column of this kind in a mesh of these lengths; not for pools.
constexpr std::uint32_t length_of(const ElementKind element, std::uint32_t vertices, std::uint32_t halfedges,
                                  std::uint32_t faces) {
  const std::uint32_t lengths[] = {vertices, halfedges / 2, halfedges, faces};
  return lengths[static_cast<std::size_t>(element)];
}

// An inner loop of a face, in the side table of rings.
struct Ring {
  Halfedge halfedge;              // any halfedge of the loop; dead_halfedge: deleted
  std::uint32_t next = no_index;  // the next ring of the same face

  friend bool operator==(const Ring&, const Ring&) = default;
};

inline constexpr std::size_t max_pools = 4;

struct ColumnLengths {
  std::uint32_t vertices = 0;
  std::uint32_t halfedges = 0;
  std::uint32_t faces = 0;
  std::uint32_t copies = 0;        // length of next_copy and copy_point: 0 or the number of vertices
  std::uint32_t ringed_faces = 0;  // length of first_ring: 0 or the number of faces
  std::uint32_t rings = 0;
  std::array<std::uint32_t, max_pools> pools{};

  friend bool operator==(const ColumnLengths&, const ColumnLengths&) = default;
};

// Live elements as the mesh stores them: every copy of a point and every copy of a cut edge counts.
struct ElementCounts {
  std::uint32_t vertices = 0;
  std::uint32_t edges = 0;
  std::uint32_t faces = 0;
  std::uint32_t rings = 0;

  friend bool operator==(const ElementCounts&, const ElementCounts&) = default;
};

struct MeshColumns {
  ColumnVector<Halfedge> vertex_halfedge;
  UnwrittenVector<HalfedgeLinks> halfedges;
  ColumnVector<Halfedge> face_halfedge;
  std::vector<glm::dvec3> positions;
  std::vector<Vertex> next_copy;          // cyclic list of the copies of a point; empty while there are none
  std::vector<Vertex> copy_point;         // the smallest copy in the list of each; empty as next_copy is
  std::vector<std::uint32_t> first_ring;  // per face, into rings; empty while no face has had a ring
  std::vector<Ring> rings;
  std::vector<AttributeColumn> attributes;
  ElementCounts live;
  std::uint32_t file_vertices = 0;  // vertex numbers below this come from the file

  // Bitwise: a NaN equals itself, 0 and -0 differ.
  friend bool operator==(const MeshColumns& a, const MeshColumns& b) {
    const bool same_positions = a.positions.size() == b.positions.size() &&
                                (a.positions.empty() || std::memcmp(a.positions.data(), b.positions.data(),
                                                                    a.positions.size() * sizeof(glm::dvec3)) == 0);
    return same_positions && a.vertex_halfedge == b.vertex_halfedge && a.halfedges == b.halfedges &&
           a.face_halfedge == b.face_halfedge && a.next_copy == b.next_copy && a.copy_point == b.copy_point &&
           a.first_ring == b.first_ring && a.rings == b.rings && a.attributes == b.attributes && a.live == b.live &&
           a.file_vertices == b.file_vertices;
  }
};

// Column ids of the journal; attribute k of a mesh is first_attribute + k, and whether it is removed is cell k of
// attribute_removed.
enum class Column : std::uint16_t {
  vertex_halfedge,
  from,
  next,
  prev,
  face,
  face_halfedge,
  position,
  next_copy,
  copy_point,
  first_ring,
  ring,
  attribute_removed,
  first_attribute
};
inline constexpr std::size_t most_attributes = 0xffff - static_cast<std::size_t>(Column::first_attribute);
constexpr Column column_of_attribute(std::size_t attribute) {
  return static_cast<Column>(static_cast<std::size_t>(Column::first_attribute) + attribute);
}
constexpr std::size_t attribute_of_column(Column column) {
  return static_cast<std::size_t>(column) - static_cast<std::size_t>(Column::first_attribute);
}

// The length that each has but for attributes, in their order.
inline constexpr std::uint32_t ColumnLengths::*length_of_column[] = {
    &ColumnLengths::vertices,  &ColumnLengths::halfedges,    &ColumnLengths::halfedges, &ColumnLengths::halfedges,
    &ColumnLengths::halfedges, &ColumnLengths::faces,        &ColumnLengths::vertices,  &ColumnLengths::copies,
    &ColumnLengths::copies,    &ColumnLengths::ringed_faces, &ColumnLengths::rings,
};

}  // namespace ryosen
