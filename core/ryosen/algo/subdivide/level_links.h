// The links of the next level of a subdivision, by index arithmetic: of a mesh whose every edge is cut in two, and of
// one step of the sqrt(3) scheme.
//
// Edges are all alive and faces have no rings; dead vertices and faces keep their slots. Old vertices keep their
// numbers. Cost: one pass over the halfedges in the order of memory, on several threads.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::subdivide {

enum class Split { into_four, into_quads };

// The two parts of a halfedge in the direction of the halfedge.
constexpr Halfedge first_half(Halfedge h) { return Halfedge(4 * (h.index >> 1u) + 3 * (h.index & 1u)); }
constexpr Halfedge second_half(Halfedge h) { return Halfedge(4 * (h.index >> 1u) + 2 - (h.index & 1u)); }

// The numbers where every edge is cut in two.
//
//           v                   The new vertex of edge e is V + e, the centre of the k-th living face V + E + k.
//          /|\                  Halfedge h becomes first_half(h), from its start to the new vertex, and
//         / | \                 second_half(h); the two edges are 2 e and 2 e + 1.
//        m--+--m'               into_four: a triangle becomes four, of which the middle one keeps the number.
//         \ | /                 into_quads: a polygon becomes a quad per corner around its centre, of which the
//           c                   first one keeps the number.
class SplitNumbers {
 public:
  SplitNumbers(const Mesh& mesh, Split split);

  Split split() const { return split_; }
  Vertex on_edge(Halfedge h) const { return Vertex(vertices_ + edge(h).index); }
  // The edge within the face at the corner where h begins (into_four) or from the new vertex on h to the centre.
  Halfedge inner(Halfedge h) const { return Halfedge(4 * edges_ + 2 * rank_of(h)); }
  // The new face at the corner where h begins.
  Face at_corner(Halfedge h) const { return child_.empty() ? Face(faces_ + rank_of(h)) : Face(child_[h.index]); }
  Vertex centre(Face f) const {
    return Vertex(vertices_ + edges_ + (centre_of_.empty() ? f.index : centre_of_[f.index]));
  }
  // Per face its rank among the living; empty where all live.
  const std::vector<std::uint32_t>& centre_of() const { return centre_of_; }
  std::uint32_t inside_count() const { return inside_count_; }

  // How many slots there are afterwards.
  std::size_t vertex_slots() const;
  std::size_t edge_slots() const { return 2 * std::size_t{edges_} + inside_count_; }
  std::size_t face_slots() const;

 private:
  std::uint32_t rank_of(Halfedge h) const { return rank_.empty() ? h.index : rank_[h.index]; }

  Split split_;
  std::uint32_t vertices_, edges_, faces_, live_faces_;
  std::uint32_t inside_count_ = 0;    // halfedges with a face
  std::vector<std::uint32_t> rank_;   // per halfedge among those with a face; empty where all have one
  std::vector<std::uint32_t> child_;  // per halfedge, into_quads
  std::vector<std::uint32_t> centre_of_;
};

// Fills the columns of connectivity, the live counts and file_vertices; places, copies and attributes are left.
void link_split(const Mesh& mesh, const SplitNumbers& numbers, MeshColumns& out);

// The numbers of the sqrt(3) scheme [Kobbelt00]: a vertex in each triangle, joined to its corners, then old edges are
// swapped.
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
// Triangles only; where creases are cut at most one edge of a triangle is kept. Behind the old vertices come the
// centres in the order of the faces, then x and y of the cut edges. Each halfedge with a face has a triangle of its
// own; that of a face's first halfedge keeps its number.
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

 private:
  const Mesh& mesh_;
  const Creases& creases_;
  bool cuts_creases_;
  std::vector<std::uint32_t> cut_;     // per edge
  std::vector<std::uint32_t> centre_;  // per face
  std::vector<std::uint32_t> spoke_;   // per halfedge
  std::vector<std::uint32_t> other_;   // per halfedge: those with a face that are not its first
};

// The same of that scheme.
void link_sqrt3(const Mesh& mesh, const Sqrt3Numbers& numbers, MeshColumns& out);

}  // namespace ryosen::subdivide
