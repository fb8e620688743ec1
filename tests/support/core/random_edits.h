// Random edits of a mesh, of one or two steps, by operators and below them.
#pragma once

#include "core/mesh/edit.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

// The mesh of random_mesh().
Mesh random_kernel_mesh(std::uint64_t seed);

// One committed edit (a moved point, a face taken out, an operator on an edge, all faces oriented), if the dice find a
// legal one.
bool edit_at_random(Mesh& mesh, Journal& journal, Dice& dice);

}  // namespace ryosen::test
