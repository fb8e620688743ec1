#include "ryosen/ops/rules/sheets.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

std::vector<Halfedge> leaving(const Mesh& m, Vertex v) {
  std::vector<Halfedge> found;
  for (Halfedge h : outgoing(m, v)) found.push_back(h);
  return found;
}

// The halfedges of a cycle around a vertex that is being split, starting with `start`.
std::vector<Halfedge> cycle_of(const Mesh& m, Halfedge start) {
  std::vector<Halfedge> found{start};
  for (Halfedge h = m.counter_clockwise(start); h != start; h = m.counter_clockwise(h)) found.push_back(h);
  return found;
}

// Returns the last of the copies (ascending) that stay and have edges or, if there is none, the last that stays.
template <class Copies>
Vertex heir_among(const Mesh& m, const Copies& copies, std::span<const Vertex> going) {
  Vertex last;
  for (auto copy = copies.rbegin(); copy != copies.rend(); ++copy) {
    if (std::binary_search(going.begin(), going.end(), *copy)) continue;
    if (!m.is_isolated(*copy)) return *copy;
    if (!last) last = *copy;
  }
  return last;
}

}  // namespace

bool CopyRings::get_to_know(Vertex p) {
  constexpr int few = 32;
  if (knows(p)) return true;
  int count = 0;
  if (walked_.insert(p).second || !any_of_copies(edit_.mesh(), p, [&](Vertex) { return ++count > few; })) return false;
  know(p);
  return true;
}

void CopyRings::know(Vertex p) {
  const Mesh& m = edit_.mesh();
  std::set<Vertex>& ring = rings_[p];
  for_each_copy(m, p, [&](Vertex copy) {
    ring.insert(copy);
    before_[m.next_copy(copy)] = copy;
  });
}

void CopyRings::join(Vertex a, Vertex b) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, a), q = point(m, b);
  if (!knows(p) && !knows(q)) return join_copies(edit_, a, b);
  for (const Vertex each : {p, q})
    if (!knows(each)) know(each);
  join_copies(edit_, a, b);
  before_[m.next_copy(a)] = a;
  before_[m.next_copy(b)] = b;
  std::set<Vertex> one = std::move(rings_.at(p)), other = std::move(rings_.at(q));
  if (one.size() < other.size()) one.swap(other);
  one.merge(other);
  rings_.erase(p);
  rings_.erase(q);
  rings_.emplace(std::min(p, q), std::move(one));
}

void CopyRings::leave(Vertex v, Vertex other) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, v);
  if (p != v && m.next_copy(other) == v) return unlink(v, other);
  if (p != v && get_to_know(p)) return unlink(v, before_.at(v));
  rings_.erase(p);
  leave_copies(edit_, v);
}

// Takes out a copy that is not the representative of its point.
void CopyRings::unlink(Vertex v, Vertex before) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, v), after = m.next_copy(v);
  edit_.set_copy_links(before, after, p);
  edit_.set_copy_links(v, v, v);
  const auto ring = rings_.find(p);
  if (ring == rings_.end()) return;
  before_[after] = before;
  before_.erase(v);
  ring->second.erase(v);
}

Vertex CopyRings::leave_all(std::span<const Vertex> going) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, going.front());
  if (!get_to_know(p)) return leave_small(going);
  std::vector<Vertex> go(going.begin(), going.end());
  std::sort(go.begin(), go.end());
  Vertex heir;
  if (go.front() == p) {
    heir = heir_among(m, rings_.at(p), go);
    go.front() = heir ? heir : go.back();
    if (!heir) go.pop_back();
  }
  for (const Vertex v : go) unlink(v, before_.at(v));
  if (rings_.at(p).size() == 1) rings_.erase(p);
  return heir;
}

Vertex CopyRings::leave_small(std::span<const Vertex> going) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, going.front());
  std::vector<Vertex> go(going.begin(), going.end()), stay, ascending;
  std::sort(go.begin(), go.end());
  for_each_copy(m, p, [&](Vertex copy) {
    if (!std::binary_search(go.begin(), go.end(), copy)) stay.push_back(copy);
  });
  Vertex heir;
  if (go.front() == p && !stay.empty()) {
    ascending = stay;
    std::sort(ascending.begin(), ascending.end());
    heir = heir_among(m, ascending, go);
    go.front() = heir;
    stay.erase(std::find(stay.begin(), stay.end(), heir));
    stay.insert(stay.begin(), p);
  }
  for (const Vertex copy : go) edit_.set_copy_links(copy, copy, copy);
  if (!stay.empty()) link_copies(edit_, stay);
  return heir;
}

std::vector<Vertex> live_copies(const Mesh& m, std::span<const Vertex> given) {
  std::vector<Vertex> points, found;
  for (Vertex v : given)
    if (m.is_alive(v)) points.push_back(point(m, v));
  sort_unique(points);
  for (Vertex p : points) for_each_copy(m, p, [&](Vertex copy) { found.push_back(copy); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Face> faces_of_sheet(const Mesh& mesh, Face f, std::size_t enough,
                                 const std::function<bool(Face)>& is_last) {
  std::vector<Face> sheet{f};
  std::unordered_set<Face> seen{f};
  for (std::size_t i = 0; i < sheet.size() && sheet.size() < enough; ++i)
    for (Halfedge h : halfedges_around(mesh, sheet[i])) {
      const Face beside = mesh.face(twin(h));
      if (!beside || is_cut_on_points(mesh, h) || !seen.insert(beside).second) continue;
      sheet.push_back(beside);
      if (is_last(beside)) return sheet;
    }
  return sheet;
}

std::vector<Face> faces_of_sheet(const Mesh& mesh, Face f, std::size_t enough) {
  return faces_of_sheet(mesh, f, enough, [](Face) { return false; });
}

std::vector<Fan> fans_at(const Mesh& m, Vertex v) {
  std::vector<Fan> fans;
  if (m.is_isolated(v)) return fans;
  const std::vector<Halfedge> around = leaving(m, v);
  if (!m.is_outside(around[0])) {
    Fan closed;
    for (Halfedge h : around) closed.lowest_face = std::min(closed.lowest_face, m.face(h));
    return {closed};
  }
  // The first one is a boundary halfedge, so every fan ends at or before the end of the walk.
  for (std::size_t i = 1; i <= around.size(); ++i) {
    const Halfedge h = around[i % around.size()];
    if (m.is_outside(twin(h)) && !m.is_outside(h)) fans.push_back({h, Halfedge(), Face()});
    if (!m.is_outside(h)) fans.back().lowest_face = std::min(fans.back().lowest_face, m.face(h));
    if (m.is_outside(h) && !m.is_outside(twin(h))) fans.back().last = h;
  }
  std::sort(fans.begin(), fans.end(), [](const Fan& a, const Fan& b) { return a.lowest_face < b.lowest_face; });
  return fans;
}

void Sheets::rename(std::span<const Halfedge> halfedges, Vertex v) {
  for (Halfedge h : halfedges) {
    edit_.set_from(h, v);
    changed(edit_.mesh().face(h));
  }
}

Vertex Sheets::take_out(const Fan& fan) {
  const Mesh& m = edit_.mesh();
  const Vertex v = m.from(fan.first);
  const Halfedge into = twin(fan.first), before = m.prev(fan.last), rest = m.next(into);
  const Vertex copy = edit_.add_vertex(m.position(v));
  edit_.derive(copy, v, Derivation::copies);
  edit_.connect(into, fan.last);
  edit_.connect(before, rest);
  rename(cycle_of(m, fan.first), copy);
  edit_.set_halfedge(copy, fan.last);
  edit_.set_halfedge(v, rest);
  hold_outside(edit_, v);
  rings_->join(v, copy);
  return copy;
}

void Sheets::separate(Vertex v) {
  const std::vector<Fan> fans = fans_at(edit_.mesh(), v);
  for (std::size_t i = 1; i < fans.size(); ++i) take_out(fans[i]);
}

void Sheets::join_corner(Halfedge into, Halfedge out) {
  const Mesh& m = edit_.mesh();
  if (m.next(into) == out) return;
  const Vertex p = m.to(into), q = m.from(out), stays = std::min(p, q), goes = std::max(p, q);
  const Halfedge after = m.next(into), before = m.prev(out);
  if (p != q) {
    const std::vector<Halfedge> moved = leaving(m, goes);
    edit_.connect(into, out);
    edit_.connect(before, after);
    rename(moved, stays);
    rings_->leave(goes, stays);
    edit_.drop(goes);
    effect_.deleted.push_back(goes);
    hold_outside(edit_, stays);
    return;
  }
  edit_.connect(into, out);
  edit_.connect(before, after);  // now two cycles, one with `out` and one with `after`
  for (Halfedge gap : cycle_of(m, out)) {
    if (gap == out || !m.is_outside(gap)) continue;
    edit_.connect(m.prev(gap), after);
    edit_.connect(before, gap);
    return;
  }
  const Vertex copy = edit_.add_vertex(m.position(p));
  edit_.derive(copy, p, Derivation::copies);
  rename(cycle_of(m, after), copy);
  edit_.set_halfedge(copy, after);
  edit_.set_halfedge(p, out);
  rings_->join(p, copy);
}

void Sheets::join_edges(Halfedge h, Halfedge back) {
  const Mesh& m = edit_.mesh();
  assert(m.next(h) == back && m.next(back) == h && m.is_outside(h) && m.is_outside(back) && edge(h) != edge(back));
  const Halfedge old = twin(back);
  const Face f = m.face(old);
  const Vertex a = m.from(h), b = m.from(back);
  if (f) {
    edit_.derive(h, old, Derivation::copies);
    edit_.fresh(old);
    replace_start(edit_, f, old, h);
  }
  edit_.connect(m.prev(old), h);
  edit_.connect(h, m.next(old));
  edit_.set_face(h, f);
  if (m.halfedge(a) == old) edit_.set_halfedge(a, h);
  if (m.halfedge(b) == back) edit_.set_halfedge(b, twin(h));
  drop(edge(back));
  hold_outside(edit_, a);
  hold_outside(edit_, b);
  changed(f);
}

Halfedge Sheets::open(Halfedge h) {
  const Mesh& m = edit_.mesh();
  const Halfedge o = twin(h);
  assert(!m.is_outside(h) && !m.is_outside(o));
  const Vertex a = m.from(h), b = m.from(o);
  const Halfedge k = edit_.add_edge(b, a), outside = twin(k);
  const Face right = m.face(o);
  edit_.derive(edge(k), edge(h), Derivation::copies);
  edit_.derive(k, o, Derivation::copies);
  edit_.fresh(o);
  edit_.connect(m.prev(o), k);
  edit_.connect(k, m.next(o));
  edit_.set_face(k, right);
  replace_start(edit_, right, o, k);
  edit_.connect(o, outside);
  edit_.connect(outside, o);
  edit_.set_face(o, Face());
  edit_.set_halfedge(a, outside);
  edit_.set_halfedge(b, o);
  changed(right);
  return k;
}

void Sheets::remove_vertices(std::span<const Vertex> descending) {
  const Mesh& m = edit_.mesh();
  std::unordered_map<Vertex, std::vector<Vertex>> going;  // by point
  std::unordered_map<Vertex, Vertex> heirs;               // of points that go: the copies that go in their place
  for (Vertex v : descending)
    if (has_copies(m, v)) going[point(m, v)].push_back(v);
  for (const auto& [p, copies] : going)
    if (const Vertex heir = rings_->leave_all(copies)) heirs[p] = heir;
  for (Vertex v : descending) {
    if (const auto heir = heirs.find(v); heir != heirs.end()) {
      rename(leaving(m, heir->second), v);
      edit_.set_halfedge(v, m.halfedge(heir->second));
      v = heir->second;
    }
    edit_.drop(v);
    effect_.deleted.push_back(v);
  }
}

void Sheets::drop(Edge e) {
  edit_.drop(e);
  effect_.deleted.push_back(e);
}

void Sheets::remove_edge(Halfedge h) {
  const auto [a, b] = ends(edit_.mesh(), edge(h));
  unlink_edge(edit_, h);
  effect_.deleted.push_back(edge(h));
  hold_outside(edit_, a);
  hold_outside(edit_, b);
}

void Sheets::remove_face(Face f) {
  take_face_away(edit_, f);
  effect_.deleted.push_back(f);
}

void Sheets::exchange(Vertex v, Vertex w) {
  const Mesh& m = edit_.mesh();
  const std::vector<Halfedge> at_v = leaving(m, v), at_w = leaving(m, w);
  const Halfedge hold_v = m.halfedge(v), hold_w = m.halfedge(w);
  rename(at_v, w);
  rename(at_w, v);
  edit_.set_halfedge(v, hold_w);
  edit_.set_halfedge(w, hold_v);
}

void Sheets::changed(Face f) {
  if (f) effect_.changed.push_back(f);
}

void Sheets::changed_around(Vertex v) {
  for (Face f : faces_around(edit_.mesh(), v)) changed(f);
}

OpEffect Sheets::finish() {
  const Mesh& m = edit_.mesh();
  OpEffect effect;
  for (const Vertex v : live_vertices(m, Vertex(before_.vertices))) effect.created.push_back(v);
  for (const Edge e : live_edges(m, Edge(before_.halfedges / 2))) effect.created.push_back(e);
  for (const Face f : live_faces(m, Face(before_.faces))) effect.created.push_back(f);
  for (const Element& e : effect_.deleted) {
    const std::uint32_t had = e.kind == Element::Kind::vertex ? before_.vertices
                              : e.kind == Element::Kind::edge ? before_.halfedges / 2
                                                              : before_.faces;
    if (e.index < had) effect.deleted.push_back(e);
  }
  sort_unique(effect_.changed);
  for (Face f : effect_.changed)
    if (m.is_alive(f)) effect.changed.push_back(f);
  return effect;
}

}  // namespace ryosen
