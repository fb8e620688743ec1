#include "ryosen/textbook/forms/triangle_soup.h"

#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

TriangleSoup::TriangleSoup(const Mesh& mesh) {
  const Polygons polygons = polygons_of(mesh, Numbering(mesh));
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f) {
    const std::uint32_t* corner = polygons.corners.data() + polygons.offsets[f];
    triangles_.push_back({polygons.positions[corner[0]], polygons.positions[corner[1]], polygons.positions[corner[2]]});
  }
}

std::size_t TriangleSoup::bytes() const { return bytes_of(triangles_); }

Mesh TriangleSoup::to_mesh() const { return mesh_from_places(triangles_); }

Fields TriangleSoup::record(Element own) const {
  if (own.kind != Element::Kind::face) return {};
  const auto& triangle = triangles_[own.index];
  return {places("x1, y1, z1, x2, y2, z2, x3, y3, z3", {triangle.begin(), triangle.end()})};
}

}  // namespace ryosen::forms
