// One implicit step of smoothing: a sparse symmetric system, solved by conjugate gradients.
#pragma once

#include "ryosen/algo/smooth/laplacian.h"
#include "ryosen/base/progress.h"

namespace ryosen::smooth {

// Replaces the places of the points with a positive strength s by those p' with (D / s + D - W) p' = D / s p, where W
// are the weights and D their sums by rows [Desbrun99]; it is stable for any strength. All others stay and hold. At
// most `most_rounds` of conjugate gradients, preconditioned by the diagonal, to a residual of 1e-12; sums are formed in
// one order, so that the result does not depend on threads. Cancelled: false, and places are as they were.
bool implicit_step(const Laplacian& laplacian, std::span<const double> strength, Places& places, Progress& progress);

}  // namespace ryosen::smooth
