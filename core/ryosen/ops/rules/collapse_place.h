// What stands around an edge that would collapse: the questions whose answers cost no more than the smaller of its
// ends.
#pragma once

#include <array>
#include <vector>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/local_facts.h"

namespace ryosen {

struct CollapsePlace {
  // h goes from the removed to the remaining vertex; the removed one has no copies.
  CollapsePlace(const Mesh& mesh, Halfedge h);

  bool is_apex(Vertex v) const;
  bool is_at_edge(Face f) const { return f == mesh.face(h) || f == mesh.face(twin(h)); }
  // A corner of a triangle that vanishes.
  bool is_dropped(Halfedge corner) const { return is_at_edge(mesh.face(corner)) && is_triangle_side(mesh, corner); }
  bool is_tip_of_three_edge_hole(Vertex v) const;

  // Whether the ends have a neighbour in common that may be in the way: no if not, else perhaps, or surely. In that
  // way: whether there is a common face beside those at the edge, whether loops of a face may break, and whether two
  // faces may get the same points, where the ends share nothing but the apexes.
  bool may_share_neighbours() const;
  bool surely_share_a_neighbour() const;
  bool may_share_faces() const;
  bool may_break_loops(LocalFacts& known) const;
  bool may_make_duplicates() const;

  // Whether a wire beside the edge joins the ends.
  bool has_other_wire() const;

  const Mesh& mesh;
  Halfedge h;
  Vertex gone, kept;
  std::array<Vertex, 2> apexes;  // of the triangles at the edge
  std::size_t apex_count = 0;

 private:
  enum class Shares { no, perhaps, surely };
  Shares shares_neighbour(Halfedge k) const;
  void find_smaller_star();
  // Whether the other end is a corner of the face.
  bool reaches_beyond(Face f) const;
  bool may_make_triangles_equal() const;
  bool may_equal_another(Halfedge corner) const;

  std::vector<Halfedge> smaller_;  // what begins at the end of lower valence, over all copies
  Vertex beyond_;                  // the other end
};

}  // namespace ryosen
