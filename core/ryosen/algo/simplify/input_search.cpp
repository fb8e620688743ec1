#include "ryosen/algo/simplify/input_search.h"

#include <algorithm>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "ryosen/geometry/closest.h"

namespace ryosen {

// None where there is no triangle.
std::optional<InputSearch::Near> InputSearch::from_triangle(const glm::dvec3& place, Halfedge corner) const {
  const Halfedge next = input_.next(corner), prev = input_.prev(corner);
  if (!input_.face(corner) || input_.next(next) != prev) return std::nullopt;
  const glm::dvec3 way =
      way_from_triangle(place_of(input_.from(corner)), place_of(input_.from(next)), place_of(input_.from(prev)), place);
  return Near{way, squared(way), 1};
}

InputSearch::Near InputSearch::nearest(const glm::dvec3& place, Halfedge corner, double enough) const {
  constexpr std::size_t most_asked = 4096;
  const std::optional<Near> first = from_triangle(place, corner);
  if (!first) return {};
  Near nearest = *first;
  if (nearest.square <= enough) return nearest;
  std::vector<std::pair<double, Halfedge>> waiting{{nearest.square, corner}};  // a heap, the nearest on top
  std::unordered_set<Face> seen{input_.face(corner)};
  while (!waiting.empty() && seen.size() < most_asked && nearest.square > enough) {
    std::pop_heap(waiting.begin(), waiting.end(), std::greater<>());
    const auto [square, here] = waiting.back();
    waiting.pop_back();
    if (square > 4 * nearest.square) break;
    for (const Halfedge side : {here, input_.next(here), input_.prev(here)}) {
      const Halfedge over = twin(side);
      if (!input_.face(over) || !seen.insert(input_.face(over)).second) continue;
      const std::optional<Near> found = from_triangle(place, over);
      if (!found) continue;
      if (found->square < nearest.square) nearest = *found;
      waiting.emplace_back(found->square, over);
      std::push_heap(waiting.begin(), waiting.end(), std::greater<>());
    }
  }
  nearest.asked = seen.size();
  return nearest;
}

}  // namespace ryosen
