#include "ryosen/algo/repair/point_merger.h"

#include <algorithm>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"

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

}  // namespace

std::vector<Vertex> points_by_slot(const Mesh& mesh) {
  std::vector<Vertex> points(mesh.vertex_slots());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (mesh.is_alive(Vertex(i))) points[i] = point(mesh, Vertex(i));
  return points;
}

PointMerger::PointMerger(const Mesh& mesh, const std::vector<Vertex>& point_of, std::span<const Vertex> points)
    : mesh_(mesh) {
  for (Vertex p : points) classes_[p];
  std::vector<Face> faces;
  for (Vertex p : points)
    for_each_copy(mesh, p, [&](Vertex copy) {
      for (Face f : faces_around(mesh, copy))
        if (f) faces.push_back(f);
    });
  sort_unique(faces);
  std::vector<Vertex> corners;
  for (Face f : faces) add_face(f, corners, point_of);
}

void PointMerger::add_face(Face f, std::vector<Vertex>& corners, const std::vector<Vertex>& point_of) {
  corners.clear();
  for (Halfedge h : halfedges_around(mesh_, f)) {
    const Vertex a = point_of[mesh_.from(h).index], b = point_of[mesh_.to(h).index];
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

}  // namespace ryosen
