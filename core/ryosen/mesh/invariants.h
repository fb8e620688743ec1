// Validation of the columns of a mesh: the first invariant that is violated and the element that violates it.
#pragma once

#include <optional>
#include <string>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct BrokenInvariant {
  std::string rule;      // stable id, for example "next_prev"
  std::string element;   // by slot: v7, h12, e6, f3; empty if the rule concerns a whole column
  std::string sentence;  // English, names the element
};

// The first violated invariant, or none. Safe on arbitrarily corrupt columns: no crash, no endless loop. O(n).
std::optional<BrokenInvariant> check_invariants(const Mesh& mesh);

}  // namespace ryosen
