// Asking the predicates of a row (of a problem, of a highlight) about elements.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/parallel.h"

namespace ryosen {

template <class Row>
bool speaks_of(const Row& row, Vertex) {
  return row.vertex != nullptr;
}
template <class Row>
bool speaks_of(const Row& row, Edge) {
  return row.edge != nullptr;
}
template <class Row>
bool speaks_of(const Row& row, Face) {
  return row.face != nullptr;
}

template <class Row>
bool holds(const Row& row, Neighbourhood& around, Vertex v) {
  return row.vertex(around, v);
}
template <class Row>
bool holds(const Row& row, Neighbourhood& around, Edge e) {
  return row.edge(around, e);
}
template <class Row>
bool holds(const Row& row, Neighbourhood& around, Face f) {
  return row.face(around, f);
}

inline std::uint32_t slots_of(const Mesh& mesh, Vertex) { return mesh.vertex_slots(); }
inline std::uint32_t slots_of(const Mesh& mesh, Edge) { return mesh.edge_slots(); }
inline std::uint32_t slots_of(const Mesh& mesh, Face) { return mesh.face_slots(); }

// Whether the row says so of an element that exists and is alive; it speaks of such elements.
template <class Row, class Element>
bool is_member(const Row& row, Neighbourhood& around, Element element) {
  return around.mesh().exists(element) && around.mesh().is_alive(element) && holds(row, around, element);
}

// Adds the members among a range of the vertices, of the edges or of the faces.
template <class Element, class Row>
void search_range(const Row& row, Neighbourhood& around, std::uint32_t begin, std::uint32_t end,
                  std::vector<std::uint32_t>& members) {
  if (!speaks_of(row, Element())) return;
  const Mesh& mesh = around.mesh();
  for (std::uint32_t i = begin; i < end; ++i) {
    stop_if_interrupted(i);
    if (mesh.is_alive(Element(i)) && holds(row, around, Element(i))) members.push_back(i);
  }
}

// The same of one of `parts` parts.
template <class Element, class Row>
void search_part(const Row& row, Neighbourhood& around, unsigned part, unsigned parts,
                 std::vector<std::uint32_t>& members) {
  const std::uint32_t slots = slots_of(around.mesh(), Element());
  search_range<Element>(row, around, part_begin(slots, part, parts), part_begin(slots, part + 1, parts), members);
}

}  // namespace ryosen
