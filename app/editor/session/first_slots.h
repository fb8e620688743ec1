// What a command has added to a mesh.
#pragma once

#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The slots that were free before it.
class FirstSlots {
 public:
  explicit FirstSlots(const Mesh& mesh)
      : vertices_(mesh.vertex_slots()), edges_(mesh.edge_slots()), faces_(mesh.face_slots()) {}
  // New faces, edges without a face and isolated vertices: all that was added, each once.
  std::vector<Element> added_to(const Mesh& mesh) const;

 private:
  std::uint32_t vertices_, edges_, faces_;
};

}  // namespace ryosen
