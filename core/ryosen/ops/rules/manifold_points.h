// Points from which faces are taken away one after another: what is to be cut and joined there is found at the edges
// that lose a face, not at all copies of the points.
//
// Around a manifold point (Sheets::make_manifold) the loss of a face changes two things: an edge may be left with two
// faces in opposite directions, which are joined; and where a closed fan opens, an edge at which two faces of it were
// not cut apart may have to be. Both are rare, and then all is made manifold as for a single deletion.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

// In between nothing else changes the mesh.
class ManifoldPoints {
 public:
  explicit ManifoldPoints(Sheets& sheets) : sheets_(sheets) {}

  // Before the face is taken away.
  void loses(Face f);
  // Afterwards: as Sheets::make_manifold() at the points of these faces.
  void make_manifold();

 private:
  struct Side {
    Vertex low, high;  // points
    bool is_forward;
  };

  const Mesh& mesh() const { return sheets_.mesh(); }
  Side side_of(Halfedge h) const;
  // The faces along the edge, counted at the first call.
  PointEdge& faces_at(const Side& side);
  bool is_manifold_where_lost();
  bool opens_an_edge(Vertex v, Vertex p) const;

  Sheets& sheets_;
  std::unordered_set<Vertex> manifold_;
  std::unordered_map<std::uint64_t, PointEdge> edges_;
  // Sides and points of the deleted faces, and the vertices where a closed fan opens, with their points.
  std::vector<Side> sides_;
  std::vector<Vertex> points_;
  std::vector<std::pair<Vertex, Vertex>> opened_;
};

}  // namespace ryosen
