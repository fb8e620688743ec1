// What there is to measure between picked elements: distances, angles, areas, and the volume inside.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/analysis/measures.h"
#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

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
