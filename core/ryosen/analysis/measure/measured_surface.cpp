#include "ryosen/analysis/measure/measured_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/analysis/measure/cell_bound.h"
#include "ryosen/analysis/surface_triangles.h"
#include "ryosen/geometry/is_finite.h"

namespace ryosen {

MeasuredSurface::MeasuredSurface(const Mesh& of) : mesh(&of) {
  const SurfaceTriangles surface(of);
  reserve_large(triangles, surface.slots());
  std::vector<bool> has_triangle(of.face_slots(), false);
  for (std::uint32_t slot = 0; slot < surface.slots(); ++slot) {
    const SurfaceTriangle t = surface.at(of, slot);
    if (t.face == no_index) continue;
    triangles.push_back(Primitive::triangle(t.corners[0], t.corners[1], t.corners[2], t.face));
    for (const std::uint32_t corner : t.corners) box.add(of.position(Vertex(corner)));
    has_triangle[t.face] = true;
  }
  faces = static_cast<std::size_t>(std::count(has_triangle.begin(), has_triangle.end(), true));
  left_out = of.live().faces - faces;
}

double MeasuredSurface::reach() const {
  if (is_empty()) return 0;
  const glm::dvec3 most = glm::max(glm::abs(box.lowest), glm::abs(box.highest));
  return std::max({most.x, most.y, most.z});
}

double scale_for(double largest) {
  constexpr int most = std::numeric_limits<double>::max_exponent - 1;  // a length may be less than its inverse holds
  return largest > 0 ? std::ldexp(1.0, std::min(-std::ilogb(largest) - 1, most)) : 1.0;
}

OtherSurface::OtherSurface(const Mesh& mesh) {
  const MeasuredSurface surface(mesh);
  if (surface.is_empty()) return;
  scale_ = scale_for(surface.reach());
  tree_ = surface.tree(scale_);
}

double OtherSurface::distance(const glm::dvec3& place) const {
  const glm::dvec3 scaled = place * scale_;
  if (tree_.is_empty() || !is_finite(scaled)) return std::numeric_limits<double>::quiet_NaN();
  return nearest_of(tree_, scaled, no_index).distance / scale_;
}

}  // namespace ryosen
