// A face that would be new or different, as it would lie.
#pragma once

#include "core/mesh/face_polygon.h"

namespace ryosen {

struct GhostFace {
  Face face;
  FacePolygon polygon;
};

}  // namespace ryosen
