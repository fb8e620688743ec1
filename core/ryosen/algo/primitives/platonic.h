// The primitives that are the five regular solids.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// The cube by the length of its edges, along the axes. The others by the radius of the sphere through their vertices.
AlgorithmResult add_cube(Edit& edit, const AlgorithmInput& input, Progress& progress);
AlgorithmResult add_tetrahedron(Edit& edit, const AlgorithmInput& input, Progress& progress);
AlgorithmResult add_octahedron(Edit& edit, const AlgorithmInput& input, Progress& progress);
AlgorithmResult add_dodecahedron(Edit& edit, const AlgorithmInput& input, Progress& progress);
AlgorithmResult add_icosahedron(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
