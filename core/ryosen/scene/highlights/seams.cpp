#include "ryosen/scene/highlights/seams.h"

#include "ryosen/mesh/attribute.h"

namespace ryosen {

bool is_seam_edge(Neighbourhood& around, Edge e) {
  const Mesh& mesh = around.mesh();
  if (mesh.attributes().empty()) return false;
  const auto [h, o] = around.two_sides(e);
  return h && corner_values_differ(mesh, h, o, around.run_alike(h, o));
}

}  // namespace ryosen
