// Counts what an algorithm made cross.
#pragma once

#include "ryosen/algo/algorithm.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Adds to the result of an algorithm, and to its sentence, how many pairs of faces meet now that did not before. Cost:
// that of two searches for self-intersections.
void add_new_crossings(const Mesh& before, const Mesh& after, AlgorithmResult& result);

}  // namespace ryosen
