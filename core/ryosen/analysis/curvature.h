// How a mesh bends at its vertices: the curvatures of the smooth surface that its points are taken to lie on.
//
// A polynomial height over the tangent plane is fitted to the points of two rings of edges by least squares [Cazals05].
// Where these points are those of a smooth surface the error falls with the square of their spacing h, whatever the
// triangles look like; at boundaries, where points lie on one side only, and at few points, with h. What is known of
// areas and angles alone does not converge on irregular meshes. In the tangent plane a point counts as far away as it
// is in space: of a sphere the height is the square of that over the diameter, so that coarse meshes of round things
// are right, too.
#pragma once

#include <limits>
#include <optional>

#include "ryosen/analysis/neighbourhood.h"

namespace ryosen {

// Along the two directions in which a surface bends least and most, as 1 over the radius of the circle: above 0 where
// it bends away from its normals, as a ball does, below 0 in hollows.
struct Curvature {
  double smallest = std::numeric_limits<double>::quiet_NaN(), largest = std::numeric_limits<double>::quiet_NaN();

  double mean() const { return 0.5 * smallest + 0.5 * largest; }
  double gaussian() const { return smallest * largest; }
};

// Of polynomials of the third degree where the points determine one, else of the second, else of the second with the
// plane across the mean normal as tangent. Not a number where there is no one surface to speak of: without faces, at
// points with copies or several fans, next to places that are not finite, and where points are too few even then (a
// single triangle) or lie on a line. It reads two rings of edges, but of a neighbour of high valence only the edges
// near this vertex. Cost: the valence.
Curvature curvature_at(Neighbourhood& around, Vertex v);

}  // namespace ryosen
