// Whether the surface hides a place from the eye.
#pragma once

#include "ryosen/geometry/ray.h"
#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Whether no surface in the tree but that of `own`, and of the faces that are passed over, lies clearly in front of a
// place, which the ray goes through.
bool is_seen(const Bvh& tree, const Mesh& mesh, const Ray& ray, const glm::dvec3& place, Face own = {},
             const IndexSet* passed_over = nullptr);

}  // namespace ryosen
