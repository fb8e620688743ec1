// Moves of vertices that bring nearer what lies farthest from the input.
//
//            v                      v has come to stand out; of the places where the surfaces lie farthest from each
//           /|\      .--o--.        other the farthest is brought nearer, the others as far as they are farther than
//     _____/ | \____/       \       what cannot be brought nearer
#pragma once

#include "ryosen/algo/simplify/near_samples.h"
#include "ryosen/algo/simplify/vertex_mover.h"

namespace ryosen {

// Moves vertices amid the surface, one after the other, to where the largest of these distances around each is less:
// those of the samples of the input at its faces from these, of itself and of the middles of its edges from the input.
// The mean square of those samples becomes at most twice as large. The farthest place comes first, and where one stays,
// all that are nearer stay. Vertices of many edges do not move, nor does anything where the input has faces that are
// not sampled. What holds collapses holds moves (vertex_mover.h). The samples are assigned, and stay so. The same for
// any number of threads. Cost: O(n) to find the places, of which those that may be far each take an InputSearch, and
// O(n) looks at samples and triangles to move.
NearerMoves move_farthest(Edit& edit, CollapseSurface& surface, const NearSamples& samples, const Mesh& input,
                          DistanceGuard* guard, Progress& progress);

}  // namespace ryosen
