// The rows of the algorithms of each folder. algorithm_table.cpp puts them together.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

const std::vector<AlgorithmRow>& repair_rows();  // take whole kinds of problems away at once
// Add a shape of a few numbers as a component of its own. Up is +Y, as the camera has it; `at` is its middle.
std::vector<AlgorithmRow> primitive_rows();
std::vector<AlgorithmRow> point_cloud_rows();  // random points: a primitive without faces
std::vector<AlgorithmRow> transform_rows();    // move points and leave the rest as it is
std::vector<AlgorithmRow> duplicate_rows();    // add copies of elements, mirrored or not
std::vector<AlgorithmRow> simplify_rows();
std::vector<AlgorithmRow> subdivision_rows();
std::vector<AlgorithmRow> smoothing_rows();
std::vector<AlgorithmRow> remeshing_rows();
std::vector<AlgorithmRow> hull_rows();  // add the convex hull beside what it is the hull of

}  // namespace ryosen
