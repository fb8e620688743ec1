// One place of an element, in its middle.
#pragma once

#include <glm/vec3.hpp>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// On the element: of a face the middle of one of its triangles, so that it lies on it though that is not convex. Cost:
// of a face its triangulation, else O(1).
glm::dvec3 middle_of(const Mesh& mesh, const Element& element);

}  // namespace ryosen
