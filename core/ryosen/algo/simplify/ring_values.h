// The values (texture, colours) of a place beside an edge that collapses, or beside a vertex that moves.
#pragma once

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// A place on a face at one of these vertices, and its nearest place there by the shares of three corners.
struct RingPlace {
  std::array<Halfedge, 3> corners;  // the one at the vertex first
  std::array<double, 3> shares;
  double distance;  // scaled
};

// On all faces around an edge or a vertex: of a vertex of very many edges on those near the edge. A face that is no
// triangle counts as that of its corner and the two beside it.
class RingValues {
 public:
  // A place of the surface, scaled.
  RingValues(const CollapseSurface& surface, Halfedge h, const glm::dvec3& place);
  RingValues(const CollapseSurface& surface, Vertex v, const glm::dvec3& place);

  // Gives a vertex the means of vertices; attributes without means stay.
  void write_vertex(Edit& edit, Vertex to) const;
  // Before the edge collapses: gives the corners at both ends that lie in the chart of either side what lies at the
  // place in this chart, so that the collapse finds them equal and keeps it; and those in other charts around an end
  // that moves what lies there in theirs. `at`: the end that stays where it is, if one does. A corner without a value
  // stays so, and one whose chart has none at the place keeps its own. Cost: the valences.
  void write_corners(Edit& edit, Halfedge h, Vertex at) const;

 private:
  void add_around(const CollapseSurface& surface, Halfedge first, const glm::dvec3& place);
  void add(const CollapseSurface& surface, Halfedge corner, const glm::dvec3& place);
  // The nearest one whose first corner `is_asked`; null where there is none.
  template <class IsAsked>
  const RingPlace* nearest(const IsAsked& is_asked) const;

  std::vector<RingPlace> places_;
};

}  // namespace ryosen
