#include "ryosen/algo/repair/point_merger.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "ryosen/algo/repair/sides_apart.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

// Numbers whose sums tell sets of points apart: two sets agree with a chance of 2^-64, which would leave a seam too
// many.
std::uint64_t number_of(Vertex point) {
  std::uint64_t x = (point.index + 1) * 0x9e3779b97f4a7c15u;
  x = (x ^ x >> 30u) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27u) * 0x94d049bb133111ebu;
  return x ^ x >> 31u;
}

class Joiner {
 public:
  Joiner(Edit& edit, const std::vector<JoinedPoints>& classes)
      : edit_(edit), m_(edit.mesh()), classes_(classes), point_after_(points_by_slot(m_)) {
    std::vector<Vertex> becomes(m_.vertex_slots());
    for (const JoinedPoints& joined : classes)
      for (Vertex p : joined.points) becomes[p.index] = joined.points[0];
    for (Vertex& p : point_after_)
      if (p && becomes[p.index]) p = becomes[p.index];
  }

  void join() {
    collect_copies();
    unite_values();
    const std::vector<std::pair<Halfedge, Halfedge>> pairs = sides_to_join();
    for (const auto& [h, other] : pairs) {
      unite(m_.from(h), m_.to(other));
      unite(m_.to(h), m_.from(other));
    }
    for (const auto& [v, root] : root_of_)
      for (Halfedge h : outgoing(m_, v)) leaving_[root_of(v)].push_back(h);
    for (const auto& [h, other] : pairs) close(h, other);
    rename();
    link_copies();
    Sheets sheets(edit_);
    sheets.remove_vertices(isolated_copies());
    sort_unique(maybe_split_);
    sheets.make_manifold(maybe_split_);
  }

 private:
  void collect_copies() {
    for (const JoinedPoints& joined : classes_)
      for (Vertex p : joined.points)
        for_each_copy(m_, p, [&](Vertex copy) { copies_[joined.points[0]].push_back(copy); });
  }

  // Points that become one, and edges between the same two of them, get common values.
  void unite_values() {
    for (const JoinedPoints& joined : classes_) {
      const Vertex first = joined.points[0];
      edit_.unite<Vertex>(first, joined.points, [&] { return std::vector<double>(joined.points.size(), 1); });
      for (const Vertex copy : copies_.at(first)) edit_.derive(copy, first, Derivation::copies);
    }
    if (has_attributes(m_, ElementKind::edge)) unite_edge_values();
  }
  void unite_edge_values() {
    struct Joined {
      std::vector<Edge> edges, all;  // the first between two points before, and with those on the same points
      std::set<std::array<Vertex, 2>> before;
    };
    std::map<std::array<Vertex, 2>, Joined> edges;  // by the points that will be its ends
    for (const auto& [first, copies] : copies_)
      for (const Vertex v : copies)
        for (const Halfedge h : outgoing(m_, v)) {
          const Vertex beyond = m_.to(h);
          const std::array now = std::to_array<Vertex>({point(m_, v), point(m_, beyond)});
          const auto [a, b] = std::minmax({point_after_[v.index], point_after_[beyond.index]});
          Joined& at = edges[{a, b}];
          at.all.push_back(edge(h));
          if (at.before.insert({std::min(now[0], now[1]), std::max(now[0], now[1])}).second)
            at.edges.push_back(edge(h));
        }
    for (const auto& each : edges) {
      const Joined& joined = each.second;
      if (joined.edges.size() < 2) continue;
      const Edge first = joined.edges[0];
      edit_.unite<Edge>(first, joined.edges, [&] { return std::vector<double>(joined.edges.size(), 1); });
      for (const Edge e : joined.all) edit_.derive(e, first, Derivation::copies);
    }
  }

  // The sides of faces at the points that have no face beyond.
  std::vector<SideBetween> open_sides() const {
    std::vector<SideBetween> sides;
    for (const auto& [first, copies] : copies_)
      for (Vertex v : copies) {
        if (m_.is_isolated(v)) continue;
        for (Halfedge leaving : outgoing(m_, v))
          for (Halfedge h : {leaving, twin(leaving)}) {
            if (m_.is_outside(h) || !m_.is_outside(twin(h))) continue;
            sides.emplace_back(point_after_[m_.from(h).index], point_after_[m_.to(h).index], h);
          }
      }
    sort_unique(sides);
    return sides;
  }

  // Two sides, in opposite directions, of what will be one edge with no third face.
  std::vector<std::pair<Halfedge, Halfedge>> sides_to_join() {
    std::vector<std::pair<Halfedge, Halfedge>> pairs;
    for_each_edge(open_sides(), [&](std::span<const SideBetween> sides) {
      if (sides.size() != 2 || sides[0].is_forward == sides[1].is_forward) return;
      const std::size_t backward = sides[0].is_forward ? 1 : 0;
      const Halfedge h = sides[backward].halfedge, other = sides[1 - backward].halfedge;
      const std::array<Vertex, 4> ends{m_.from(h), m_.to(h), m_.from(other), m_.to(other)};
      if (std::all_of(ends.begin(), ends.end(), [&](Vertex v) { return has_one_gap(v); }))
        pairs.emplace_back(h, other);
      else
        maybe_split_.insert(maybe_split_.end(), ends.begin(), ends.end());
    });
    return pairs;
  }

  // Then its faces form one fan, and no wire ends there.
  bool has_one_gap(Vertex v) const {
    std::size_t gaps = 0;
    for (Halfedge h : outgoing(m_, v)) gaps += m_.is_outside(h);
    return gaps == 1;
  }

  Vertex root_of(Vertex v) {
    Vertex root = v;
    while (root_of_.at(root) != root) root = root_of_.at(root);
    while (v != root) v = std::exchange(root_of_.at(v), root);
    return root;
  }
  void unite(Vertex a, Vertex b) {
    root_of_.try_emplace(a, a);
    root_of_.try_emplace(b, b);
    const auto [low, high] = std::minmax({root_of(a), root_of(b)});
    root_of_.at(high) = low;
    // A point that is joined to none may have copies that become one.
    for (Vertex v : {a, b})
      if (const Vertex p = point_after_[v.index]; !copies_.contains(p))
        for_each_copy(m_, v, [&](Vertex copy) { copies_[p].push_back(copy); });
  }

  //      |  f  |            the outer half of h becomes the side of the other face, whose edge goes
  //   y  a<-h--b  w
  //      outside
  //   z  a'-g->b' x
  //      |  g's  |
  void close(Halfedge h, Halfedge g) {
    const Halfedge there = twin(h), back = twin(g);
    const Halfedge before = m_.prev(there), after = m_.next(there), in = m_.prev(back), out = m_.next(back);
    if (before != back) edit_.connect(before, out);
    if (after != back) edit_.connect(in, after);
    const Face f = m_.face(g);
    edit_.derive(there, g, Derivation::copies);
    edit_.fresh(g);
    replace_start(edit_, f, g, there);
    edit_.connect(m_.prev(g), there);
    edit_.connect(there, m_.next(g));
    edit_.set_face(there, f);
    edit_.drop(edge(g));
  }

  // The joined vertices become the lowest of them.
  void rename() {
    for (const auto& [root, leaving] : leaving_) {
      Halfedge hold;
      for (Halfedge h : leaving) {
        if (!m_.is_alive(h)) continue;
        edit_.set_from(h, root);
        if (!hold || m_.is_outside(h)) hold = h;
      }
      edit_.set_halfedge(root, hold);
    }
  }

  void link_copies() {
    for (auto& [first, copies] : copies_) {
      std::erase_if(copies, [&](Vertex v) {
        if (!root_of_.contains(v) || root_of(v) == v) return false;
        edit_.set_copy_links(v, v, v);
        edit_.drop(v);
        return true;
      });
      if (copies.size() > 1 || (!copies.empty() && has_copies(m_, copies[0]))) ryosen::link_copies(edit_, copies);
      // Reading may join more at a point that was non-manifold before, alone or with isolated ones.
      std::vector<Vertex> fans = copies;
      std::erase_if(fans, [&](Vertex v) { return m_.is_isolated(v); });
      if (fans.size() > 1) maybe_split_.push_back(fans[0]);
    }
    for (const JoinedPoints& joined : classes_)
      for (Vertex v : copies_[joined.points[0]]) edit_.set_position(v, joined.place);
  }

  // Those that go; of a point without edges the smallest copy stays. Descending.
  std::vector<Vertex> isolated_copies() {
    std::vector<Vertex> found;
    for (const JoinedPoints& joined : classes_) {
      std::vector<Vertex> isolated = copies_[joined.points[0]];
      const std::size_t all = isolated.size();
      std::erase_if(isolated, [&](Vertex v) { return !m_.is_isolated(v); });
      std::sort(isolated.begin(), isolated.end());
      found.insert(found.end(), isolated.begin() + (isolated.size() == all), isolated.end());
    }
    std::sort(found.begin(), found.end(), [](Vertex a, Vertex b) { return b < a; });
    return found;
  }

  Edit& edit_;
  const Mesh& m_;
  const std::vector<JoinedPoints>& classes_;
  std::vector<Vertex> point_after_;                  // by slot
  std::map<Vertex, std::vector<Vertex>> copies_;     // by point afterwards, of the points concerned
  std::map<Vertex, Vertex> root_of_;                 // of vertices that are joined to others
  std::map<Vertex, std::vector<Halfedge>> leaving_;  // by root, before anything is joined
  std::vector<Vertex> maybe_split_;
};

}  // namespace

std::vector<Vertex> points_by_slot(const Mesh& mesh) {
  std::vector<Vertex> points(mesh.vertex_slots());
  for (const Vertex v : live_vertices(mesh)) points[v.index] = point(mesh, v);
  return points;
}

PointMerger::PointMerger(const Mesh& mesh, std::span<const Vertex> points) : mesh_(mesh) {
  for (Vertex p : points) classes_[p];
  std::vector<Face> faces;
  for (Vertex p : points) for_each_face_at(mesh, p, [&](Face f) { faces.push_back(f); });
  sort_unique(faces);
  std::vector<Vertex> corners;
  for (Face f : faces) add_face(f, corners);
}

void PointMerger::add_face(Face f, std::vector<Vertex>& corners) {
  corners.clear();
  for (Halfedge h : halfedges_around(mesh_, f)) {
    const Vertex a = point(mesh_, mesh_.from(h)), b = point(mesh_, mesh_.to(h));
    corners.push_back(a);
    const auto at_a = classes_.find(a), at_b = classes_.find(b);
    if (at_a == classes_.end() && at_b == classes_.end()) continue;
    PointEdge& faces = edges_[key_of_pair(a, b)];
    ++(a < b ? faces.forward : faces.backward);
    if (at_a != classes_.end()) at_a->second.neighbours.push_back(b);
    if (at_b != classes_.end()) at_b->second.neighbours.push_back(a);
  }
  sort_unique(corners);
  Key& shape = shape_of_[f];
  for (Vertex p : corners) {
    shape += number_of(p);
    const auto at = classes_.find(p);
    if (at == classes_.end()) continue;
    at->second.faces.push_back(f);
    visits_.insert(key(f.index, p.index));
  }
  ++shapes_[shape];
}

Vertex PointMerger::root(Vertex point) const {
  // The smaller class was renamed at each merge, so the way is short.
  for (auto at = parent_.find(point); at != parent_.end(); at = parent_.find(point)) point = at->second;
  return point;
}

PointEdge PointMerger::edge(Vertex a, Vertex b) const {
  const auto found = edges_.find(key_of_pair(a, b));
  if (found == edges_.end()) return {};
  const PointEdge faces = found->second;
  return a < b ? faces : PointEdge{faces.backward, faces.forward};
}

// Whether the face would be a new duplicate with this shape.
bool PointMerger::is_taken(Face f, Key shape) const {
  const auto known = shapes_.find(shape);
  if (known == shapes_.end()) return false;
  const auto beyond = beyond_pocket_.find(f);
  return known->second > 1 || beyond == beyond_pocket_.end() || shape_of_.at(beyond->second) != shape;
}

bool PointMerger::may_join(Vertex goes, Vertex stays) const {
  const Class& at = classes_.at(goes);
  for (Face f : at.faces) {
    if (visits_.contains(key(f.index, stays.index))) return false;
    // Faces of the class that are equal stay equal.
    if (is_taken(f, shape_of_.at(f) - number_of(goes) + number_of(stays))) return false;
  }
  for (Vertex n : at.neighbours) {
    const Vertex end = root(n);
    const PointEdge faces = edge(goes, end), other = edge(stays, end);
    if (other.faces() == 0 || faces.faces() == 0) continue;
    if (faces.faces() + other.faces() > 2 || faces.forward + other.forward != 1) return false;
  }
  return true;
}

void PointMerger::rename_face(Face f, Vertex from, Vertex to) {
  Key& shape = shape_of_[f];
  if (const auto old = shapes_.find(shape); --old->second == 0) shapes_.erase(old);
  shape += number_of(to) - number_of(from);
  ++shapes_[shape];
}

bool PointMerger::merge(Vertex a, Vertex b) {
  const auto size_of = [&](Vertex v) {
    const Class& at = classes_.at(v);
    return std::pair(at.faces.size() + at.neighbours.size(), Vertex(~v.index));
  };
  const auto [goes, stays] = size_of(a) < size_of(b) ? std::pair(a, b) : std::pair(b, a);
  if (!may_join(goes, stays)) return false;
  Class &from = classes_[goes], &to = classes_[stays];
  Undo undo{goes, stays, to.faces.size(), to.neighbours.size(), {}};
  const auto set_edge = [&](Vertex v, Vertex end, PointEdge faces) {  // forward: away from v
    PointEdge& known = edges_[key_of_pair(v, end)];
    undo.edges.emplace_back(key_of_pair(v, end), known);
    known = v < end ? faces : PointEdge{faces.backward, faces.forward};
  };
  for (Vertex n : from.neighbours) {
    const Vertex end = root(n);
    const PointEdge moved = edge(goes, end), there = edge(stays, end);
    if (moved.faces() == 0) continue;  // met before
    set_edge(stays, end, {moved.forward + there.forward, moved.backward + there.backward});
    set_edge(goes, end, {});
  }
  for (Face f : from.faces) {
    rename_face(f, goes, stays);
    visits_.insert(key(f.index, stays.index));
  }
  to.faces.insert(to.faces.end(), from.faces.begin(), from.faces.end());
  to.neighbours.insert(to.neighbours.end(), from.neighbours.begin(), from.neighbours.end());
  parent_[goes] = stays;
  undo_.push_back(std::move(undo));
  return true;
}

void PointMerger::undo() {
  const Undo last = std::move(undo_.back());
  undo_.pop_back();
  parent_.erase(last.goes);
  Class &from = classes_[last.goes], &to = classes_[last.stays];
  to.faces.resize(last.faces);
  to.neighbours.resize(last.neighbours);
  for (Face f : from.faces) {
    rename_face(f, last.stays, last.goes);
    visits_.erase(key(f.index, last.stays.index));
  }
  for (auto change = last.edges.rbegin(); change != last.edges.rend(); ++change) edges_[change->first] = change->second;
}

void join_points(Edit& edit, const std::vector<JoinedPoints>& classes) {
  if (!classes.empty()) Joiner(edit, classes).join();
}

}  // namespace ryosen
