// Moves of vertices that bring a simplified surface nearer to what it was before.
//
//        o  o                  . a sample of the input, o one that lies off the face of now that it is nearest to: each
//     o  __v__  o              pulls the corners of that face towards it, by what they share in its place there
//    .--'     '--.
//   /             \            [Hoppe93], by planes across the distances; step by step.
#pragma once

#include "ryosen/algo/simplify/near_samples.h"
#include "ryosen/algo/simplify/vertex_mover.h"

namespace ryosen {

// Moves vertices amid the surface to where the squared distance of the samples of the input from it, summed over their
// areas, is less: a few steps, in each all at once. Where a tree of the input is given, of the surface from the input
// too, and more steps. What holds collapses holds moves (vertex_mover.h). The same for any number of threads.
// `merged` as of NearSamples::assign(). Cost: as of that.
NearerMoves move_nearer(Edit& edit, CollapseSurface& surface, NearSamples& samples, std::span<const Vertex> merged,
                        const TriangleTree* input, DistanceGuard* guard, Progress& progress);

}  // namespace ryosen
