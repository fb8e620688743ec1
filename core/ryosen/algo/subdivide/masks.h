// The masks of the schemes: where vertices come to in one step, and where they lie on the limit surface.
//
// All at sharp edges, boundaries and corners are those of creases.h; what is drawn here is for smooth ones. Weights are
// applied before sums are formed, so that coordinates near the largest double do not overflow. Costs are those of
// walking around every vertex once, on several threads; the results are the same for any number.
#pragma once

#include <vector>

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/algo/subdivide/split_links.h"
#include "ryosen/algo/subdivide/subdivide.h"

namespace ryosen::subdivide {

using Places = std::vector<glm::dvec3>;

// Loop's scheme on triangles [Loop87]: `places` gets those of the old vertices, then one for each edge.
//
//        1                b--b
//       / \              /    \        b = (5/8 - (3/8 + cos(2 pi/n)/4)^2) / n, in the middle 1 - n b
//      3-x-3  / 8       b  v  b
//       \ /              \    /
//        1                b--b         limit: b' = 1 / (n + 3 / (8 b)) in place of b
void loop_places(const Mesh& mesh, const Creases& creases, Places& places);
Places loop_limit(const Mesh& mesh, const Creases& creases);

// Catmull's and Clark's scheme on polygons [Catmull78]: those of the old vertices, of the edges, then of the living
// faces.
//
//      o---o            f        face: the mean f of its corners
//      | f |         a--x--b     edge: (a + b + f + g) / 4
//      o---o            g        vertex of valence n: (Q + 2 R + (n - 3) v) / n, Q the mean of the faces, R of the
//                                middles of the edges
//   limit, of a mesh of quads: (n n v + 4 sum of the neighbours + sum of the vertices across the quads) / (n (n + 5))
void catmull_clark_places(const Mesh& mesh, const Creases& creases, const std::vector<std::uint32_t>& centre_of,
                          Places& places);
Places catmull_clark_limit(const Mesh& mesh, const Creases& creases);

// Every vertex stays; new ones lie in the middle of edges and, `with_centres`, at the mean of the corners of faces.
void midpoint_places(const Mesh& mesh, const std::vector<std::uint32_t>& centre_of, bool with_centres, Places& places);

// The vertices of the sqrt(3) scheme on triangles [Kobbelt00] that are there before a step; new ones are the means of
// the faces.
//
//      a---a
//     /     \      a = (4 - 2 cos(2 pi/n)) / (9 n), in the middle 1 - n a
//    a   v   a     limit: 3 a / (1 + 3 n a) in place of a
//     \     /
//      a---a       crease: (4 19 4)/27 where the step cuts its edges in three (`cuts_creases`), else it stays
void sqrt3_places(const Mesh& mesh, const Creases& creases, bool cuts_creases, Places& places);
Places sqrt3_limit(const Mesh& mesh, const Creases& creases);
// On a crease from a to b the new vertex nearer to a: (1 16 10)/27 with what lies before a on the crease, (2 1)/3 at
// its end.
glm::dvec3 third_of_crease(const Mesh& mesh, const Creases& creases, Vertex a, Vertex b);

// By scheme, but for sqrt(3): of vertices, edges and living faces, as `numbers` has them.
Places split_places(const Mesh& mesh, const Creases& creases, Scheme scheme, const SplitNumbers& numbers);
// By scheme, but for midpoint, of which all vertices stay: where vertices come to in the end.
Places limit_places(const Mesh& mesh, const Creases& creases, Scheme scheme);

}  // namespace ryosen::subdivide
