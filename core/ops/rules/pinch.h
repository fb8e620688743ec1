// Where an operator lets more fans of faces meet at a point than met there: legal, and worth a warning.
//
//      \ f |
//     f \ | /  g        the fans of a point are the groups in which its faces, those of all its copies, hang together by
//        p              the edges there, whatever their direction and however many faces they have
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/verdict.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// The points of which each has more fans once there is a face on a loop of points. Cost: the stars of its points.
std::vector<Vertex> pinched_by_face(const Mesh& mesh, std::span<const std::uint32_t> loop);

// The points that keep other faces, in more fans than now, once these faces (ascending) are gone. `apart`: they are not
// gone but keep together at points of their own, and their fans count too. Cost: the stars of their points.
std::vector<Vertex> pinched_without(const Mesh& mesh, std::span<const Face> faces, bool apart = false);

// The points that have more fans than any of the two that become one, by pairs of points: goes, stays. Named by the one
// that stays. Cost: their stars.
std::vector<Vertex> pinched_by_weld(const Mesh& mesh, std::span<const std::pair<Vertex, Vertex>> pairs);

// Adds the warning where there are any.
void warn_of_pinch(const std::vector<Vertex>& points, std::vector<Reason>& reasons);

}  // namespace ryosen
