// Asking the predicates of a row (of a problem, of a highlight) about elements.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/parallel.h"

namespace ryosen {

// The predicate of a row about elements of this sort; null where it does not speak of them.
template <class Row>
auto predicate_of(const Row& row, Vertex) {
  return row.vertex;
}
template <class Row>
auto predicate_of(const Row& row, Edge) {
  return row.edge;
}
template <class Row>
auto predicate_of(const Row& row, Face) {
  return row.face;
}

template <class Row, class Element>
bool speaks_of(const Row& row, Element element) {
  return predicate_of(row, element) != nullptr;
}

inline std::uint32_t slots_of(const Mesh& mesh, Vertex) { return mesh.vertex_slots(); }
inline std::uint32_t slots_of(const Mesh& mesh, Edge) { return mesh.edge_slots(); }
inline std::uint32_t slots_of(const Mesh& mesh, Face) { return mesh.face_slots(); }

// Whether the row says so of an element that exists and is alive; it speaks of such elements.
template <class Row, class Element>
bool is_member(const Row& row, Neighbourhood& around, Element element) {
  return around.mesh().exists(element) && around.mesh().is_alive(element) &&
         predicate_of(row, element)(around, element);
}

// Adds the members among a range of the vertices, of the edges or of the faces.
template <class Element, class Row>
void search_range(const Row& row, Neighbourhood& around, std::uint32_t begin, std::uint32_t end,
                  std::vector<std::uint32_t>& members) {
  const auto holds = predicate_of(row, Element());
  if (!holds) return;
  const Mesh& mesh = around.mesh();
  for (std::uint32_t i = begin; i < end; ++i) {
    stop_if_interrupted(i);
    if (mesh.is_alive(Element(i)) && holds(around, Element(i))) members.push_back(i);
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
