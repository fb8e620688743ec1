#include "core/mesh/copies.h"

#include <algorithm>
#include <utility>

#include "core/base/sort_unique.h"
#include "core/mesh/circulate.h"

namespace ryosen {

Vertex point(const Mesh& mesh, Vertex v) {
  Vertex smallest = v;
  for_each_copy(mesh, v, [&](Vertex copy) { smallest = std::min(smallest, copy); });
  return smallest;
}

std::uint32_t count_fans(const Mesh& mesh, Vertex v) {
  if (mesh.is_isolated(v)) return 0;
  if (!mesh.is_boundary(v)) return 1;
  std::uint32_t fans = 0;
  for (Halfedge h : outgoing(mesh, v)) fans += !mesh.is_outside(h) && mesh.is_outside(twin(h));
  return fans;
}

std::vector<Halfedge> sheets_between(const Mesh& mesh, Vertex a, Vertex b) {
  std::vector<Halfedge> sheets;
  for_each_copy(mesh, a, [&](Vertex copy) {
    for (Halfedge h : outgoing(mesh, copy))
      if (same_point(mesh, mesh.to(h), b)) sheets.push_back(h);
  });
  return sheets;
}

namespace {

// Iterates over the outgoing halfedges of all copies of a point.
class StarWalk {
 public:
  StarWalk(const Mesh& mesh, Vertex v) : mesh_(mesh), first_(v), copy_(v), at_(mesh.halfedge(v)) { skip_isolated(); }

  bool at_end() const { return at_.is_none(); }
  Vertex neighbour() const { return mesh_.to(at_); }
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

}  // namespace

bool are_joined(const Mesh& mesh, Vertex a, Vertex b) {
  StarWalk from_a(mesh, a), from_b(mesh, b);
  for (; !from_a.at_end() && !from_b.at_end(); from_a.step(), from_b.step())
    if (same_point(mesh, from_a.neighbour(), b) || same_point(mesh, from_b.neighbour(), a)) return true;
  return false;
}

PointEdge point_edge(const Mesh& mesh, Halfedge h) {
  PointEdge result;
  const auto count = [&](Halfedge sheet) {
    result.forward += !mesh.is_outside(sheet);
    result.backward += !mesh.is_outside(twin(sheet));
  };
  const Vertex a = mesh.from(h), b = mesh.to(h);
  if (!has_copies(mesh, a) && !has_copies(mesh, b)) {
    count(h);
  } else {
    for (Halfedge sheet : sheets_between(mesh, a, b)) count(sheet);
  }
  return result;
}

bool is_cut_on_points(const Mesh& mesh, Halfedge h) {
  if (!has_copies(mesh, mesh.from(h)) && !has_copies(mesh, mesh.to(h))) return false;
  return !point_edge(mesh, h).is_regular();
}

void move_point(Edit& edit, Vertex v, const glm::dvec3& position) {
  for_each_copy(edit.mesh(), v, [&](Vertex copy) { edit.set_position(copy, position); });
}

void leave_copies(Edit& edit, Vertex v) {
  const Mesh& mesh = edit.mesh();
  if (!has_copies(mesh, v)) return;
  Vertex before = v;
  while (mesh.next_copy(before) != v) before = mesh.next_copy(before);
  edit.set_next_copy(before, mesh.next_copy(v));
  edit.set_next_copy(v, v);
}

ElementCounts counts_on_points(const Mesh& mesh) {
  ElementCounts counts = mesh.live();
  if (!mesh.has_copies()) return counts;
  std::vector<Vertex> points(mesh.vertex_slots());
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    if (!mesh.is_alive(Vertex(i))) continue;
    // Ascending, so the first copy found is the point.
    if (points[i])
      --counts.vertices;
    else
      for_each_copy(mesh, Vertex(i), [&](Vertex copy) { points[copy.index] = Vertex(i); });
  }
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const auto [a, b] = ends(mesh, Edge(i));
    if (has_copies(mesh, a) || has_copies(mesh, b)) pairs.push_back(std::minmax(points[a.index], points[b.index]));
  }
  const std::size_t sheets = pairs.size();
  sort_unique(pairs);
  counts.edges -= static_cast<std::uint32_t>(sheets - pairs.size());
  return counts;
}

}  // namespace ryosen
