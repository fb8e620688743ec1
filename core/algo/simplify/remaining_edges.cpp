#include "core/algo/simplify/remaining_edges.h"

#include <algorithm>
#include <tuple>

#include "core/mesh/copies.h"
#include "core/mesh/rings.h"

namespace ryosen {

std::vector<std::size_t> count_remaining(const Mesh& mesh, const Simplifier& simplifier) {
  std::vector<std::size_t> counts(edge_rules.size());
  struct Sheet {
    std::uint32_t a, b;  // its points
    EdgeRule rule;
  };
  std::vector<Sheet> sheets;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    const Edge e(i);
    const Halfedge h = halfedge(e);
    if (!mesh.is_alive(e) || mesh.is_wire(e) || is_bridge(mesh, h)) continue;
    const EdgeRule rule = simplifier.rule_of(e);
    const std::uint32_t a = point(mesh, mesh.from(h)).index, b = point(mesh, mesh.to(h)).index;
    if (has_copies(mesh, mesh.from(h)) && has_copies(mesh, mesh.to(h)))
      sheets.push_back({std::min(a, b), std::max(a, b), rule});
    else
      ++counts[static_cast<std::size_t>(rule)];
  }
  std::sort(sheets.begin(), sheets.end(),
            [](const Sheet& x, const Sheet& y) { return std::tie(x.a, x.b, x.rule) < std::tie(y.a, y.b, y.rule); });
  for (std::size_t i = 0; i < sheets.size(); ++i)
    if (i == 0 || sheets[i].a != sheets[i - 1].a || sheets[i].b != sheets[i - 1].b)
      ++counts[static_cast<std::size_t>(sheets[i].rule)];
  return counts;
}

}  // namespace ryosen
