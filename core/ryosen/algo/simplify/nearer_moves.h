// Moves of vertices that bring a simplified surface nearer to what it was before.
//
//        o  o                  . a sample of the input, o one that lies off the face of now that it is nearest to: each
//     o  __v__  o              pulls the corners of that face towards it, by what they share in its place there
//    .--'     '--.
//   /             \            [Hoppe93], by planes across the distances; step by step.
#pragma once

#include "ryosen/algo/simplify/distance_guard.h"
#include "ryosen/algo/simplify/near_samples.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

struct NearerMoves {
  std::size_t moves = 0;
  double error_max = 0;  // the largest of CollapseSurface::error_of_move()
};

// Moves vertices amid the surface to where the squared distance of the samples of the input from it, summed over their
// areas, is less: a few steps, in each all at once. Where a tree of the input is given, of the surface from the input
// too, and more steps. What holds collapses holds moves: nothing goes beyond the error, no face turns too far, loses
// its area or gets too small an angle, and where there is a guard, nothing is moved whose distance it cannot prove;
// it follows. Colours that take part in the error go along; other values stay. The same for any number of threads.
// `merged` as of NearSamples::assign(). Cost: as of that.
NearerMoves move_nearer(Edit& edit, CollapseSurface& surface, NearSamples& samples, std::span<const Vertex> merged,
                        const TriangleTree* input, DistanceGuard* guard, Progress& progress);

}  // namespace ryosen
