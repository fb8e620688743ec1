// Creases: edges at which the surface bends.
#pragma once

#include "core/analysis/neighbourhood.h"

namespace ryosen {

// The cosine of 30 degrees, the angle from which on a bend is a crease.
inline constexpr double crease_cosine = 0.86602540378443865;

// Whether exactly two faces share the edge on points and their area normals differ by more than 30 degrees. Where the
// faces are turned against each other one normal is, so that the bend alone counts. A face without area or with a place
// that is not finite has no normal and no creases. The lowest sheet with a face answers for the edge.
bool is_crease(Neighbourhood& around, Edge e);

}  // namespace ryosen
