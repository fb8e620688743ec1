// Cuts the sheets of a surface apart and joins them as reading a file joins them, so that the mesh after an operator
// has the fans and edges that its own polygon list would be read as.
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
#include <span>
#include <vector>

#include "core/ops/op.h"

namespace ryosen {

// The half without a face of an edge that has one.
inline Halfedge outside_half(const Mesh& m, Halfedge h) { return m.is_outside(h) ? h : twin(h); }

// A fan of faces around a vertex: from the edge `first`, which it is left of, counter-clockwise to the edge `last`,
// both outgoing and `last` outside. Both none where the fan goes all the way round.
struct Fan {
  Halfedge first, last;
  Face lowest_face;

  bool is_closed() const { return first.is_none(); }
};

// Ascending by lowest face. O(valence).
std::vector<Fan> fans_at(const Mesh& mesh, Vertex v);

// The faces that edges with exactly two faces in opposite directions join to f, it first, then the nearer ones before
// the farther ones; stops with the face at which there are `enough`. O(faces found).
std::vector<Face> faces_of_sheet(const Mesh& mesh, Face f,
                                 std::size_t enough = std::numeric_limits<std::size_t>::max());
// The same, but stops also with the first face that `is_last` tells.
std::vector<Face> faces_of_sheet(const Mesh& mesh, Face f, std::size_t enough,
                                 const std::function<bool(Face)>& is_last);

// The surgery of one operator. It gathers what was made, deleted and changed; finish() tells.
class Sheets {
 public:
  explicit Sheets(Edit& edit) : edit_(edit), before_(edit.mesh().lengths()) {}

  // Makes a fan that shares its vertex with others, or with wires, a new copy of the point. Returns the copy.
  Vertex take_out(const Fan& fan);
  // One vertex per fan; the one with the lowest face stays, with the wires.
  void separate(Vertex v);
  // Lets `out` follow `into`: both outside, at one vertex or at two copies, which become one with the smaller number.
  // What lay between them goes to another gap of the vertex; where none is left it becomes a copy.
  void join_corner(Halfedge into, Halfedge out);
  // Two outside halfedges that follow each other there and back become one edge. The edge of h stays.
  void join_edges(Halfedge h, Halfedge back);
  // An edge with a face on both sides becomes two edges with an outside loop of two halves between them; h keeps its
  // face. Returns the halfedge of the other face. The edges join the same vertices until the caller takes fans out.
  Halfedge open(Halfedge h);
  // Around these points: edges that two faces run in opposite directions, and no third, become one edge; of all others
  // the faces come apart, except where the outside loop has exactly two halves. Vertices are one fan each where
  // anything had to be cut or joined. Points may be named by any live copy, dead vertices are passed over.
  void settle(std::span<const Vertex> points);
  // Deletes an isolated vertex. Where it names a point, another copy takes the number over.
  void remove_vertex(Vertex v);
  // Takes an edge out of the cycles that it is on.
  void remove_edge(Halfedge h);
  void remove_face(Face f);
  // Exchanges the numbers of two vertices, not their places and copies.
  void exchange(Vertex v, Vertex w);

  void changed(Face f);
  void changed_around(Vertex v);
  OpEffect finish();

 private:
  void rename(std::span<const Halfedge> leaving, Vertex v);
  bool is_closed_cut(Halfedge h) const;
  std::vector<Halfedge> sheets_to_open(std::vector<Vertex>& vertices) const;
  std::vector<Halfedge> sheets_to_join(std::span<const Vertex> vertices) const;
  void add_double_ends(std::span<const Vertex> vertices, std::vector<Vertex>& found) const;
  // Makes two edges with one face each, on opposite sides, one edge.
  void close_pair(Halfedge h, Halfedge other);
  void join_sheet(Halfedge h);
  void close_double_edges(Vertex v);
  void drop(Edge e);

  Edit& edit_;
  ColumnLengths before_;
  OpEffect effect_;
};

}  // namespace ryosen
