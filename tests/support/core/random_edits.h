// Random edits of a mesh, of one or two steps, by operators and below them.
#pragma once

#include <functional>
#include <optional>

#include "ryosen/mesh/edit.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

// The mesh of random_mesh().
Mesh random_kernel_mesh(std::uint64_t seed);

// One committed edit (a moved point, a face taken out, an operator on an edge, all faces oriented), if the dice find a
// legal one.
bool edit_at_random(Mesh& mesh, Journal& journal, Dice& dice);

// One step of a random walk, by dice of so many sides: the first is an undo, the second a redo, where there is one; any
// other throw is given to `edit`, which says whether it has committed one. The transaction that was made, undone or
// redone; none where nothing was.
std::optional<std::size_t> random_step(Mesh& mesh, Journal& journal, Dice& dice, int sides,
                                       const std::function<bool(int thrown)>& edit);

}  // namespace ryosen::test
