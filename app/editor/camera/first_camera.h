// The camera of a mesh that was just opened.
#pragma once

#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/view/camera.h"

namespace ryosen {

// From the front, slightly above and right, so that three sides of most shapes are visible; to be fitted.
Camera first_camera();
// The same, but turned by as little as it takes where a small closed surface would show hardly more than one flat side,
// as if it were a single face.
Camera first_camera_of(const Mesh& mesh);

}  // namespace ryosen
