// What is doubtful about a result as it lies, whichever operator makes it: asked of every preview, so that an operator
// need not know of it.
#pragma once

#include <utility>
#include <vector>

#include "ryosen/base/verdict.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

// A face that would be new or different, as it would lie.
struct GhostFace {
  Face face;
  FacePolygon polygon;
  std::vector<Vertex> vertices = {};  // of its corners
};

// Pairs of different points at one place that are corners of one of the faces or joined by an edge at one of the
// vertices, the lower number first; ascending. With an isolated vertex any point may make a pair, where the mesh has at
// most 10,000 vertices. Vertices and faces that do not live are passed over.
using PointPairs = std::vector<std::pair<Vertex, Vertex>>;
PointPairs points_at_one_place(const Mesh& mesh, const std::vector<Face>& faces, const std::vector<Vertex>& vertices);

// Of the changed faces as they would lie, beside the mesh as it is: corners on one line, a normal turned by 90 degrees
// or more, and sides that cross in the view along the normal (faces of up to 400 corners). What was so before is no
// news, nor is what `known` says already. Cost: the faces, squared in the corners of a face with more than three.
std::vector<Reason> shape_warnings(const Mesh& before, const std::vector<GhostFace>& after,
                                   const std::vector<Reason>& known);

}  // namespace ryosen
