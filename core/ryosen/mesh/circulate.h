// Circulators around vertices and faces: the nine incidence relations between vertices, edges and faces, O(1) per step.
//
// All ranges are views and stay valid until the mesh is edited. On a corrupt mesh a cycle that does not return to its
// start throws BrokenMesh, which names the halfedge, after at most halfedge_slots() + 1 steps.
#pragma once

#include <iterator>
#include <stdexcept>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// A cycle that does not close; what() names the halfedge it started at.
class BrokenMesh : public std::runtime_error {
 public:
  explicit BrokenMesh(Halfedge start);
  Halfedge start() const { return start_; }

 private:
  Halfedge start_;
};

namespace detail {
// Throws BrokenMesh; a loop over a mesh has one call for it, which is less to compile.
[[noreturn]] void throw_broken_mesh(Halfedge start);

// Steps from a halfedge to another one, and elements that ranges give for it.
inline Halfedge next(const Mesh& m, Halfedge h) { return m.next(h); }
inline Halfedge counter_clockwise(const Mesh& m, Halfedge h) { return m.counter_clockwise(h); }
inline Halfedge itself(const Mesh&, Halfedge h) { return h; }
inline Edge edge(const Mesh&, Halfedge h) { return ryosen::edge(h); }
inline Vertex from(const Mesh& m, Halfedge h) { return m.from(h); }
inline Vertex to(const Mesh& m, Halfedge h) { return m.to(h); }
inline Face face(const Mesh& m, Halfedge h) { return m.face(h); }
inline Face opposite_face(const Mesh& m, Halfedge h) { return m.face(twin(h)); }
}  // namespace detail

// The cycle of `step` from a halfedge, each halfedge visited once, mapped to an element by `map`. Empty if start is
// none.
template <auto step, auto map>
class CycleRange {
 public:
  class iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = decltype(map(std::declval<const Mesh&>(), Halfedge()));
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = value_type;

    iterator(const Mesh* mesh, Halfedge start)
        : mesh_(mesh), start_(start), current_(start), left_(mesh->halfedge_slots()) {}
    value_type operator*() const { return map(*mesh_, current_); }
    iterator& operator++() {
      current_ = step(*mesh_, current_);
      if (current_ == start_)
        current_ = Halfedge();
      else if (left_-- == 0 || current_.index >= mesh_->halfedge_slots())
        detail::throw_broken_mesh(start_);
      return *this;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.current_ == b.current_; }

   protected:
    const Mesh* mesh_;
    Halfedge start_, current_;
    std::uint32_t left_;
  };

  CycleRange(const Mesh& mesh, Halfedge start) : mesh_(&mesh), start_(start) {}
  iterator begin() const { return {mesh_, start_}; }
  iterator end() const { return {mesh_, Halfedge()}; }

 private:
  const Mesh* mesh_;
  Halfedge start_;
};

// The loops of a face one after another, the outer one first, mapped to an element by `map`.
template <auto map>
class FaceRange {
 public:
  class iterator : public CycleRange<detail::next, map>::iterator {
    using Loop = typename CycleRange<detail::next, map>::iterator;

   public:
    iterator(const Mesh* mesh, Halfedge start, std::uint32_t next_ring) : Loop(mesh, start), next_ring_(next_ring) {}
    iterator& operator++() {
      Loop::operator++();
      if (this->current_.is_none() && next_ring_ != no_index) {
        const Ring& ring = this->mesh_->ring(next_ring_);
        this->start_ = this->current_ = ring.halfedge;
        next_ring_ = ring.next;
      }
      return *this;
    }

   private:
    std::uint32_t next_ring_;
  };

  FaceRange(const Mesh& mesh, Face f) : mesh_(&mesh), start_(mesh.halfedge(f)), ring_(mesh.first_ring(f)) {}
  iterator begin() const { return {mesh_, start_, ring_}; }
  iterator end() const { return {mesh_, Halfedge(), no_index}; }

 private:
  const Mesh* mesh_;
  Halfedge start_;
  std::uint32_t ring_;
};

// Around a vertex (its one-ring), counter-clockwise. faces_around may yield none (the gap at a boundary).
inline auto outgoing(const Mesh& m, Vertex v) {
  return CycleRange<detail::counter_clockwise, detail::itself>(m, m.halfedge(v));
}
inline auto edges_around(const Mesh& m, Vertex v) {
  return CycleRange<detail::counter_clockwise, detail::edge>(m, m.halfedge(v));
}
inline auto neighbours(const Mesh& m, Vertex v) {
  return CycleRange<detail::counter_clockwise, detail::to>(m, m.halfedge(v));
}
inline auto faces_around(const Mesh& m, Vertex v) {
  return CycleRange<detail::counter_clockwise, detail::face>(m, m.halfedge(v));
}

// Around a loop of a face, or a boundary loop, in the direction of next.
inline auto loop(const Mesh& m, Halfedge start) { return CycleRange<detail::next, detail::itself>(m, start); }
// Around a face, counter-clockwise: its outer loop, then its rings. neighbour_faces may yield none.
inline auto halfedges_around(const Mesh& m, Face f) { return FaceRange<detail::itself>(m, f); }
inline auto vertices_around(const Mesh& m, Face f) { return FaceRange<detail::from>(m, f); }
inline auto edges_around(const Mesh& m, Face f) { return FaceRange<detail::edge>(m, f); }
inline auto neighbour_faces(const Mesh& m, Face f) { return FaceRange<detail::opposite_face>(m, f); }

// Both ends and both faces of an edge.
inline std::pair<Vertex, Vertex> ends(const Mesh& m, Edge e) {
  return {m.from(halfedge(e, 0)), m.from(halfedge(e, 1))};
}
inline std::pair<Face, Face> faces(const Mesh& m, Edge e) { return {m.face(halfedge(e, 0)), m.face(halfedge(e, 1))}; }

// Visits the vertex itself, both ends of a halfedge or an edge, or all corners of a face. Some may be copies of one
// point.
template <class Visit>
void for_each_vertex(const Mesh& m, const Element& e, Visit visit) {
  if (e.kind == Element::Kind::vertex) visit(e.vertex());
  if (e.kind == Element::Kind::face)
    for (Vertex v : vertices_around(m, e.face())) visit(v);
  if (e.kind == Element::Kind::edge || e.kind == Element::Kind::halfedge) {
    const Halfedge h = e.kind == Element::Kind::edge ? halfedge(e.edge()) : e.halfedge();
    visit(m.from(h));
    visit(m.to(h));
  }
}

// Number of corners over all loops.
inline std::uint32_t corner_count(const Mesh& m, Face f) {
  std::uint32_t n = 0;
  for ([[maybe_unused]] Halfedge h : halfedges_around(m, f)) ++n;
  return n;
}
inline bool is_triangle(const Mesh& m, Halfedge h) { return m.next(m.next(m.next(h))) == h && m.next(m.next(h)) != h; }

// The halfedge from a to b (the same sheet), or none. Cost: the valence of a.
inline Halfedge find_halfedge(const Mesh& m, Vertex a, Vertex b) {
  for (Halfedge h : outgoing(m, a))
    if (m.to(h) == b) return h;
  return Halfedge();
}

}  // namespace ryosen
