#include "ryosen/algo/repair/folded_patch.h"

#include <numeric>

#include "ryosen/algo/repair/projected_patch.h"
#include "ryosen/analysis/overlap_tree.h"
#include "ryosen/geometry/place_order.h"

namespace ryosen {

namespace {

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
