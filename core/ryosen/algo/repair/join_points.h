// Makes points one, with the edges that this closes.
#pragma once

#include <vector>

#include "ryosen/mesh/edit.h"

namespace ryosen {

// A class of points that become one, ascending, and the place they take. The lowest keeps its number.
struct JoinedPoints {
  std::vector<Vertex> points;
  glm::dvec3 place;
};

// The result is what reading the merged list of polygons gives. No face may visit two points of a class, and every
// class is manifold afterwards (PointMerger); points that end wires stay alone. Cost: O(k log k) for k corners at the
// points and their copies, however many meet at one of them, beside a pass over the vertices.
void join_points(Edit& edit, const std::vector<JoinedPoints>& classes);

}  // namespace ryosen
