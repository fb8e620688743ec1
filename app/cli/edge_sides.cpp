#include "app/cli/edge_sides.h"

#include <algorithm>

#include "ryosen/mesh/copies.h"

namespace ryosen::cli {

std::vector<EdgeSide> find_edge_sides(const Mesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(mesh.live().edges);
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    Halfedge h = halfedge(Edge(i));
    Vertex a = point(mesh, mesh.from(h)), b = point(mesh, mesh.to(h));
    if (b < a) {
      std::swap(a, b);
      h = twin(h);
    }
    if (!is_cut_on_points(mesh, h)) {
      sides.push_back({a, b, Face(), h});
      continue;
    }
    for (Face f : {mesh.face(h), mesh.face(twin(h))})
      if (f) sides.push_back({a, b, f, h});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::string name_of(const EdgeSide& side, bool reversed) {
  std::string name = std::to_string((reversed ? side.b : side.a).index) + "-";
  name += std::to_string((reversed ? side.a : side.b).index);
  if (side.face) name += "@f" + std::to_string(side.face.index);
  return name;
}

}  // namespace ryosen::cli
