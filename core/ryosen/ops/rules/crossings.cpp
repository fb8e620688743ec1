#include "ryosen/ops/rules/crossings.h"

#include <algorithm>
#include <array>
#include <limits>

#include "ryosen/analysis/overlap_tree.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

namespace {

// Beyond this the search would be noticeable while hovering.
constexpr std::size_t most_corners = 5000;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Triangle = std::array<glm::dvec3, 3>;

// A hash set of handles with inline storage while it is small.
template <class Handle>
class HandleSet {
 public:
  // Returns whether it was inserted.
  bool insert(Handle handle) {
    if (2 * (size_ + 1) > slots().size()) grow();
    Handle& slot = find(slots(), handle);
    if (slot == handle) return false;
    slot = handle;
    ++size_;
    return true;
  }

 private:
  std::span<Handle> slots() { return many_.empty() ? std::span<Handle>(few_) : std::span<Handle>(many_); }
  static Handle& find(std::span<Handle> slots, Handle handle) {
    std::size_t i = handle.index * std::size_t{2654435769u} >> 8u;
    while (slots[i &= slots.size() - 1] && slots[i] != handle) ++i;
    return slots[i];
  }
  void grow() {
    std::vector<Handle> more(2 * slots().size());
    for (Handle handle : slots())
      if (handle) find(more, handle) = handle;
    many_ = std::move(more);
  }

  std::array<Handle, 256> few_{};
  std::vector<Handle> many_;
  std::size_t size_ = 0;
};

// All of space where a coordinate is not finite.
Box box_of(const Mesh& mesh, Face f) {
  Box box;
  for (Vertex v : vertices_around(mesh, f)) {
    if (!is_finite(mesh.position(v))) return {glm::dvec3(-infinity), glm::dvec3(infinity)};
    box.add(mesh.position(v));
  }
  return box;
}

// A face with its bounding box and its range in the list of triangles.
struct Shape {
  Face face;
  Box box;
  std::size_t first = 0, end = 0;
};

// Triangulates faces on demand.
class Shapes {
 public:
  explicit Shapes(const Mesh& mesh) : mesh_(mesh) {}

  Shape make(Face f, const Box& box) {
    Shape shape{f, box, triangles_.size(), 0};
    const Halfedge a = mesh_.halfedge(f);
    if (is_triangle(mesh_, a) && !mesh_.has_rings(f))
      triangles_.push_back({place(a), place(mesh_.next(a)), place(mesh_.prev(a))});
    else
      add_polygon(f);
    shape.end = triangles_.size();
    return shape;
  }

  bool cross(const Shape& a, const Shape& b) const {
    if (!a.box.overlaps(b.box)) return false;
    for (std::size_t i = a.first; i < a.end; ++i)
      for (std::size_t k = b.first; k < b.end; ++k)
        if (!share_a_side(triangles_[i], triangles_[k]) && triangles_cross(triangles_[i], triangles_[k])) return true;
    return false;
  }

 private:
  const glm::dvec3& place(Halfedge h) const { return mesh_.position(mesh_.from(h)); }
  void add_polygon(Face f) {
    polygon_.read(mesh_, f);
    const std::vector<glm::dvec3>& places = polygon_.places();
    if (!mesh_.has_rings(f))
      triangulate(places, corners_);
    else if (polygon_.is_finite())
      polygon_.triangulate(corners_);
    else
      return;
    for (const CornerTriangle& t : corners_) triangles_.push_back({places[t[0]], places[t[1]], places[t[2]]});
  }
  // Triangles with two common corners do not count as crossing: every side touches a common corner.
  static bool share_a_side(const Triangle& s, const Triangle& t) {
    int shared = 0;
    for (const glm::dvec3& p : s) shared += p == t[0] || p == t[1] || p == t[2];
    return shared >= 2;
  }

  const Mesh& mesh_;
  std::vector<Triangle> triangles_;
  FacePolygon polygon_;
  std::vector<CornerTriangle> corners_;
};

// The faces, followed by those in their two-ring, each one-ring visited once; empty if they have too many corners.
std::vector<Face> two_rings_around(const Mesh& mesh, const std::vector<Face>& faces) {
  std::vector<Face> all;
  all.reserve(128);
  HandleSet<Face> seen;
  HandleSet<Vertex> stars;
  std::size_t corners = 0;
  const auto add = [&](Face f) {
    if (!f || !seen.insert(f)) return;
    all.push_back(f);
    for ([[maybe_unused]] Halfedge h : halfedges_around(mesh, f))
      if (++corners > most_corners) break;
  };
  for (Face f : faces) add(f);
  std::size_t begin = 0;
  for (int ring = 0; ring < 2; ++ring) {
    const std::size_t end = all.size();
    for (; begin < end; ++begin) {
      for (Vertex v : vertices_around(mesh, all[begin])) {
        if (!stars.insert(v)) continue;
        for (Face g : faces_around(mesh, v)) {
          add(g);
          if (corners > most_corners) return {};
        }
      }
    }
  }
  return all;
}

// A tree pays from here on.
constexpr std::size_t many_faces = 64;

// Whether the faces are triangles with an area: then a tree over them misses no pair that crosses.
bool are_sound_triangles(const NumberedSurface& surface, const std::vector<Shape>& shapes) {
  if (surface.slots() != shapes.size()) return false;
  for (std::uint32_t slot = 0; slot < surface.slots(); ++slot)
    if (surface.is_flat(slot) || surface.face(slot) != shapes[slot].face) return false;
  return true;
}

// Calls visit(i, k) for pairs of shapes that may cross, one of them among the first `live`.
template <class Visit>
void for_each_candidate(const Mesh& mesh, const std::vector<Shape>& shapes, std::size_t live, const Visit& visit) {
  if (live > many_faces) {
    std::vector<Face> faces;
    for (const Shape& shape : shapes) faces.push_back(shape.face);
    const NumberedSurface surface(mesh, faces);
    if (are_sound_triangles(surface, shapes)) {
      const OverlapTree tree(surface, 1);
      const auto may = [&](std::uint32_t a, std::uint32_t b) { return std::min(a, b) < live; };
      for (std::uint32_t node = 0; node < tree.node_count(); ++node)
        tree.visit_pairs(node, may, [&](std::uint32_t a, std::uint32_t b) {
          visit(a, b);
          return true;
        });
      return;
    }
  }
  for (std::size_t i = 0; i < live; ++i)
    for (std::size_t k = i + 1; k < shapes.size(); ++k) visit(i, k);
}

}  // namespace

std::vector<Crossing> crossings_near(const Mesh& mesh, std::span<const Face> faces) {
  std::vector<Face> live;
  for (Face f : faces)
    if (mesh.exists(f) && mesh.is_alive(f)) live.push_back(f);
  sort_unique(live);
  const std::vector<Face> near = two_rings_around(mesh, live);
  std::vector<Crossing> found;
  if (near.empty()) return found;
  Shapes all(mesh);
  std::vector<Shape> shapes;
  shapes.reserve(near.size());
  Box box = box_of(mesh, near[0]);
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Box own = box_of(mesh, near[i]);
    if (i < live.size())
      box.add(own);
    else if (!own.overlaps(box))
      continue;
    shapes.push_back(all.make(near[i], own));
  }
  for_each_candidate(mesh, shapes, live.size(), [&](std::size_t i, std::size_t k) {
    if (all.cross(shapes[i], shapes[k])) found.push_back(std::minmax(shapes[i].face, shapes[k].face));
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace ryosen
