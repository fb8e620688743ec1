// Edges that a surface is told by: creases, at which it bends, and seams, at which what the corners of two faces carry
// does not go together.
#pragma once

#include "ryosen/analysis/neighbourhood.h"

namespace ryosen {

// The cosine of 30 degrees, the angle from which on a bend is a crease.
inline constexpr double crease_cosine = 0.86602540378443865;

// The cosine of the angle between the area normals of the faces at two sides of an edge on points. Where the faces are
// turned against each other one normal is, so that the bend alone counts. 1 for two sides of one face, and where a face
// has no normal: without area or with a place that is not finite.
double cosine_of_bend(Neighbourhood& around, Halfedge a, Halfedge b);

// Whether exactly two faces share the edge on points and it bends by more than an angle. The lowest sheet with a face
// answers for the edge.
bool bends(Neighbourhood& around, Edge e, double cosine_of_angle);
// By more than 30 degrees.
inline bool is_crease(Neighbourhood& around, Edge e) { return bends(around, e, crease_cosine); }

// Whether exactly two faces share the edge on points and the values of their corners (texture coordinates, normals)
// differ at one of its ends. The lowest sheet with a face answers for the edge.
bool is_seam_edge(Neighbourhood& around, Edge e);

}  // namespace ryosen
