#include "ryosen/algo/repair/projected_patch.h"

#include <glm/geometric.hpp>

#include "ryosen/analysis/box_tree.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

// For segments whose boxes overlap.
bool do_meet(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& a, const glm::dvec2& b) {
  return orient2d(p, q, a) * orient2d(p, q, b) <= 0 && orient2d(a, b, p) * orient2d(a, b, q) <= 0;
}

bool is_simple(const std::vector<glm::dvec2>& polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  const auto end = [&](std::uint32_t i) -> const glm::dvec2& { return polygon[i + 1 == n ? 0 : i + 1]; };
  std::vector<Box> boxes(n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const glm::dvec2& p : {polygon[i], end(i)}) boxes[i].add({p, 0});
  const BoxTree sides(boxes);
  for (std::uint32_t i = 0; i < n; ++i) {
    const glm::dvec2 &p = polygon[i], &q = end(i), &r = end(i + 1 == n ? 0 : i + 1);
    if (orient2d(p, q, r) == 0 && glm::dot(p - q, r - q) >= 0) return false;
    const bool is_clear = sides.visit([&](const Box& box) { return box.overlaps(boxes[i]); },
                                      [&](std::uint32_t k) {
                                        const bool is_beside = k == i || k == (i + 1) % n || i == (k + 1) % n;
                                        return is_beside || !do_meet(p, q, polygon[k], end(k));
                                      });
    if (!is_clear) return false;
  }
  return true;
}

}  // namespace

bool covers_once_in_projection(const HolePatch& patch) {
  const glm::dvec3 normal = glm::abs(polygon_normal(std::span(patch.places).first(patch.corners)));
  const int axis = normal.z >= normal.x && normal.z >= normal.y ? 2 : normal.y >= normal.x ? 1 : 0;
  const auto seen = [&](std::uint32_t v) { return seen_along(patch.places[v], axis); };
  int side = 0;
  for (const CornerTriangle& t : patch.triangles) {
    const int turn = orient2d(seen(t[0]), seen(t[1]), seen(t[2]));
    if (turn == 0 || turn * side < 0) return false;
    side = turn;
  }
  std::vector<glm::dvec2> polygon;
  for (std::uint32_t i = 0; i < patch.corners; ++i) polygon.push_back(seen(i));
  return is_simple(polygon);
}

}  // namespace ryosen
