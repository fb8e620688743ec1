// Puts a point into an edge: what split and separate_edge share.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

// The halfedges that one split of an edge from A to B cuts, from a copy of A to a copy of B, the one with the lowest
// face first.
std::vector<Halfedge> sheets_of_edge(const Mesh& mesh, Halfedge h);

// Warns of a number that does not lie between 0 and 1.
void warn_of_place(Halfedge h, double along, std::vector<Reason>& reasons);

// Inserts a point into all sheets of an edge, with or without cutting the triangles there.
enum class CutTriangles { no, yes };
void put_point_into(Edit& edit, Halfedge h, double along, CutTriangles cut, OpEffect& effect);
// The same at another place, with the values of that point of the edge.
void put_point_into(Edit& edit, Halfedge h, double along, const glm::dvec3& place, CutTriangles cut, OpEffect& effect);

}  // namespace ryosen
