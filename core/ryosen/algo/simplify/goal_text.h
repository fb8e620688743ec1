// The sentences on how a simplification ended.
#pragma once

#include <cstddef>

#include "ryosen/algo/algorithm.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Edges of a surface, counted on points.
struct EdgeAgreement {
  std::size_t edges = 0, misoriented = 0;  // misoriented: the two faces run along them in the same direction

  // Then nearly every edge is a boundary of the surface as it is stored, and stays.
  bool is_lost() const { return 2 * misoriented > edges; }
};
// O(edges).
EdgeAgreement count_agreement(const Mesh& mesh);

// How the topology of a surface was changed.
struct TopologyChange {
  bool is_allowed = false;
  std::size_t closed_handles = 0, joined_parts = 0;
  bool has_parts_too_far = false;  // to be joined without losing the shape
};

// The mesh as it is at the end, and its faces before and after, those set aside included.
Text text_of_goal(const Mesh& mesh, std::size_t before, std::size_t after, const GoalReport& report,
                  const TopologyChange& change);
// Why the mesh was left as it is.
Text text_of_misoriented(const EdgeAgreement& agreement);

}  // namespace ryosen
