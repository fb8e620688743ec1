// Which triangles a face can be cut into without an edge that exists already.
#pragma once

#include <vector>

#include "core/mesh/face_polygon.h"

namespace ryosen {

// The triangles of a live face as corner numbers of its FacePolygon, n + 2h - 2 for n corners and h rings; the first
// one begins at corner 0 and holds the side that begins there. Empty where none were found. New edges join no two
// points that an edge joins, nor two points twice.
//
// The drawn triangles (geometry/triangulate.h) are taken where they keep to that. Else a face without rings and bridges
// gets, of all ways to cut it, the one that turns the fewest triangles over, by shortest edges among these: exact up to
// 400 corners, O(n^3). With rings the shortest few ways to lead from loop to loop are tried; beyond 400 corners nothing
// more is. A face with a coordinate that is not finite is cut as if its loops were circles.
std::vector<CornerTriangle> triangles_of_face(const Mesh& mesh, const FacePolygon& face);

// The edges that stand in the way: between corners of the face, and none of its sides. O(sum of the valences).
std::vector<Edge> edges_across(const Mesh& mesh, const FacePolygon& face);

}  // namespace ryosen
