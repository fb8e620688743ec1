// Sheets::make_joined_manifold(): make_manifold() for a point that grows, without a look at what has come to it before.
#include <algorithm>
#include <unordered_set>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

// Of edges that are to be joined the halves that make_manifold() meets first, in its order: by vertex, then around it.
std::vector<Halfedge> Sheets::first_halves(std::span<const Halfedge> halves, Vertex at) const {
  const Mesh& m = edit_.mesh();
  std::vector<Halfedge> first;
  for (const Halfedge h : halves) {
    Halfedge met = h;
    if (same_point(m, m.from(h), at))
      for (const Halfedge sheet : sheets_between(m, m.from(h), m.to(h)))
        if (!m.is_wire(edge(sheet)) && m.from(sheet) < m.from(met)) met = sheet;
    first.push_back(met);
  }
  sort_unique(first);
  std::stable_sort(first.begin(), first.end(), [&](Halfedge a, Halfedge b) { return m.from(a) < m.from(b); });
  for (auto begin = first.begin(); begin != first.end();) {
    const auto end = std::find_if(begin, first.end(), [&](Halfedge h) { return m.from(h) != m.from(*begin); });
    std::vector<Halfedge> in_order;
    if (end - begin > 1)
      for (const Halfedge h : outgoing(m, m.from(*begin)))
        if (std::binary_search(begin, end, h)) in_order.push_back(h);
    std::copy(in_order.begin(), in_order.end(), begin);
    begin = end;
  }
  return first;
}

// The vertices that make_manifold() would look at where something is cut or joined, less those that are manifold.
std::vector<Vertex> Sheets::left_at(ManifoldPoint& known, std::span<const Vertex> touched) {
  const Mesh& m = edit_.mesh();
  std::vector<Vertex> all = known.maybe_split;
  std::unordered_set<Vertex> met;
  const auto add = [&](Vertex v) {
    const Vertex p = point(m, v);
    all.push_back(v);
    if (same_point(m, v, known.at) || !met.insert(p).second) return;
    const auto [beside, is_new] = known.beside.try_emplace(p);
    if (is_new) for_each_copy(m, p, [&copies = beside->second](Vertex copy) { copies.push_back(copy); });
    all.insert(all.end(), beside->second.begin(), beside->second.end());
  };
  const auto gather = [&] {
    std::erase_if(all, [&](Vertex v) { return !m.is_alive(v); });
    sort_unique(all);
  };
  std::for_each(touched.begin(), touched.end(), add);
  gather();
  std::vector<Vertex> ends;
  for (const Vertex v : all)
    for (const Halfedge h : outgoing(m, v)) {
      ++looks_;
      if (is_cut_on_points(m, h)) ends.push_back(m.to(h));
    }
  std::for_each(ends.begin(), ends.end(), add);
  gather();
  for (const Vertex p : met) known.beside[p].clear();
  return all;
}

void Sheets::make_joined_manifold(std::vector<Vertex> joined, ManifoldPoint& known) {
  const Mesh& m = edit_.mesh();
  std::sort(joined.begin(), joined.end());
  known.maybe_split.insert(known.maybe_split.end(), joined.begin(), joined.end());
  std::vector<Halfedge> to_open = sheets_to_open(joined);
  const std::vector<Halfedge> to_join = first_halves(sheets_to_join(joined), known.at);
  open_beside(to_join, to_open);
  std::vector<Vertex> touched;
  for (Halfedge h : to_open) touched.insert(touched.end(), {m.from(h), m.to(h)});
  for (Halfedge h : to_join)
    for (Halfedge sheet : sheets_between(m, m.from(h), m.to(h)))
      touched.insert(touched.end(), {m.from(sheet), m.to(sheet)});
  add_double_ends(joined, touched);
  if (touched.empty()) return;
  std::vector<Vertex> all = left_at(known, touched);
  const std::uint32_t slots = m.vertex_slots();
  for (Halfedge h : to_open) open(h);
  for (Vertex v : all) separate(v);
  for (Halfedge h : to_join) join_sheet(h);
  all.insert(all.end(), joined.begin(), joined.end());
  for (std::uint32_t i = slots; i < m.vertex_slots(); ++i) all.push_back(Vertex(i));
  std::erase_if(all, [&](Vertex v) { return !m.is_alive(v); });
  std::vector<Vertex> doubled;
  add_double_ends(all, doubled);
  all.insert(all.end(), doubled.begin(), doubled.end());
  sort_unique(all);
  close_double_edges(all);
  known.maybe_split.clear();
  for (Vertex v : all) {
    if (!m.is_alive(v) || count_fans(m, v) < 2) continue;
    if (same_point(m, v, known.at))
      known.maybe_split.push_back(v);
    else if (const auto beside = known.beside.find(point(m, v)); beside != known.beside.end())
      beside->second.push_back(v);
  }
}

}  // namespace ryosen
