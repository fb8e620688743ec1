#include "ryosen/algo/repair/folded_patch.h"

#include <glm/geometric.hpp>
#include <numeric>

#include "ryosen/algo/repair/hole_loop.h"
#include "ryosen/analysis/box_tree.h"
#include "ryosen/analysis/overlap_tree.h"
#include "ryosen/geometry/place_order.h"
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

// Whether the patch, seen along the axis nearest to its loop's normal, covers each point once: all its triangles are
// seen from the same side, and the loop is a simple polygon. Exact; such a patch nowhere meets itself but at shared
// corners and sides. O(n log n) and the overlaps of boxes of the loop's sides.
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

// The triangles, with corners at one place numbered alike.
NumberedSurface surface_of(const HolePatch& patch) {
  std::vector<std::uint32_t> order(patch.corners), number(patch.places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return is_before(patch.places[a], patch.places[b]); });
  std::iota(number.begin(), number.end(), 0u);
  for (std::uint32_t i = 1; i < patch.corners; ++i)
    if (patch.places[order[i]] == patch.places[order[i - 1]]) number[order[i]] = number[order[i - 1]];
  std::vector<std::array<std::uint32_t, 3>> corners;
  for (const CornerTriangle& t : patch.triangles) corners.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return NumberedSurface(patch.places, std::move(corners));
}

}  // namespace

bool crosses_itself(const HolePatch& patch) {
  if (covers_once_in_projection(patch)) return false;
  const NumberedSurface surface = surface_of(patch);
  const OverlapTree tree(surface, 1);
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  for (std::uint32_t node = 0; node < tree.node_count(); ++node) {
    const bool is_clear = tree.visit_pairs(node, all, [&](std::uint32_t a, std::uint32_t b) {
      return !meet_elsewhere(surface.triangle(a), surface.triangle(b));
    });
    if (!is_clear) return true;
  }
  return false;
}

}  // namespace ryosen
