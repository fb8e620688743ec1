// Meshes of growing size to measure on.
#pragma once

#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen::forms {

// Text 000's torus (figure 11: radii 70 and 30, two triangles to a square), of about half as many to twice as many
// circles and points on a circle: 56, 112, 224 ... faces up to `most_faces`; one of 896 is the figure itself.
std::vector<Mesh> growing_tori(std::size_t most_faces);

// A part of `faces` faces around the first one, from face to face across edges, in the order of the mesh: the points
// where only corners meet are cut, and faces with rings left out. Fewer where there are no more. O(mesh).
Mesh part_of(const Mesh& mesh, std::size_t faces);
// Parts of half as many faces each, the smallest one first: at most ten, the largest of all faces but at most
// `most_faces`, the others of at least 32.
std::vector<Mesh> growing_parts(const Mesh& mesh, std::size_t most_faces);

}  // namespace ryosen::forms
