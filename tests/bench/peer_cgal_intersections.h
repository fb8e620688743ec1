// CGAL's search for self-intersections, exact as ours. Only benchmarks use it.
#pragma once

#include <cstddef>
#include <functional>

#include "ryosen/indexed/indexed.h"

namespace ryosen::bench {

// Builds its mesh; each call of what it returns searches it once and tells how many pairs of faces intersect.
std::function<std::size_t()> cgal_intersections(const IndexedMesh& source);

}  // namespace ryosen::bench
