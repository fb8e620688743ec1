// The normals of the limit surfaces, and the limit of darts.
#pragma once

#include <vector>

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/algo/subdivide/subdivide.h"

namespace ryosen::subdivide {

// Per halfedge with a face, of length 1: the normal of the limit surface of this level at the vertex where the halfedge
// begins, on the side of its face; 0 without a face and where the limit has no tangent plane. Loop's, Catmull and
// Clark's (on quads) and the sqrt(3) scheme. With the tangents' masks, the left eigenvectors of one step around the
// vertex [Halstead93]:
//
//   smooth  Loop, sqrt(3): sum of cos(2 pi i / n) p_i and of sin(2 pi i / n) p_i
//           Catmull-Clark: a cos(2 pi i / n) p_i + (cos(2 pi i / n) + cos(2 pi (i + 1) / n)) q_i, and with sines, where
//           a = 1 + cos(2 pi / n) + cos(pi / n) sqrt(2 (9 + cos(2 pi / n))), q_i across the quad between p_i and p_i+1
//   crease  on each side of it, p_1 to p_k from sharp edge to sharp edge: p_k - p_1, and across it weights
//           sin((i - 1) t), t = pi / (k - 1), within and such ones for p_1, p_k and v that it is a left eigenvector;
//           for k = 2 p_1 - 2 v + p_2
//   corner  in each sector between sharp edges p_1 - v and p_k - v
//   dart    that of the faces around after many steps
//   creases and boundaries of the sqrt(3) scheme: the mean of the normals of the faces around, weighted by their angles
//
// O(corners), on several threads; the same for any number.
std::vector<glm::dvec3> limit_normals(const Mesh& mesh, const Creases& creases, Scheme scheme);

// Where a vertex of Loop's or Catmull and Clark's scheme comes to that is the end of one sharp edge: the row of its
// step around it, taken so often that nothing changes any more. O(valence).
glm::dvec3 limit_of_dart(const Mesh& mesh, const Creases& creases, Vertex v, Scheme scheme);

// Gives every corner its normal, as the attribute `corner.normal`: equal ones at a vertex share their place in the
// pool.
void put_normals(MeshColumns& columns, const std::vector<glm::dvec3>& normals);

}  // namespace ryosen::subdivide
