#include "ryosen/algo/simplify/remaining_edges.h"

#include <algorithm>
#include <tuple>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

namespace {

struct Sheet {
  std::uint32_t a, b;  // its points
  std::uint32_t edge;
};

// The sheets of edges whose points have several, those of an edge one after the other.
std::vector<Sheet> sheets_of(const Mesh& mesh, std::span<const std::uint8_t> rules) {
  std::vector<Sheet> sheets;
  for (std::uint32_t i = 0; i < rules.size(); ++i) {
    const Halfedge h = halfedge(Edge(i));
    if (rules[i] == no_rule || !has_copies(mesh, mesh.from(h)) || !has_copies(mesh, mesh.to(h))) continue;
    const std::uint32_t a = point(mesh, mesh.from(h)).index, b = point(mesh, mesh.to(h)).index;
    sheets.push_back({std::min(a, b), std::max(a, b), i});
  }
  std::sort(sheets.begin(), sheets.end(),
            [](const Sheet& x, const Sheet& y) { return std::tie(x.a, x.b, x.edge) < std::tie(y.a, y.b, y.edge); });
  return sheets;
}

// Calls visit(sheets) for each edge of several.
template <class Visit>
void for_each_edge_of(std::span<const Sheet> sheets, Visit visit) {
  for (std::size_t begin = 0, end = 0; begin < sheets.size(); begin = end) {
    while (end < sheets.size() && sheets[end].a == sheets[begin].a && sheets[end].b == sheets[begin].b) ++end;
    visit(sheets.subspan(begin, end - begin));
  }
}

}  // namespace

std::vector<std::uint8_t> find_remaining(const Mesh& mesh, const Simplifier& simplifier, Progress& progress) {
  std::vector<std::uint8_t> rules(mesh.edge_slots(), no_rule);
  const CollapseSurface::Standstill still = simplifier.standstill();
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (i % 256 == 0 && !progress.go_on()) return rules;
    if (const Edge e(i); mesh.is_alive(e) && !mesh.is_wire(e) && !is_bridge(mesh, halfedge(e)))
      rules[i] = static_cast<std::uint8_t>(simplifier.rule_of(e));
  }
  const std::vector<Sheet> sheets = sheets_of(mesh, rules);
  for_each_edge_of(sheets, [&](std::span<const Sheet> edge) {
    std::uint8_t first = no_rule;
    for (const Sheet& sheet : edge) first = std::min(first, rules[sheet.edge]);
    for (const Sheet& sheet : edge) rules[sheet.edge] = first;
  });
  return rules;
}

std::vector<std::size_t> count_remaining(const Mesh& mesh, std::span<const std::uint8_t> rules) {
  std::vector<std::size_t> counts(edge_rule_table().size());
  for (const std::uint8_t rule : rules)
    if (rule != no_rule) ++counts[rule];
  const std::vector<Sheet> sheets = sheets_of(mesh, rules);
  for_each_edge_of(sheets, [&](std::span<const Sheet> edge) { counts[rules[edge[0].edge]] -= edge.size() - 1; });
  return counts;
}

}  // namespace ryosen
