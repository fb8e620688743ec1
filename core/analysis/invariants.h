// Whether the columns of a mesh describe a mesh, and if not, which element breaks which rule.
#pragma once

#include <optional>
#include <string>

#include "core/mesh/mesh.h"

namespace ryosen {

struct BrokenInvariant {
  std::string rule;      // stable id, for example "next_prev"
  std::string element;   // by slot: v7, h12, e6, f3; empty where the rule is about a whole column
  std::string sentence;  // English, names the element
};

// The first broken rule, or nothing. Reads any columns without crashing or endless walk, however corrupt. O(n).
std::optional<BrokenInvariant> check_invariants(const Mesh& mesh);

}  // namespace ryosen
