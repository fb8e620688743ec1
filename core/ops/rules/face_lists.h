// Faces as lists of points, for rules that are about the list that comes out: does it come apart at its bridges, is
// there a face on the same points.
#pragma once

#include <span>
#include <vector>

#include "core/base/verdict.h"
#include "core/mesh/bridges.h"
#include "core/mesh/copies.h"
#include "core/mesh/rings.h"

namespace ryosen {

// The points along a cycle of `next` from `start`, each by the number that names it.
std::vector<std::uint32_t> points_along(const Mesh& mesh, Halfedge start);
// The loops of a face, the outer one first.
CornerLoops loops_of(const Mesh& mesh, Face f);

// How many edges the lists walk both ways; they must come apart there.
std::size_t bridges_of(const CornerLoops& loops);

// Whether a face has neither rings nor bridges. O(corners).
bool is_one_simple_loop(const Mesh& mesh, Face f);
// Refuses a face that is not one simple loop. Witnesses: the face, the sides of its rings, its bridges; so the fewer
// there are, the nearer it is to one.
void refuse_rings(const Mesh& mesh, Face f, Verdict& verdict);

// The different points of some lists, ascending: what equal faces have in common.
std::vector<std::uint32_t> point_set(std::span<const std::uint32_t> corners);
// A face on exactly these points (ascending), or none; `except` are left out. Cost: the smallest star of the points and
// the corners of the faces there that have as many.
Face face_on(const Mesh& mesh, std::span<const std::uint32_t> points, std::span<const Face> except = {});
// Another face on the points of f, or none.
Face equal_face(const Mesh& mesh, Face f);

}  // namespace ryosen
