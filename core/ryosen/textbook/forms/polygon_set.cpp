#include "ryosen/textbook/forms/polygon_set.h"

#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

PolygonSet::PolygonSet(const Mesh& mesh) {
  const Polygons list = polygons_of(mesh, Numbering(mesh));
  polygons_.resize(list.face_count());
  for (std::uint32_t f = 0; f < list.face_count(); ++f)
    for (const Vertex v : vertices_of(list, Face(f))) polygons_[f].push_back(list.positions[v.index]);
}

std::size_t PolygonSet::bytes() const {
  std::size_t bytes = bytes_of(polygons_);
  for (const std::vector<glm::dvec3>& polygon : polygons_) bytes += bytes_of(polygon);
  return bytes;
}

Mesh PolygonSet::to_mesh() const { return mesh_from_places(polygons_); }

Fields PolygonSet::record(Element own) const {
  if (own.kind != Element::Kind::face) return {};
  return {places("頂点座標", polygons_[own.index])};
}

}  // namespace ryosen::forms
