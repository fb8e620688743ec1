// Cuts and joins sheets of the surface as from_indexed does, so that after an operator the mesh has the same fans and
// edges as if its polygon list were read again.
//
//        a     c               a     c
//        | ' f |    take_out   | ' f |
//           v          =>         v           the fan of g gets a vertex of its own, a copy of the point
//        | ' g |                  v'
//        b     d               | ' g |
//                              b     d
#pragma once

#include <functional>
#include <limits>
#include <set>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ryosen/mesh/edit.h"
#include "ryosen/ops/op.h"

namespace ryosen {

// The boundary halfedge of a boundary edge.
inline Halfedge outside_half(const Mesh& m, Halfedge h) { return m.is_outside(h) ? h : twin(h); }

// A fan of faces around a vertex: counter-clockwise from `first`, which has a face of the fan, to `last`, which has
// none; both outgoing. Both none for a closed fan.
struct Fan {
  Halfedge first, last;
  Face lowest_face;

  bool is_closed() const { return first.is_none(); }
};

// The live copies of the points, each given by any of them, ascending.
std::vector<Vertex> live_copies(const Mesh& mesh, std::span<const Vertex> given);

// Ascending by lowest face. O(valence).
std::vector<Fan> fans_at(const Mesh& mesh, Vertex v);

// The faces connected to f through edges with exactly two faces in opposite directions, in breadth-first order from f;
// stops when there are `enough`. O(faces found).
std::vector<Face> faces_of_sheet(const Mesh& mesh, Face f,
                                 std::size_t enough = std::numeric_limits<std::size_t>::max());
// The same, but also stops after the first face that satisfies `is_last`.
std::vector<Face> faces_of_sheet(const Mesh& mesh, Face f, std::size_t enough,
                                 const std::function<bool(Face)>& is_last);

// Copies of points: one surgery adds many and takes many out, each at a cost that does not grow with their number.
//
// The links of a mesh lead from a copy to the next one alone, so that the one before it is found by a walk around all
// of them. Here it is kept for points with many copies, from the second walk on. Knows of changes that are made through
// it alone.
class CopyRings {
 public:
  explicit CopyRings(Edit& edit) : edit_(edit) {}

  // As join_copies().
  void join(Vertex a, Vertex b);
  // As leave_copies(); where v is the copy after another one, which is named, without a walk around all of them.
  void leave(Vertex v, Vertex other);
  // Unlinks these copies of one point, each once. Where the representative goes and others stay, one of these is
  // unlinked in its place, which is returned: the last one with edges or, if there is none, the last one.
  Vertex leave_all(std::span<const Vertex> going);

 private:
  bool knows(Vertex p) const { return rings_.contains(p); }
  // At the second call for a point with so many copies that walks around them cost more than what is kept.
  bool get_to_know(Vertex p);
  void know(Vertex p);
  void unlink(Vertex v, Vertex before);
  Vertex leave_small(std::span<const Vertex> going);

  Edit& edit_;
  std::unordered_map<Vertex, std::set<Vertex>> rings_;  // by point
  std::unordered_map<Vertex, Vertex> before_;           // of the copies there
  std::unordered_set<Vertex> walked_;                   // points
};

// What is known of a point that others are joined to, one after another: all around it is as make_manifold() leaves it,
// but for what is listed.
struct ManifoldPoint {
  Vertex at;                        // one of its copies; none: nothing is known
  std::vector<Vertex> changed;      // vertices of it around which something else has changed since then
  std::vector<Vertex> maybe_split;  // vertices that may have several fans
  // The same of other points, whose copies have all been looked at: their vertices that may have several fans.
  std::unordered_map<Vertex, std::vector<Vertex>> beside;
  CopyRings* rings = nullptr;  // shared by all who do so
  std::uint64_t looks = 0;     // halfedges that were looked at so far: what the work is measured by
};

// The surgery of one operator. Records what was created, deleted and changed; finish() returns it.
class Sheets {
 public:
  Sheets(const Sheets&) = delete;
  Sheets& operator=(const Sheets&) = delete;
  explicit Sheets(Edit& edit) : edit_(edit), own_rings_(edit), before_(edit.mesh().lengths()) {}
  // One of several in a row, between which copies are linked in no other way.
  Sheets(Edit& edit, CopyRings& shared) : Sheets(edit) { rings_ = &shared; }
  const Mesh& mesh() const { return edit_.mesh(); }

  // Moves a fan that shares its vertex with other fans or wires to a new copy of the point. Returns the copy.
  Vertex take_out(const Fan& fan);
  // Splits v into one vertex per fan; the fan with the lowest face stays, with the wires.
  void separate(Vertex v);
  // Makes `out` the next of `into`: both boundary halfedges, at one vertex or at two copies, which are merged to the
  // smaller number. What was between them moves to another gap of the vertex, or to a new copy if there is none.
  void join_corner(Halfedge into, Halfedge out);
  // Joins two boundary halfedges that form a loop of two into one edge. The edge of h stays.
  void join_edges(Halfedge h, Halfedge back);
  // Splits an edge with two faces into two edges with a boundary loop of two halfedges between them; h keeps its face.
  // Returns the halfedge of the other face. The edges join the same vertices until the caller calls take_out.
  Halfedge open(Halfedge h);
  // Restores the structure that reading gives, around these points: exactly two faces in opposite directions share one
  // edge; at all other edges the faces are cut apart, unless the boundary loop has exactly two halfedges. Where
  // anything was cut or joined, every vertex gets one fan. Points may be given by any live copy; dead vertices are
  // skipped. Returns the vertices around which it cut or joined, their copies among them.
  std::vector<Vertex> make_manifold(std::span<const Vertex> points);
  // Whether make_manifold() would find nothing to do there.
  bool is_manifold(std::span<const Vertex> points);
  // The same around a known point that these vertices have become copies of. Cost: what is around them and around what
  // is listed, which is kept.
  void make_joined_manifold(std::vector<Vertex> joined, ManifoldPoint& known);
  // Deletes an isolated vertex. If it is the representative of its point, another copy takes over the number.
  void remove_vertex(Vertex v) { remove_vertices({&v, 1}); }
  // The same for several, given in descending order. Cost: the copies of their points, once for all calls.
  void remove_vertices(std::span<const Vertex> descending);
  // Unlinks an edge from its cycles and deletes it.
  void remove_edge(Halfedge h);
  void remove_face(Face f);
  // Swaps the numbers of two vertices: their halfedges, not their positions and copies.
  void exchange(Vertex v, Vertex w);
  // Makes the copies of one point copies of another.
  void join_points(Vertex a, Vertex b) { rings_->join(a, b); }

  void changed(Face f);
  void changed_around(Vertex v);
  OpEffect finish();
  // Halfedges that were looked at to find what is to be cut and joined.
  std::uint64_t looks() const { return looks_; }

 private:
  void rename(std::span<const Halfedge> leaving, Vertex v);
  bool is_closed_cut(Halfedge h) const;
  std::vector<Halfedge> sheets_to_open(std::vector<Vertex>& vertices);
  void open_beside(std::span<const Halfedge> to_join, std::vector<Halfedge>& to_open);
  std::vector<Halfedge> sheets_to_join(std::span<const Vertex> vertices);
  std::vector<Halfedge> first_halves(std::span<const Halfedge> halves, Vertex at) const;
  std::vector<Vertex> left_at(ManifoldPoint& known, std::span<const Vertex> touched);
  void add_double_ends(std::span<const Vertex> vertices, std::vector<Vertex>& found);
  // Joins two edges with one face each, on opposite sides, into one.
  void close_pair(Halfedge h, Halfedge other);
  void join_sheet(Halfedge h);
  void close_double_edges(Vertex v);
  // At these, and at the copies that closing makes of them for wires: those are added.
  void close_double_edges(std::vector<Vertex>& vertices);
  void drop(Edge e);

  Edit& edit_;
  CopyRings own_rings_;
  CopyRings* rings_ = &own_rings_;
  ColumnLengths before_;
  OpEffect effect_;
  std::uint64_t looks_ = 0;
};

}  // namespace ryosen
