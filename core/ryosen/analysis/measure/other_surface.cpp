#include "ryosen/analysis/measure/other_surface.h"

#include <limits>

#include "ryosen/analysis/measure/cell_bound.h"
#include "ryosen/geometry/is_finite.h"

namespace ryosen {

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
