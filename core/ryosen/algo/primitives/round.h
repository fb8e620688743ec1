// The primitives that are round about the Y axis: sphere, cylinder, cone, torus.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Quads between circles of latitude, triangles at the poles.
AlgorithmResult add_sphere(Edit& edit, const AlgorithmInput& input, Progress& progress);
// Quads around; at each end one polygon, a fan of triangles, or nothing.
AlgorithmResult add_cylinder(Edit& edit, const AlgorithmInput& input, Progress& progress);
// Triangles around, the tip up; its base is as that of a cylinder.
AlgorithmResult add_cone(Edit& edit, const AlgorithmInput& input, Progress& progress);
// Quads. The tube must be thinner than the circle that it follows.
AlgorithmResult add_torus(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
