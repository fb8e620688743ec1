// What lies under the pointer: the front-most vertex, edge or face, asked of a tree of the drawn triangles.
#pragma once

#include <optional>
#include <vector>

#include "core/base/element.h"
#include "core/mesh/mesh.h"
#include "core/mesh/touched.h"
#include "core/pick/bvh.h"
#include "core/pick/surface_triangles.h"
#include "core/view/camera.h"

namespace ryosen {

enum class PickMode { vertex, edge, face, halfedge };

// How far from the pointer edges and vertices are taken.
inline constexpr double pick_radius_px = 6;

struct Picked {
  Element element;         // of the kind that was asked for
  Halfedge halfedge;       // for an edge: the half of the face under the pointer, or of a face at the edge
  double along = 0.5;      // for an edge: the place nearest to the pointer, 0 at from(halfedge)
  Face face;               // the face under the pointer; none beside the surface
  glm::dvec3 place{0};     // on the element
  double distance_px = 0;  // from the pointer, 0 for a face
};

// Keeps the triangles of a mesh and a tree over them, the wires and the isolated vertices. Every call gets the same mesh.
// The tree is built by the first pick: a picture that nobody points at does without.
class Picker {
 public:
  explicit Picker(const Mesh& mesh) : triangles_(mesh) {}

  // Follows a change of the mesh; returns the triangle slots that changed. Cost: what was touched.
  std::vector<std::uint32_t> update(const Mesh& mesh, const TouchedElements& touched);

  // Of the elements within pick_radius_px that no nearer surface hides at their place: the one with the smallest
  // distance on the screen, then the least depth, then the smallest number. Pixels count from the upper left corner.
  std::optional<Picked> pick(const Mesh& mesh, const Camera& camera, Size view, glm::dvec2 pixel, PickMode mode);

  const SurfaceTriangles& triangles() const { return triangles_; }

 private:
  void build(const Mesh& mesh);
  void put_triangle(const Mesh& mesh, std::uint32_t slot);
  void put_vertex(const Mesh& mesh, Vertex v);
  void put_wire(const Mesh& mesh, Edge e);

  SurfaceTriangles triangles_;
  Bvh tree_;
  bool has_tree_ = false;
};

}  // namespace ryosen
