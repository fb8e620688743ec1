// Points and their copies: several vertices that represent one point of the file, each with its own fan of faces.
//
//      \ f |            point 5 of a file with a bow-tie becomes two vertices, 5 and a copy, in one cyclic list;
//     f \ | /  g        figures, names and files refer to the point, the mesh stores its copies
//        5
#pragma once

#include <vector>

#include "core/mesh/edit.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// The representative of a point: its copy with the smallest number. O(copies).
Vertex point(const Mesh& mesh, Vertex v);
inline bool has_copies(const Mesh& mesh, Vertex v) { return mesh.next_copy(v) != v; }
// Number of face fans at one vertex; wires do not count.
std::uint32_t count_fans(const Mesh& mesh, Vertex v);
// Whether the point of v has more than one fan of faces, through its copies or at the vertex itself.
inline bool has_several_fans(const Mesh& mesh, Vertex v) { return has_copies(mesh, v) || count_fans(mesh, v) > 1; }
inline bool same_point(const Mesh& mesh, Vertex a, Vertex b) {
  return a == b || (has_copies(mesh, a) && has_copies(mesh, b) && point(mesh, a) == point(mesh, b));
}

// All copies of a point, v first.
template <class Visit>
void for_each_copy(const Mesh& mesh, Vertex v, Visit visit) {
  Vertex copy = v;
  do {
    visit(copy);
    copy = mesh.next_copy(copy);
  } while (copy != v);
}

// The halfedges from any copy of a to any copy of b, with or without a face: one per edge.
std::vector<Halfedge> sheets_between(const Mesh& mesh, Vertex a, Vertex b);
// Whether there is any. Cost: twice the smaller of the two valences, so it is cheap for one vertex of high valence.
bool are_joined(const Mesh& mesh, Vertex a, Vertex b);

// The faces along the edge between two points, summed over all sheets.
struct PointEdge {
  std::uint32_t forward = 0;   // faces that traverse it in the direction of the halfedge
  std::uint32_t backward = 0;  // and against it

  std::uint32_t faces() const { return forward + backward; }
  bool is_nonmanifold() const { return faces() >= 3; }
  bool is_misoriented() const { return faces() == 2 && forward != 1; }
  bool is_boundary() const { return faces() == 1; }
  bool is_regular() const { return !is_nonmanifold() && !is_misoriented(); }
};
PointEdge point_edge(const Mesh& mesh, Halfedge h);

// Whether the points of the halfedge are joined by a non-manifold or misoriented edge. O(1) where no end has copies.
bool is_cut_on_points(const Mesh& mesh, Halfedge h);

// Moves all copies of a point.
void move_point(Edit& edit, Vertex v, const glm::dvec3& position);

// Unlinks a copy from its point: it becomes a point of its own.
void leave_copies(Edit& edit, Vertex v);

// Live elements with copies merged: points, and pairs of points joined by an edge, as in files and figures. O(1)
// without copies, else O(vertices + edges) and a sort of the edges at copies.
ElementCounts counts_on_points(const Mesh& mesh);

}  // namespace ryosen
