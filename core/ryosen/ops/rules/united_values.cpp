#include "ryosen/ops/rules/united_values.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// Corner values of an attribute at both ends of a side, which become one.
struct MergedCorners {
  using Value = std::vector<std::uint32_t>;
  Value gone, kept, made;
};

// Corners that have the value of a side at one of its ends (so up to seams) get that of the side at `along`.
void merge_corners(Edit& edit, Halfedge h, double along) {
  const Mesh& m = edit.mesh();
  const std::vector<CornerAttribute> pooled = corner_attributes(m);
  for (std::size_t k = 0; k < m.attributes().size(); ++k) {
    const AttributeColumn& column = m.attributes()[k];
    const bool has_pool =
        std::any_of(pooled.begin(), pooled.end(), [&](const CornerAttribute& each) { return each.index_column == k; });
    if (!column.is_of(ElementKind::corner) || column.rule == ValueRule::sum) continue;
    const auto value_at = [&](Halfedge corner) {
      return std::span(column.data).subspan(std::size_t{corner.index} * column.words(), column.words());
    };
    const auto is = [&](const MergedCorners::Value& value, Halfedge corner) {
      return std::equal(value.begin(), value.end(), value_at(corner).begin());
    };
    std::vector<MergedCorners> charts;
    for (const Halfedge side : {h, twin(h)}) {
      if (m.is_outside(side)) continue;
      const Halfedge at_gone = side == h ? side : m.next(side), at_kept = side == h ? m.next(side) : side;
      if (std::any_of(charts.begin(), charts.end(),
                      [&](const auto& c) { return is(c.gone, at_gone) && is(c.kept, at_kept); }))
        continue;
      std::array<std::uint32_t, 2> ends{at_gone.index, at_kept.index};
      std::array<double, 2> weights{1 - along, along};
      if (along >= 0.5 && !has_pool) {  // the nearer one first; values of pools have but means
        std::swap(ends[0], ends[1]);
        std::swap(weights[0], weights[1]);
      }
      const auto gone = value_at(at_gone), kept = value_at(at_kept);
      charts.push_back(
          {{gone.begin(), gone.end()}, {kept.begin(), kept.end()}, edit.derived(k, ends, weights, Derivation::copies)});
    }
    const auto update = [&](Vertex v, MergedCorners::Value MergedCorners::*old) {
      if (std::all_of(charts.begin(), charts.end(), [&](const auto& c) { return c.*old == c.made; })) return;
      for (const Halfedge corner : outgoing(m, v)) {
        if (m.is_outside(corner)) continue;
        const auto chart =
            std::find_if(charts.begin(), charts.end(), [&](const auto& c) { return is(c.*old, corner); });
        if (chart != charts.end()) edit.set_attribute(k, corner.index, chart->made);
      }
    };
    update(m.from(h), &MergedCorners::gone);
    update(m.to(h), &MergedCorners::kept);
  }
}

}  // namespace

bool unite_ends(Edit& edit, Vertex gone, Vertex kept, double along) {
  return along < 0.5 ? edit.derive(kept, gone, kept, along, Derivation::unites)
                     : edit.derive(kept, kept, gone, 1 - along, Derivation::unites);
}

void merge_ends(Edit& edit, Halfedge h, double along, Vertex gone_number, Vertex kept_number) {
  const Mesh& m = edit.mesh();
  if (unite_ends(edit, gone_number, kept_number, along))
    for_each_copy(m, m.to(h), [&](Vertex copy) {
      if (copy != m.to(h)) edit.derive(copy, kept_number, Derivation::copies);
    });
  if (!m.attributes().empty()) merge_corners(edit, h, along);
}

void unite_edges_at(Edit& edit, Vertex goes, Vertex stays) {
  const Mesh& m = edit.mesh();
  if (!has_attributes(m, ElementKind::edge)) return;
  std::unordered_map<Vertex, Edge> united;  // by point
  for_each_copy(m, goes, [&](Vertex copy) {
    for (const Halfedge h : outgoing(m, copy)) {
      const Vertex beyond = point(m, m.to(h));
      if (const auto at = united.find(beyond); at != united.end()) {
        edit.derive(edge(h), at->second, Derivation::copies);
        continue;
      }
      const std::vector<Halfedge> sheets = sheets_between(m, beyond, stays);
      if (sheets.empty()) continue;
      const Edge first = edge(sheets[0]);
      united.emplace(beyond, first);
      if (edit.derive(first, first, edge(h), 0.5, Derivation::unites))
        for (const Halfedge sheet : sheets) edit.derive(edge(sheet), first, Derivation::copies);
      edit.derive(edge(h), first, Derivation::copies);
    }
  });
}

void share_among_sheets(Edit& edit, std::span<const Edge> edges) {
  const Mesh& m = edit.mesh();
  if (!has_attributes(m, ElementKind::edge)) return;
  for (const Edge e : edges) {
    const auto [a, b] = ends(m, e);
    if (!has_copies(m, a) && !has_copies(m, b)) continue;
    for (const Halfedge sheet : sheets_between(m, a, b)) edit.derive(edge(sheet), e, Derivation::copies);
  }
}

void share_values(Edit& edit, std::span<const Edge> made) {
  const Mesh& m = edit.mesh();
  if (!has_attributes(m, ElementKind::edge)) return;
  std::vector<Edge> sorted(made.begin(), made.end());
  std::sort(sorted.begin(), sorted.end());
  const auto is_older = [&](Halfedge sheet) { return !std::binary_search(sorted.begin(), sorted.end(), edge(sheet)); };
  for (const Edge e : made) {
    const auto [a, b] = ends(m, e);
    const std::vector<Halfedge> sheets = sheets_between(m, a, b);
    const auto older = std::find_if(sheets.begin(), sheets.end(), is_older);
    if (older != sheets.end()) edit.derive(e, edge(*older), Derivation::copies);
  }
}

}  // namespace ryosen
