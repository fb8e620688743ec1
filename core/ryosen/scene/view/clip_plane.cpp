#include "ryosen/scene/view/clip_plane.h"

#include <algorithm>

namespace ryosen {

Ray kept(const Ray& ray, const std::optional<ClipPlane>& plane) {
  Ray part = ray;
  if (!plane) return part;
  const double begin = plane->beyond(ray.origin), along = glm::dot(plane->normal, ray.direction);
  if (along == 0) {
    if (begin > 0) part.t_max = -1;
    return part;
  }
  const double meets = -begin / along;
  if (along > 0)
    part.t_max = std::min(part.t_max, meets);
  else
    part.t_min = std::max(part.t_min, meets);
  return part;
}

std::optional<KeptPart> kept(const glm::dvec3& a, const glm::dvec3& b, const std::optional<ClipPlane>& plane) {
  KeptPart part{0, 1};
  if (!plane) return part;
  const double from = plane->beyond(a), to = plane->beyond(b);
  if (from > 0 && to > 0) return std::nullopt;
  if (from > 0) part.first = from / (from - to);
  if (to > 0) part.last = from / (from - to);
  return part;
}

}  // namespace ryosen
