// A face that would be new or different, as it would lie.
#pragma once

#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

struct GhostFace {
  Face face;
  FacePolygon polygon;
  std::vector<Vertex> vertices = {};  // of its corners
};

}  // namespace ryosen
