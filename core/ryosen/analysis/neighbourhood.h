// Adjacency queries on points, over all their copies: faces per edge, fans of faces, boundary chains, normals.
//
// Figures and problems refer to points and undirected edges between them; the mesh stores copies and cut edges. A
// Neighbourhood answers queries on points. If neither end of an edge has copies the answer is read from the links,
// otherwise from the star of the point, which is gathered once and cached.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// An edge on points, seen from the star's point.
struct StarEdge {
  Vertex neighbour;              // a point
  PointEdge faces;               // forward: away from the star's point
  Edge first_sheet;              // the lowest slot among the sheets with a face
  Face last_face;                // the highest face at it
  std::uint32_t first_side = 0;  // into sides: the first of its faces.faces() sides
};

// The face corners at a point. Corner c has two sides: 2c along corners[c], and 2c + 1 along the halfedge before it.
// Views into a Neighbourhood.
struct Star {
  std::span<const Halfedge> corners;            // outgoing halfedges; ascending
  std::span<const StarEdge> edges;              // ascending by neighbour
  std::span<const std::uint32_t> sides;         // of all corners, grouped by edge
  std::span<const std::uint32_t> edge_of_side;  // into edges
  std::uint32_t fans = 0;                       // groups of corners connected by shared edges, whatever their direction
  bool has_nonmanifold_edge = false;

  // The edge to a point, or null.
  const StarEdge* edge_to(Vertex neighbour_point) const;
  // The boundary side at the other end of a boundary side's fan, or no_index if an edge with three or more faces ends
  // the fan.
  std::uint32_t other_boundary_side(std::uint32_t side) const;
};

// A step along a boundary: the halfedge with the face of a boundary edge, and whether the walk leaves it at its end or
// at its origin.
struct BoundaryStep {
  Halfedge inside;
  bool at_end = true;
};

// Refers to the mesh, which must outlive it and not change.
class Neighbourhood {
 public:
  // `whole` prepares for queries about every element: O(vertices) once a star is asked for. With `local` each query
  // costs only the stars it touches.
  enum class Reach { local, whole };
  explicit Neighbourhood(const Mesh& mesh, Reach reach = Reach::local)
      : mesh_(mesh), is_whole_(reach == Reach::whole) {}

  const Mesh& mesh() const { return mesh_; }

  Vertex point(Vertex v) const { return ryosen::point(mesh_, v); }
  // Whether a vertex has no copies and at most one gap; then it has one fan of faces, or none.
  bool is_plain(Vertex v) const;
  // Whether the edge between the two points has only this sheet: at most one edge joins two vertices.
  bool is_single_sheet(Halfedge h) const {
    return !has_copies(mesh_, mesh_.from(h)) && !has_copies(mesh_, mesh_.to(h));
  }

  // Over all copies. Cost: the corners there, on the first call only. Valid until the next call of any member.
  Star star(Vertex v);

  // The faces between the points of h, forward along h.
  PointEdge edge(Halfedge h);
  // Whether e is the representative sheet of its edge on points: the lowest slot with a face.
  bool is_first_sheet(Edge e);
  // Whether an edge without faces has none on points either, and is the lowest slot of those.
  bool is_first_wire(Edge e);
  // The highest face at the edge on points.
  Face last_face(Halfedge h);
  // All faces at it, one entry per side.
  void faces_at(Halfedge h, std::vector<Face>& faces);
  // If exactly two faces share the edge of h (which has a face): the halfedge of the other one. Else none.
  Halfedge across(Halfedge h);
  // If exactly two faces share the edge on points and e represents it: a side in each, the first one on e. Else none.
  struct TwoSides {
    Halfedge first, second;
  };
  TwoSides two_sides(Edge e);
  // Whether two sides of one edge on points have the same direction: their faces are then inconsistently oriented.
  bool run_alike(Halfedge a, Halfedge b) const { return point(mesh_.from(a)) == point(mesh_.from(b)); }
  // Fans of faces at the point.
  std::uint32_t fans(Vertex v);

  // The unit normal of a face (of its vector area); zero if the area is zero or a position is not finite. Cost: the
  // corners; cached for faces with many.
  glm::dvec3 normal(Face f);

  // The next boundary edge of the chain, through the fan of faces at the end; `inside` is none if the chain stops at a
  // non-manifold edge.
  BoundaryStep next_boundary(BoundaryStep step);

 private:
  // The ranges of a star in the pools.
  struct StarRecord {
    std::uint32_t first_corner = 0, corners = 0, first_edge = 0, edges = 0, fans = 0;
    bool has_nonmanifold_edge = false;
  };

  Edge first_wire(Edge e);
  StarEdge star_edge(Halfedge h, bool& reversed);
  std::uint32_t& record_of(Vertex p);
  void gather_corners(Vertex p, StarRecord& record);
  void gather_edges(StarRecord& record);
  void join_fans(StarRecord& record);
  Star view(const StarRecord& record) const;

  const Mesh& mesh_;
  // An array by slot with Reach::whole, a map otherwise.
  std::vector<std::uint32_t> record_of_point_;
  std::unordered_map<Vertex, std::uint32_t> known_records_;
  std::unordered_map<Face, glm::dvec3> known_normals_;
  std::unordered_map<std::uint64_t, Edge> first_wires_;  // by both points; with Reach::whole all that have copies

  std::vector<StarRecord> records_;
  std::vector<Halfedge> corners_;
  std::vector<std::uint32_t> sides_, edge_of_side_;  // two per corner
  std::vector<StarEdge> edges_;
  std::vector<std::pair<Vertex, std::uint32_t>> order_;  // sides by neighbour, of the star being gathered
  DisjointSets fans_;
  bool is_whole_;
};

// The corners of face f as points.
void points_of_face(Neighbourhood& around, Face f, std::vector<Vertex>& points);

}  // namespace ryosen
