#include "ryosen/mesh/copies.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

std::uint32_t count_fans(const Mesh& mesh, Vertex v) {
  if (mesh.is_isolated(v)) return 0;
  if (!mesh.is_boundary(v)) return 1;
  std::uint32_t fans = 0;
  for (Halfedge h : outgoing(mesh, v)) fans += !mesh.is_outside(h) && mesh.is_outside(twin(h));
  return fans;
}

namespace {

// Iterates over the outgoing halfedges of all copies of a point.
class StarWalk {
 public:
  StarWalk(const Mesh& mesh, Vertex v) : mesh_(mesh), first_(v), copy_(v), at_(mesh.halfedge(v)) { skip_isolated(); }

  bool at_end() const { return at_.is_none(); }
  Halfedge halfedge() const { return at_; }
  bool reaches(Vertex v) const { return same_point(mesh_, mesh_.to(at_), v); }
  void step() {
    at_ = mesh_.counter_clockwise(at_);
    if (at_ == mesh_.halfedge(copy_)) to_next_copy();
  }

 private:
  void to_next_copy() {
    copy_ = mesh_.next_copy(copy_);
    at_ = copy_ == first_ ? Halfedge() : mesh_.halfedge(copy_);
    if (copy_ != first_) skip_isolated();
  }
  void skip_isolated() {
    if (at_.is_none()) to_next_copy();
  }

  const Mesh& mesh_;
  Vertex first_, copy_;
  Halfedge at_;
};

// Walks around both points in step and visits each halfedge from a to b as soon as it is met from a, and from b: one of
// the two has met them all when its walk ends. Stops when visit returns true, or at the end of a walk. Returns whether
// the walk around a has come to its end.
template <class VisitFromA, class VisitFromB>
bool walk_both(const Mesh& mesh, Vertex a, Vertex b, VisitFromA from_a, VisitFromB from_b) {
  StarWalk at_a(mesh, a), at_b(mesh, b);
  for (; !at_a.at_end() && !at_b.at_end(); at_a.step(), at_b.step()) {
    if (at_a.reaches(b) && from_a(at_a.halfedge())) return false;
    if (at_b.reaches(a) && from_b(twin(at_b.halfedge()))) return false;
  }
  return at_a.at_end();
}

}  // namespace

std::vector<Halfedge> sheets_between(const Mesh& mesh, Vertex a, Vertex b) {
  std::vector<Halfedge> sheets;
  std::size_t all = 0;
  Halfedge only;
  const auto keep = [&](Halfedge h) {
    sheets.push_back(h);
    return false;
  };
  const auto count = [&](Halfedge h) {
    only = h;
    ++all;
    return false;
  };
  if (walk_both(mesh, a, b, keep, count) || sheets.size() == all) return sheets;
  if (all == 1) return {only};
  // In the order around a.
  sheets.clear();
  for (StarWalk walk(mesh, a); sheets.size() < all; walk.step())
    if (walk.reaches(b)) sheets.push_back(walk.halfedge());
  return sheets;
}

Halfedge any_sheet_between(const Mesh& mesh, Vertex a, Vertex b) {
  Halfedge found;
  const auto stop = [&](Halfedge h) {
    found = h;
    return true;
  };
  walk_both(mesh, a, b, stop, stop);
  return found;
}

Vertex loneliest_point(const Mesh& mesh, std::span<const std::uint32_t> points) {
  assert(!points.empty());
  std::vector<StarWalk> walks;
  walks.reserve(points.size());
  for (const std::uint32_t p : points) walks.emplace_back(mesh, Vertex(p));
  for (;;)
    for (std::size_t i = 0; i < walks.size(); ++i) {
      if (walks[i].at_end()) return Vertex(points[i]);
      walks[i].step();
    }
}

bool has_several_sheets(const Mesh& mesh, Halfedge h) {
  const Vertex a = mesh.from(h), b = mesh.to(h);
  if (!has_copies(mesh, a) && !has_copies(mesh, b)) return false;
  std::size_t from_a = 0, from_b = 0;
  walk_both(
      mesh, a, b, [&](Halfedge) { return ++from_a > 1; }, [&](Halfedge) { return ++from_b > 1; });
  return std::max(from_a, from_b) > 1;
}

PointEdge point_edge(const Mesh& mesh, Halfedge h) {
  const auto add = [&](PointEdge& edge, Halfedge sheet) {
    edge.forward += !mesh.is_outside(sheet);
    edge.backward += !mesh.is_outside(twin(sheet));
    return edge.is_nonmanifold();
  };
  PointEdge from_a, from_b;
  const Vertex a = mesh.from(h), b = mesh.to(h);
  if (!has_copies(mesh, a) && !has_copies(mesh, b)) {
    add(from_a, h);
    return from_a;
  }
  const bool is_from_a = walk_both(
      mesh, a, b, [&](Halfedge sheet) { return add(from_a, sheet); },
      [&](Halfedge sheet) { return add(from_b, sheet); });
  return is_from_a || from_a.is_nonmanifold() ? from_a : from_b;
}

bool is_cut_on_points(const Mesh& mesh, Halfedge h) {
  if (!has_copies(mesh, mesh.from(h)) && !has_copies(mesh, mesh.to(h))) return false;
  return !point_edge(mesh, h).is_regular();
}

void move_point(Edit& edit, Vertex v, const glm::dvec3& position) {
  for_each_copy(edit.mesh(), v, [&](Vertex copy) { edit.set_position(copy, position); });
}

void link_copies(Edit& edit, std::span<const Vertex> copies) {
  const Vertex smallest = *std::min_element(copies.begin(), copies.end());
  for (std::size_t i = 0; i < copies.size(); ++i)
    edit.set_copy_links(copies[i], copies[(i + 1) % copies.size()], smallest);
}

namespace {

void name_copies(Edit& edit, Vertex v, Vertex point) {
  for_each_copy(edit.mesh(), v, [&](Vertex copy) { edit.set_copy_links(copy, edit.mesh().next_copy(copy), point); });
}

}  // namespace

void join_copies(Edit& edit, Vertex a, Vertex b) {
  const Mesh& mesh = edit.mesh();
  const Vertex smaller = std::min(point(mesh, a), point(mesh, b)), larger = std::max(point(mesh, a), point(mesh, b));
  name_copies(edit, larger, smaller);
  const Vertex after_a = mesh.next_copy(a), after_b = mesh.next_copy(b);
  edit.set_copy_links(a, after_b, smaller);
  edit.set_copy_links(b, after_a, smaller);
}

void leave_copies(Edit& edit, Vertex v) {
  const Mesh& mesh = edit.mesh();
  if (!has_copies(mesh, v)) return;
  const Vertex after = mesh.next_copy(v);
  Vertex before = after, smallest = after;
  for (Vertex copy = after; copy != v; copy = mesh.next_copy(copy)) {
    before = copy;
    smallest = std::min(smallest, copy);
  }
  const Vertex left = point(mesh, v);
  edit.set_copy_links(v, v, v);
  edit.set_copy_links(before, after, left == v ? smallest : left);
  if (left == v) name_copies(edit, after, smallest);
}

ElementCounts counts_on_points(const Mesh& mesh) {
  ElementCounts counts = mesh.live();
  if (!mesh.has_copies()) return counts;
  std::vector<Vertex> points(mesh.vertex_slots());
  for (const Vertex v : live_vertices(mesh)) {
    // Ascending, so the first copy found is the point.
    if (points[v.index])
      --counts.vertices;
    else
      for_each_copy(mesh, v, [&](Vertex copy) { points[copy.index] = v; });
  }
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (const Edge e : live_edges(mesh)) {
    const auto [a, b] = ends(mesh, e);
    if (has_copies(mesh, a) || has_copies(mesh, b)) pairs.push_back(std::minmax(points[a.index], points[b.index]));
  }
  const std::size_t sheets = pairs.size();
  sort_unique(pairs);
  counts.edges -= static_cast<std::uint32_t>(sheets - pairs.size());
  return counts;
}

}  // namespace ryosen
