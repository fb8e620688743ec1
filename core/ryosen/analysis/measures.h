// Measures of elements: lengths, angles and areas of one, distances too between picked ones, and the volume inside. All
// on points, copies counting as one.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Units of measured values.
enum class MapUnit : std::uint8_t { none, length, area, degrees, per_length, per_area };  // of the unit of the file

// Behind the number: a degree sign; empty for plain numbers and for lengths, which are in the unit of the file.
inline std::string_view sign_of(MapUnit unit) { return unit == MapUnit::degrees ? "°" : ""; }

inline constexpr double degrees_per_radian = 57.295779513082321;

// The length of an edge; NaN where an end is not finite.
double edge_length(const Mesh& mesh, Edge e);
// The mean over all live edges whose length is finite; 0 where there is none. O(edges).
double mean_edge_length(const Mesh& mesh);
// To how many other points edges go.
std::uint32_t valence(const Mesh& mesh, Vertex v);

// The angle between the two faces of an edge through the body, in degrees from 0 to 360: 180 where they are flat, less
// at a ridge, more in a groove. NaN unless exactly two faces with area share it; the lowest sheet with a face answers.
double dihedral_angle_deg(Neighbourhood& around, Edge e);

// The angles of a face's corners, in degrees: at a corner that points inwards more than 180. NaN where a side has no
// length or a place is not finite. O(corners).
struct CornerAngles {
  double smallest_deg, largest_deg;
};
CornerAngles corner_angles(Neighbourhood& around, Face f);

// The area of a face, projected along its normal.
double face_area(const Mesh& mesh, Face f);
// How far a face is from a regular one of as many corners: longest side times half the perimeter over the area, 1 for
// regular ones and the more the flatter. NaN without area and for faces with inner rings.
double aspect_ratio(const Mesh& mesh, Face f);
// The largest distance of a corner from the plane through their mean along the normal; 0 for triangles, NaN without
// normal.
double distance_from_plane(Neighbourhood& around, Face f);

struct MeasuredValue {
  Text name;
  MapUnit unit;
  double value;
};

// One element: length of an edge, area and perimeter of a face. Two: the shortest distance, and of edges and faces the
// angle. Three vertices: the angle at the second, and the sides next to it. Any other number: length of all edges, and
// area, perimeter (sides with a face of them on one side alone) of all faces, and the volume where they close.
struct Measurement {
  std::vector<MeasuredValue> values;  // empty where nothing can be measured, or a place is not finite
  std::vector<glm::dvec3> path;       // to be drawn: none, or two places and more
};
// The elements are alive. Two faces cost the product of their triangles, all else its corners.
Measurement measure(const Mesh& mesh, std::span<const Element> elements);

}  // namespace ryosen
