#include "ryosen/algo/features.h"

#include <tuple>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

bool ends_a_wire_or_fan(const Mesh& mesh, Vertex v) {
  if (!mesh.is_boundary(v)) return false;
  std::uint32_t gaps = 0;
  for (const Halfedge h : outgoing(mesh, v)) {
    if (mesh.is_wire(edge(h))) return true;
    gaps += mesh.is_outside(h) ? 1u : 0u;
  }
  return gaps > 1;
}

SheetGroups sheet_groups(const Mesh& mesh) {
  SheetGroups groups;
  if (!mesh.has_copies()) return groups;
  using Sheet = std::tuple<Vertex, Vertex, Edge>;
  std::vector<Sheet> sheets;
  for (const Edge e : live_edges(mesh)) {
    if (mesh.is_wire(e)) continue;
    const auto [a, b] = ends(mesh, e);
    if (!has_copies(mesh, a) || !has_copies(mesh, b)) continue;
    const auto [low, high] = std::minmax({point(mesh, a), point(mesh, b)});
    sheets.emplace_back(low, high, e);
  }
  std::sort(sheets.begin(), sheets.end());
  for (std::size_t i = 0, k = 0; i < sheets.size(); i = k) {
    const auto is_same = [&](const Sheet& s) {
      return std::get<0>(s) == std::get<0>(sheets[i]) && std::get<1>(s) == std::get<1>(sheets[i]);
    };
    for (k = i; k < sheets.size() && is_same(sheets[k]);) ++k;
    if (k - i < 2) continue;
    for (std::size_t s = i; s < k; ++s) groups.edges.push_back(std::get<2>(sheets[s]));
    groups.ends.push_back(static_cast<std::uint32_t>(groups.edges.size()));
  }
  return groups;
}

}  // namespace ryosen
