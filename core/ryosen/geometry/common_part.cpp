#include "ryosen/geometry/common_part.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace ryosen {

namespace {

using Triangle = std::array<glm::dvec3, 3>;

glm::dvec3 normal_of(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

// Where a triangle lies in the plane through a point: the ends of a segment, or nothing.
std::vector<glm::dvec3> cut_by_plane(const Triangle& t, const glm::dvec3& point, const glm::dvec3& normal) {
  std::array<double, 3> height;
  for (std::size_t k = 0; k < 3; ++k) height[k] = glm::dot(t[k] - point, normal);
  std::vector<glm::dvec3> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (height[k] == 0)
      ends.push_back(t[k]);
    else if ((height[k] < 0) != (height[next] < 0) && height[next] != 0)
      ends.push_back(t[k] + height[k] / (height[k] - height[next]) * (t[next] - t[k]));
  }
  return ends;
}

}  // namespace

Box box_of_common_part(const Triangle& a, const Triangle& b) {
  const glm::dvec3 normal_a = normal_of(a), normal_b = normal_of(b), along = glm::cross(normal_a, normal_b);
  constexpr double flat = 1e-9;  // the sine of the angle between planes
  if (!(glm::length(along) > flat * glm::length(normal_a) * glm::length(normal_b))) {
    const Box box_a = box_of(a), box_b = box_of(b);
    return {glm::max(box_a.lowest, box_b.lowest), glm::min(box_a.highest, box_b.highest)};
  }
  std::vector<glm::dvec3> of_a = cut_by_plane(a, b[0], normal_b), of_b = cut_by_plane(b, a[0], normal_a);
  if (of_a.empty() || of_b.empty()) return {};
  const auto is_before = [&](const glm::dvec3& p, const glm::dvec3& q) {
    return glm::dot(p, along) < glm::dot(q, along);
  };
  const auto [low_a, high_a] = std::minmax_element(of_a.begin(), of_a.end(), is_before);
  const auto [low_b, high_b] = std::minmax_element(of_b.begin(), of_b.end(), is_before);
  Box box;
  box.add(std::max(*low_a, *low_b, is_before));
  box.add(std::min(*high_a, *high_b, is_before));
  return box;
}

}  // namespace ryosen
