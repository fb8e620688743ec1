// Triangulation of a face without creating an edge that already exists.
#pragma once

#include <vector>

#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

// The triangles of a live face as corner numbers of its FacePolygon, n + 2h - 2 for n corners and h rings; the first
// one starts at corner 0 and contains the side that starts there. Empty if none were found. No new edge joins points
// that are already joined, and none is created twice.
//
// The drawn triangles (geometry/triangulate.h) are used if they satisfy this. Else, for a face without rings and
// bridges, dynamic programming finds the triangulation with the fewest inverted triangles, then the shortest edges:
// exact up to 400 corners, O(n^3). With rings a few of the shortest keyholes are tried. Beyond 400 corners nothing more
// is tried. A face with a non-finite coordinate is cut as if its loops were circles.
std::vector<CornerTriangle> triangles_of_face(const Mesh& mesh, const FacePolygon& face);

// The edges in the way: between corners of the face, but not its sides. O(sum of the valences).
std::vector<Edge> edges_across(const Mesh& mesh, const FacePolygon& face);

}  // namespace ryosen
