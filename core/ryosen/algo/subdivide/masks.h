// The masks of the schemes: where vertices come to in one step, and where they lie on the limit surface.
//
// All at sharp edges, boundaries and corners are those of creases.h; what is drawn here and in masks.cpp is for smooth
// ones. Weights are applied before sums are formed, so that coordinates near the largest double do not overflow. Costs
// are those of walking around every vertex once, on several threads; the results are the same for any number.
#pragma once

#include <vector>

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/algo/subdivide/level_links.h"
#include "ryosen/algo/subdivide/subdivide.h"

namespace ryosen::subdivide {

using Places = std::vector<glm::dvec3>;

// The vertices of the sqrt(3) scheme on triangles [Kobbelt00] that are there before a step; new ones are the means of
// the faces.
//
//      a---a
//     /     \      a = (4 - 2 cos(2 pi/n)) / (9 n), in the middle 1 - n a
//    a   v   a     limit: 3 a / (1 + 3 n a) in place of a
//     \     /
//      a---a       crease: (4 19 4)/27 where the step cuts its edges in three (`cuts_creases`), else it stays
void sqrt3_places(const Mesh& mesh, const Creases& creases, bool cuts_creases, Places& places);
// On a crease from a to b the new vertex nearer to a: (1 16 10)/27 with what lies before a on the crease, (2 1)/3 at
// its end.
glm::dvec3 third_of_crease(const Mesh& mesh, const Creases& creases, Vertex a, Vertex b);

// By scheme, but for sqrt(3): of vertices, edges and living faces, as `numbers` has them.
Places split_places(const Mesh& mesh, const Creases& creases, Scheme scheme, const SplitNumbers& numbers);
// By scheme, but for midpoint, of which all vertices stay: where vertices come to in the end.
Places limit_places(const Mesh& mesh, const Creases& creases, Scheme scheme);

}  // namespace ryosen::subdivide
