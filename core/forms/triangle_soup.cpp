#include "core/forms/triangle_soup.h"

#include <map>

#include "core/forms/polygons.h"
#include "core/indexed/from_indexed.h"

namespace ryosen::forms {

TriangleSoup::TriangleSoup(const Mesh& mesh) {
  const Polygons polygons = polygons_of(mesh, Numbering(mesh));
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f) {
    const std::uint32_t* corner = polygons.corners.data() + polygons.offsets[f];
    triangles_.push_back({polygons.positions[corner[0]], polygons.positions[corner[1]], polygons.positions[corner[2]]});
  }
}

std::size_t TriangleSoup::bytes() const { return bytes_of(triangles_); }

Mesh TriangleSoup::to_mesh() const {
  IndexedMesh list;
  std::map<std::array<double, 3>, std::uint32_t> number;
  for (const auto& triangle : triangles_) {
    for (const glm::dvec3& p : triangle) {
      const auto [found, is_new] =
          number.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(list.positions.size()));
      if (is_new) list.positions.push_back(p);
      list.corners.push_back(found->second);
    }
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return from_indexed(std::move(list));
}

bool TriangleSoup::answer(Relation, std::uint32_t, Answer& out) const {
  out.clear();
  return false;
}

}  // namespace ryosen::forms
