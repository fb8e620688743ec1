// Sheets::make_manifold(): what of a surface is to be cut and joined as reading does. make_joined_manifold() does so
// for a point that grows, without a look at what has come to it before.
#include <algorithm>
#include <array>
#include <unordered_set>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

bool has_one_face(const Mesh& m, Halfedge h) { return m.is_outside(h) != m.is_outside(twin(h)); }

// The sheets between the points of h, its own among them, in the order around the point of lower valence. Cost: that
// valence.
std::vector<Halfedge> sheets_beside(const Mesh& m, Halfedge h) {
  const Vertex a = m.from(h), b = m.to(h);
  const std::array<std::uint32_t, 2> ends{a.index, b.index};
  if (loneliest_point(m, ends) == a) return sheets_between(m, a, b);
  std::vector<Halfedge> sheets = sheets_between(m, b, a);
  for (Halfedge& sheet : sheets) sheet = twin(sheet);
  return sheets;
}

}  // namespace

// Whether this is a cut edge whose boundary loop would have exactly two halfedges (which reading closes again): at both
// ends the fan connects its two faces without another cut.
bool Sheets::is_closed_cut(Halfedge h) const {
  const Mesh& m = edit_.mesh();
  for (Vertex v : {m.from(h), m.to(h)})
    for (Halfedge other : outgoing(m, v)) {
      if (m.is_outside(other) || m.is_outside(twin(other))) return false;
      if (edge(other) != edge(h) && is_cut_on_points(m, other)) return false;
    }
  return true;
}

// Edges with two faces that reading would cut. Their other ends are added to the vertices.
std::vector<Halfedge> Sheets::sheets_to_open(std::vector<Vertex>& vertices) {
  const Mesh& m = edit_.mesh();
  std::vector<Halfedge> found;
  std::unordered_set<Vertex> met(vertices.begin(), vertices.end());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (Halfedge h : outgoing(m, vertices[i])) {
      ++looks_;
      if (m.is_outside(h) || m.is_outside(twin(h)) || !is_cut_on_points(m, h) || is_closed_cut(h)) continue;
      found.push_back(std::min(h, twin(h)));
      if (met.insert(m.to(h)).second) vertices.push_back(m.to(h));
    }
  }
  sort_unique(found);
  return found;
}

// Finds the ends of double edges (two edges between the same vertices), which can result from merging vertices.
void Sheets::add_double_ends(std::span<const Vertex> vertices, std::vector<Vertex>& found) {
  const Mesh& m = edit_.mesh();
  std::vector<Vertex> ends;
  for (Vertex v : vertices) {
    ends.clear();
    for (Vertex end : neighbours(m, v)) ends.push_back(end);
    looks_ += ends.size();
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (ends[i] == ends[i - 1]) found.insert(found.end(), {v, ends[i]});
  }
}

// Where edges are joined, copies at their other ends become one: there edges with two faces that reading would cut are
// opened as well, since others beside them would join the same vertices.
void Sheets::open_beside(std::span<const Halfedge> to_join, std::vector<Halfedge>& to_open) {
  const Mesh& m = edit_.mesh();
  std::vector<Vertex> merged;
  for (Halfedge h : to_join)
    for (Halfedge sheet : sheets_beside(m, h))
      if (m.to(sheet) != m.to(h)) merged.insert(merged.end(), {m.to(h), m.to(sheet)});
  if (merged.empty()) return;
  sort_unique(merged);
  const std::vector<Halfedge> beside = sheets_to_open(merged);
  to_open.insert(to_open.end(), beside.begin(), beside.end());
  sort_unique(to_open);
}

// Edges with one face each whose points have exactly two faces, in opposite directions: reading would join them.
std::vector<Halfedge> Sheets::sheets_to_join(std::span<const Vertex> vertices) {
  const Mesh& m = edit_.mesh();
  std::vector<Halfedge> found;
  for (Vertex v : vertices) {
    for (Halfedge h : outgoing(m, v)) {
      ++looks_;
      if (!has_one_face(m, h)) continue;
      const PointEdge faces = point_edge(m, h);
      if (faces.forward == 1 && faces.backward == 1) found.push_back(h);
    }
  }
  return found;
}

void Sheets::close_pair(Halfedge h, Halfedge other) {
  const Halfedge there = outside_half(edit_.mesh(), h), back = outside_half(edit_.mesh(), other);
  join_corner(back, there);
  join_corner(there, back);
  join_edges(there, back);
}

void Sheets::join_sheet(Halfedge h) {
  const Mesh& m = edit_.mesh();
  if (!m.is_alive(h) || !has_one_face(m, h)) return;  // already joined from its other end
  for (Halfedge other : sheets_beside(m, h)) {
    if (edge(other) == edge(h) || !has_one_face(m, other)) continue;
    return close_pair(h, other);
  }
}

// Resolves double edges at v: a wire among them is removed, and two boundary edges of one fan are joined (the boundary
// loop between them has two halfedges, apart from wires in their gaps).
void Sheets::close_double_edges(Vertex v) {
  const Mesh& m = edit_.mesh();
  std::vector<std::pair<Vertex, Halfedge>> ends;
  if (m.is_alive(v))
    for (Halfedge h : outgoing(m, v)) ends.emplace_back(m.to(h), h);
  looks_ += ends.size();
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    Halfedge h = ends[i].second, other = ends[i - 1].second;
    if (ends[i].first != ends[i - 1].first || !m.is_alive(h) || !m.is_alive(other)) continue;
    if (m.is_wire(edge(other))) std::swap(h, other);
    if (m.is_wire(edge(h)))
      remove_edge(h);
    else if (has_one_face(m, h) && has_one_face(m, other) && m.is_outside(h) != m.is_outside(other))
      close_pair(h, other);
  }
}

void Sheets::close_double_edges(std::vector<Vertex>& vertices) {
  const std::uint32_t slots = edit_.mesh().vertex_slots();
  for (Vertex v : vertices) close_double_edges(v);
  for (std::uint32_t i = slots; i < edit_.mesh().vertex_slots(); ++i) {
    vertices.push_back(Vertex(i));
    close_double_edges(Vertex(i));
  }
}

bool Sheets::is_manifold(std::span<const Vertex> points) {
  if (!edit_.mesh().has_copies()) return true;
  std::vector<Vertex> vertices = live_copies(edit_.mesh(), points), doubled;
  add_double_ends(vertices, doubled);
  return doubled.empty() && sheets_to_open(vertices).empty() && sheets_to_join(vertices).empty();
}

std::vector<Vertex> Sheets::make_manifold(std::span<const Vertex> points) {
  const Mesh& m = edit_.mesh();
  if (!m.has_copies()) return {};
  std::vector<Vertex> vertices = live_copies(m, points);
  std::vector<Halfedge> to_open = sheets_to_open(vertices);
  const std::vector<Halfedge> to_join = sheets_to_join(vertices);
  open_beside(to_join, to_open);
  // Vertices where nothing is cut or joined may keep several fans.
  std::vector<Vertex> touched;
  for (Halfedge h : to_open) touched.insert(touched.end(), {m.from(h), m.to(h)});
  for (Halfedge h : to_join) touched.insert(touched.end(), {m.from(h), m.to(h)});
  add_double_ends(vertices, touched);
  touched = live_copies(m, touched);
  const std::size_t at_seams = touched.size();
  for (std::size_t i = 0; i < at_seams; ++i)
    for (Halfedge h : outgoing(m, touched[i]))
      if (is_cut_on_points(m, h)) touched.push_back(m.to(h));
  touched = live_copies(m, touched);
  for (Halfedge h : to_open) open(h);
  for (Vertex v : touched) separate(v);
  for (Halfedge h : to_join) join_sheet(h);
  vertices.insert(vertices.end(), touched.begin(), touched.end());
  vertices = live_copies(m, vertices);
  close_double_edges(vertices);
  return touched;
}

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
