#include "ryosen/hull/planar_hull.h"

#include <algorithm>
#include <numeric>

#include "ryosen/geometry/predicates.h"

namespace ryosen::hull {

std::vector<std::uint32_t> planar_hull(std::span<const glm::dvec2> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const glm::dvec2 &p = points[i], &q = points[j];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  std::vector<std::uint32_t> chain;
  const auto extend = [&](std::size_t first, std::uint32_t next) {
    while (chain.size() >= first + 2 &&
           orient2d(points[chain[chain.size() - 2]], points[chain.back()], points[next]) <= 0)
      chain.pop_back();
    chain.push_back(next);
  };
  for (const std::uint32_t i : order) extend(0, i);
  const std::size_t upper = chain.size() - 1;
  for (std::size_t i = order.size() - 1; i-- > 0;) extend(upper, order[i]);
  chain.pop_back();  // the first one again
  return chain;
}

}  // namespace ryosen::hull
