// Warning for operators that increase the number of face fans at a point (a pinch): legal but doubtful.
//
//      \ f |
//     f \ | /  g        the fans of a point are the groups of its faces (over all copies) that are connected through
//        p              edges there, whatever their direction and number of faces
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/base/verdict.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The points that get more fans by a new face on a loop of points. Cost: the one-rings of its points.
std::vector<Vertex> pinched_by_face(const Mesh& mesh, std::span<const std::uint32_t> loop);

// The points that keep other faces, in more fans than before, when these faces (ascending) are removed. `apart`: they
// are detached instead of removed, and their fans count too. Cost: the one-rings of their points.
std::vector<Vertex> pinched_without(const Mesh& mesh, std::span<const Face> faces, bool apart = false);

// The points that after welding have more fans than either of the two before. Pairs: removed, remaining; returns the
// remaining. Cost: their one-rings.
std::vector<Vertex> pinched_by_weld(const Mesh& mesh, std::span<const std::pair<Vertex, Vertex>> pairs);

// What to warn of where a face comes to lie in the cycle of outside halfedges.
std::vector<Reason> warnings_of_face_in(const Mesh& mesh, Halfedge outside);

// Adds the warning if there are any.
void warn_of_pinch(const std::vector<Vertex>& points, std::vector<Reason>& reasons);

}  // namespace ryosen
