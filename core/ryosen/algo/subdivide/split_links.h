// The links of a mesh whose every edge is cut in two, by index arithmetic.
//
//           v                   Old vertices keep their numbers; the new vertex of edge e is V + e, the centre of
//          /|\                  the k-th living face V + E + k. Halfedge h becomes first_half(h), from its start
//         / | \                 to the new vertex, and second_half(h); the two edges are 2 e and 2 e + 1.
//        m--+--m'               into_four: a triangle becomes four, of which the middle one keeps the number.
//         \ | /                 into_quads: a polygon becomes a quad per corner around its centre, of which the
//           c                   first one keeps the number.
//
// Edges are all alive and faces have no rings; dead vertices and faces keep their slots. Cost: one pass over the
// halfedges in the order of memory, on several threads.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen::subdivide {

enum class Split { into_four, into_quads };

// The two parts of a halfedge in the direction of the halfedge.
constexpr Halfedge first_half(Halfedge h) { return Halfedge(4 * (h.index >> 1u) + 3 * (h.index & 1u)); }
constexpr Halfedge second_half(Halfedge h) { return Halfedge(4 * (h.index >> 1u) + 2 - (h.index & 1u)); }

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

}  // namespace ryosen::subdivide
