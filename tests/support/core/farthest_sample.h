// How far a triangle is from targets that have bounds, by dense samples and slow distances.
#pragma once

#include <vector>

#include "ryosen/algo/simplify/near_proof.h"

namespace ryosen::test {

// The largest distance of its samples, k along each side, where that of a target is added to the target's bound.
double farthest_sample(const TriangleCorners& triangle, const std::vector<NearTarget>& targets, int k);

}  // namespace ryosen::test
