// Preview of an operator: its verdict, and the resulting faces to draw as a ghost.
#pragma once

#include <utility>
#include <vector>

#include "ryosen/base/verdict.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/all.h"

namespace ryosen {

// A face that would be new or different, as it would lie.
struct GhostFace {
  Face face;
  FacePolygon polygon;
  std::vector<Vertex> vertices = {};  // of its corners
};

struct Preview {
  Verdict verdict;
  // Only if legal. Over the limit only those of the operator itself. Intersecting faces are searched up to the limit of
  // crossings_near.
  std::vector<Reason> warnings;
  std::vector<GhostFace> faces;  // empty if refused or over the limit
  std::vector<Element> created;
  std::vector<Element> deleted;
  bool outline_only = false;  // over the limit: `faces` was not filled
};

// Checks the operator and, if legal, runs it in an Edit that is rolled back: the mesh is byte-equal afterwards and the
// redo list untouched. What fills a cycle (Subject::cycle) is shown from its lowest halfedge, whichever was asked
// about, so that each of its edges shows the same. Cost: the operator and the faces it changes.
Preview preview(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit = 10000);

// Pairs of different points at one place that are corners of one of the faces or joined by an edge at one of the
// vertices, the lower number first; ascending. With an isolated vertex any point may make a pair, where the mesh has at
// most 10,000 vertices. Vertices and faces that do not live are passed over.
using VertexPairs = std::vector<std::pair<Vertex, Vertex>>;
VertexPairs points_at_one_place(const Mesh& mesh, const std::vector<Face>& faces, const std::vector<Vertex>& vertices);

// The doubts about a result as it lies, whichever operator makes it: asked of every preview, so that an operator
// need not know of them. Of the changed faces as they would lie, beside the mesh as it is: corners on one line, a
// normal turned by 90 degrees or more, and sides that cross in the view along the normal (faces of up to 400 corners).
// What was so before is no news, nor is what `known` says already. Cost: the faces, squared in the corners of a face
// with more than three.
std::vector<Reason> shape_warnings(const Mesh& before, const std::vector<GhostFace>& after,
                                   const std::vector<Reason>& known);

}  // namespace ryosen
