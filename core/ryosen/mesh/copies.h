// Points and their copies: several vertices that represent one point of the file, each with its own fan of faces.
//
//      \ f |            point 5 of a file with a bow-tie becomes two vertices, 5 and a copy, in one cyclic list;
//     f \ | /  g        figures, names and files refer to the point, the mesh stores its copies
//        5
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The representative of a point: its copy with the smallest number. O(1).
inline Vertex point(const Mesh& mesh, Vertex v) { return mesh.copy_point(v); }
inline bool has_copies(const Mesh& mesh, Vertex v) { return mesh.next_copy(v) != v; }
// Number of face fans at one vertex; wires do not count.
std::uint32_t count_fans(const Mesh& mesh, Vertex v);
// Whether the point of v has more than one fan of faces, through its copies or at the vertex itself.
inline bool has_several_fans(const Mesh& mesh, Vertex v) { return has_copies(mesh, v) || count_fans(mesh, v) > 1; }
inline bool same_point(const Mesh& mesh, Vertex a, Vertex b) { return point(mesh, a) == point(mesh, b); }

// All copies of a point, v first.
template <class Visit>
void for_each_copy(const Mesh& mesh, Vertex v, Visit visit) {
  Vertex copy = v;
  do {
    visit(copy);
    copy = mesh.next_copy(copy);
  } while (copy != v);
}

// Whether any copy of v is so; looks no further then.
template <class Is>
bool any_of_copies(const Mesh& mesh, Vertex v, Is is) {
  Vertex copy = v;
  do {
    if (is(copy)) return true;
    copy = mesh.next_copy(copy);
  } while (copy != v);
  return false;
}

// The valence of a point is that of all its copies. What is asked here of two points costs twice the smaller of the two
// valences, so it is cheap where only one is high.

// The halfedges from any copy of a to any copy of b, with or without a face: one per edge, in the order around the
// copies of a. Where there are several: the valence of a.
std::vector<Halfedge> sheets_between(const Mesh& mesh, Vertex a, Vertex b);
// One of them, whichever is met first, or none.
Halfedge any_sheet_between(const Mesh& mesh, Vertex a, Vertex b);
inline bool are_joined(const Mesh& mesh, Vertex a, Vertex b) { return bool(any_sheet_between(mesh, a, b)); }
// Of these points, of which there are some, the one of lowest valence, the first of equals. Cost: their number times
// that valence.
Vertex loneliest_point(const Mesh& mesh, std::span<const std::uint32_t> points);
// Whether there is another edge between the points of h.
bool has_several_sheets(const Mesh& mesh, Halfedge h);

// The faces along the edge between two points, over all sheets.
struct PointEdge {
  std::uint32_t forward = 0;   // faces that traverse it in the direction of the halfedge
  std::uint32_t backward = 0;  // and against it

  std::uint32_t faces() const { return forward + backward; }
  bool is_nonmanifold() const { return faces() >= 3; }
  bool is_misoriented() const { return faces() == 2 && forward != 1; }
  bool is_boundary() const { return faces() == 1; }
  bool is_regular() const { return !is_nonmanifold() && !is_misoriented(); }
};
// Counts until there are three faces or more, which is nonmanifold whatever follows.
PointEdge point_edge(const Mesh& mesh, Halfedge h);

// Whether the points of the halfedge are joined by a non-manifold or misoriented edge. O(1) where no end has copies.
bool is_cut_on_points(const Mesh& mesh, Halfedge h);

// Moves all copies of a point.
void move_point(Edit& edit, Vertex v, const glm::dvec3& position);

// Makes these vertices the copies of one point, in this cyclic order. No other vertex may be a copy of one of them.
void link_copies(Edit& edit, std::span<const Vertex> copies);
// Makes the copies of b copies of a's point, those from the successor of b on after a. They must be two points. Cost:
// the copies of the point with the larger number.
void join_copies(Edit& edit, Vertex a, Vertex b);
// Unlinks a copy from its point: it becomes a point of its own. O(copies).
void leave_copies(Edit& edit, Vertex v);

// Live elements with copies merged: points, and pairs of points joined by an edge, as in files and figures. O(1)
// without copies, else O(vertices + edges) and a sort of the edges at copies.
ElementCounts counts_on_points(const Mesh& mesh);

// Hubs: vertices of so many edges that not all of them can be looked at whenever something changes at one.
inline constexpr int most_edges_looked_at = 64;

// Counts on by the edges of a vertex, or by one if it has none, and tells whether there are many.
inline bool are_many_with(const Mesh& mesh, Vertex v, int& count) {
  if (mesh.is_isolated(v)) return ++count > most_edges_looked_at;
  for (Halfedge h = mesh.halfedge(v); ++count <= most_edges_looked_at;) {
    h = mesh.counter_clockwise(h);
    if (h == mesh.halfedge(v)) return false;
  }
  return true;
}

// Cost: at most 64 steps.
inline bool is_hub(const Mesh& mesh, Vertex v) {
  int count = 0;
  return are_many_with(mesh, v, count);
}

// Of a point, by all its copies together. Cost: at most 64 steps.
inline bool is_hub_point(const Mesh& mesh, Vertex v) {
  int count = 0;
  return any_of_copies(mesh, v, [&](Vertex copy) { return are_many_with(mesh, copy, count); });
}

}  // namespace ryosen
