// The links of one step of the sqrt(3) scheme [Kobbelt00]: a vertex in each triangle, joined to its corners, then old
// edges are swapped.
//
//        o                 o
//       / \               /|\             An edge that is kept (a boundary, a crease) is not swapped; by every
//      / c \      =>     c-+-c            second step it is cut in three, x and y, and its triangle gets no centre:
//     o-----o             \|/
//                          o              p           p
//                                        / \    =>   / \                                                   .
//    the swapped edge joins the          /   \      / | | \                                                .
//    centres of its two faces           a=====b    a==x=y==b
//
// Triangles only, edges all alive, no rings; where creases are cut at most one edge of a triangle is kept. Old vertices
// keep their numbers; then come the centres in the order of the faces, then x and y of the cut edges. Each halfedge
// with a face has a triangle of its own; that of a face's first halfedge keeps its number.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::subdivide {

class Sqrt3Numbers {
 public:
  Sqrt3Numbers(const Mesh& mesh, const Creases& creases, bool cuts_creases);

  bool is_kept(Halfedge h) const { return creases_.sharpness_of(mesh_, h) > 0; }
  bool is_cut(Halfedge h) const { return cuts_creases_ && is_kept(h); }
  // The kept edge of a triangle that is cut, as its halfedge there; none if there is none.
  Halfedge cut_side(Halfedge h) const;
  bool has_centre(Face f) const { return mesh_.is_alive(f) && !cut_side(mesh_.halfedge(f)); }
  Vertex centre(Face f) const { return Vertex(mesh_.vertex_slots() + centre_[f.index]); }
  // The two vertices on a cut edge in the direction of h, and its three parts.
  Vertex third(Halfedge h, unsigned i) const;
  Halfedge part(Halfedge h, unsigned i) const;
  // The apex of h's triangle: the centre, or the nearest new vertex on the cut side. h itself is not cut.
  Vertex apex(Halfedge h) const;
  // From apex(h) to where h begins, and from where h ends to apex(h).
  Halfedge before(Halfedge h) const;
  Halfedge after(Halfedge h) const;
  // An edge from a corner or its apex, p-x and p-y: even halves lead away from where the halfedge begins, from p.
  Halfedge spoke(Halfedge h) const { return Halfedge(2 * (mesh_.edge_slots() + spoke_[h.index])); }
  Face triangle(Halfedge h) const;

  std::size_t vertex_slots() const {
    return std::size_t{mesh_.vertex_slots()} + centre_.back() + 2 * std::size_t{cut_.back()};
  }
  std::size_t edge_slots() const {
    return std::size_t{mesh_.edge_slots()} + spoke_.back() + 2 * std::size_t{cut_.back()};
  }
  std::size_t face_slots() const { return std::size_t{mesh_.face_slots()} + other_.back(); }
  std::uint32_t first_third() const { return mesh_.vertex_slots() + centre_.back(); }

 private:
  const Mesh& mesh_;
  const Creases& creases_;
  bool cuts_creases_;
  std::vector<std::uint32_t> cut_;     // per edge
  std::vector<std::uint32_t> centre_;  // per face
  std::vector<std::uint32_t> spoke_;   // per halfedge
  std::vector<std::uint32_t> other_;   // per halfedge: those with a face that are not its first
};

// Writes the links into `out`; see link_split().
void link_sqrt3(const Mesh& mesh, const Sqrt3Numbers& numbers, MeshColumns& out);

}  // namespace ryosen::subdivide
