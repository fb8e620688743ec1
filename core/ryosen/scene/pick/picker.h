// Picking: the front-most vertex, edge or face at a pixel, or all in a region of the screen, by a BVH over the drawn
// triangles.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/analysis/surface_triangles.h"
#include "ryosen/base/element.h"
#include "ryosen/base/progress.h"
#include "ryosen/base/recent_cells.h"
#include "ryosen/geometry/ray.h"
#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/pick/hidden_elements.h"
#include "ryosen/scene/view/camera.h"
#include "ryosen/scene/view/clip_plane.h"

namespace ryosen {

enum class PickMode { vertex, edge, face, halfedge };

// Maximum distance from the pointer at which edges and vertices are picked, at display scale 1.
inline constexpr double pick_radius_px = 6;

struct Picked {
  Element element = {};    // of the requested kind
  Halfedge halfedge = {};  // for an edge: the half of the face under the pointer, or of a face at the edge
  double along = 0.5;      // for an edge: parameter of the point nearest to the pointer, 0 at from(halfedge)
  Face face = {};          // the face under the pointer, or none
  glm::dvec3 place{0};     // on the element, in mesh space
  double distance_px = 0;  // from the pointer, 0 for a face
};

// A region of the picture: a polygon of pixels, as a box or a lasso draws it.
class ScreenRegion {
 public:
  // Inside is what an odd number of its sides surrounds. With fewer than three corners it holds nothing.
  explicit ScreenRegion(std::vector<glm::dvec2> corners);
  static ScreenRegion box(glm::dvec2 a, glm::dvec2 b);

  // O(corners) within its bounding box, else O(1).
  bool holds(glm::dvec2 pixel) const;

 private:
  std::vector<glm::dvec2> corners_;
  glm::dvec2 low_{0}, high_{0};
};

// What is moved just now, and not where the mesh has it: neither picked nor in the way of what lies behind.
struct PassedOver {
  IndexSet faces, vertices;  // an edge where one of its ends is
};

// Whether no surface in the tree but that of `own`, and of the faces that are passed over, lies clearly in front of a
// place, which the ray goes through.
bool is_seen(const Bvh& tree, const Mesh& mesh, const Ray& ray, const glm::dvec3& place, Face own = {},
             const IndexSet* passed_over = nullptr);

// Holds the triangles of a mesh and a BVH over them, the wires and the isolated vertices. Pass the same mesh to every
// call. The BVH is built by the first pick, so rendering alone does not pay for it.
class Picker {
 public:
  // What is hidden is not picked and hides nothing; it outlives the picker.
  explicit Picker(const Mesh& mesh, const HiddenElements* hidden = nullptr) : triangles_(mesh), hidden_(hidden) {}

  // Updates after an edit of the mesh; returns the triangle slots that changed. Cost: the touched elements.
  std::vector<std::uint32_t> update(const Mesh& mesh, const TouchedElements& touched);

  // After these have been hidden or shown. Cost: theirs, or the next pick builds the BVH anew.
  void update_hidden(const Mesh& mesh, const HiddenElements::Parts& changed);

  // Through: what a surface is in front of is picked too.
  enum class Depth { seen, through };

  // What is beyond a plane is not picked and hides nothing.
  void set_clip(const std::optional<ClipPlane>& plane) { clip_ = plane; }

  // Among the elements within the radius that are not occluded: the one with the smallest screen distance, then the
  // smallest depth, then the face under the pointer, then the smallest number. Pixels from the upper left corner.
  std::optional<Picked> pick(const Mesh& mesh, const Camera& camera, Size view, glm::dvec2 pixel, PickMode mode,
                             Depth depth = Depth::seen, double radius_px = pick_radius_px,
                             const PassedOver* passed_over = nullptr);

  // All elements, ascending, of which all points lie within the region, points in place of vertices. Seen: no surface
  // is clearly in front of the vertex, the middle of the edge, or that of a triangle of the face. Cost: the slots of
  // that kind, and a ray for each that lies within.
  std::vector<Element> pick_region(const Mesh& mesh, const Camera& camera, Size view, const ScreenRegion& region,
                                   PickMode mode, Depth depth);

  // Whether no surface but that of `own` lies clearly in front of a place that is drawn at a pixel.
  bool is_seen(const Mesh& mesh, const Camera& camera, Size view, const ScreenPoint& at, const glm::dvec3& place,
               Face own = {});

  // Builds the BVH now, unless it is there or `progress` cancels; may be interrupted (interruption.h). No other call
  // but triangles() may go on meanwhile.
  void prepare(const Mesh& mesh, Progress& progress);

  const SurfaceTriangles& triangles() const { return triangles_; }

  // Slots of triangles that are to be drawn anew, also those with other normals: noted by update() and by who keeps
  // what is drawn with them.
  const RecentCells<std::uint32_t>& changed_slots() const { return changed_slots_; }
  void note_changed(std::span<const std::uint32_t> slots) {
    for (const std::uint32_t slot : slots) changed_slots_.add(slot);
  }

 private:
  void build(const Mesh& mesh, Progress& progress);
  void put_triangle(const Mesh& mesh, std::uint32_t slot);
  void put_vertex(const Mesh& mesh, Vertex v);
  void put_wire(const Mesh& mesh, Edge e);
  // Whether it is in the tree.
  bool shows(const Mesh& mesh, const SurfaceTriangle& triangle) const;
  bool shows(const Mesh& mesh, Vertex v) const;
  bool shows(const Mesh& mesh, Edge e) const;

  SurfaceTriangles triangles_;
  const HiddenElements* hidden_;
  std::optional<ClipPlane> clip_;
  Bvh tree_;
  bool has_tree_ = false;
  RecentCells<std::uint32_t> changed_slots_;
};

}  // namespace ryosen
