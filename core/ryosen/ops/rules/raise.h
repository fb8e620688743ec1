// Raises a region of faces on walls, as the polygon list says it, with the fans and edges that reading it would give.
//
//      o---o---o---o
//      | f | g | u |        f and g are of the region: the edge between them moves along, the one between g and u is of
//      a---b---c---o        the border; c stays behind with u, b only if it lies on the border
#pragma once

#include <span>
#include <unordered_set>
#include <vector>

#include "ryosen/mesh/mesh.h"
#include "ryosen/ops/op.h"

namespace ryosen {

// Faces that move together: where their border runs, and which of their points stay behind. All on points, with copies
// merged: the result does not depend on how the sheets are cut.
class Region {
 public:
  // Live faces; one that is named twice counts once. Cost: their corners, and the valences of their points that have
  // copies.
  Region(const Mesh& mesh, std::span<const Face> faces);

  // Each once, in their order.
  const std::vector<Face>& faces() const { return faces_; }
  bool contains(Face f) const { return f && set_.contains(f); }

  // An edge of the border, by its first side in the order of the faces. An edge is of the border if a face outside of
  // the region has it too, or no second side at all; a bridge is not.
  struct Border {
    Halfedge side;
    bool is_shared;  // other sides of the region run along it too
  };
  const std::vector<Border>& border() const { return border_; }

  // The points of the faces, each once, in their order.
  const std::vector<Vertex>& points() const { return points_; }
  // Whether the point (any copy of it) of a face lies on the border, or has another face or a wire.
  bool stays_behind(const Mesh& mesh, Vertex v) const;

 private:
  void find_border(const Mesh& mesh);
  void add_border(const Mesh& mesh, Halfedge side);
  bool is_held(const Mesh& mesh, Vertex p) const;

  std::vector<Face> faces_;
  std::vector<Border> border_;
  std::vector<Vertex> points_;
  std::unordered_set<Face> set_;
  std::unordered_set<Vertex> staying_;  // by representative
};

// In the faces of the region each point that stays behind is replaced by a new one, moved by `by`; its other points are
// moved. Each edge a -> b of the border gets a wall (a, b, b', a'), in the order of the border. Cost: the corners of
// the region and the fans at the points that stay behind.
OpEffect raise(Edit& edit, const Region& region, const glm::dvec3& by);

}  // namespace ryosen
