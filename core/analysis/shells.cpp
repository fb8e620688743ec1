#include "core/analysis/shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <span>

#include "core/analysis/box_tree.h"
#include "core/analysis/overlap_tree.h"
#include "core/base/parallel.h"
#include "core/geometry/predicates.h"
#include "core/geometry/triangles_meet.h"
#include "core/mesh/face_polygon.h"

namespace ryosen {

namespace {

// The signed volume of one shell, times a power of two, and what rounding may have made of it.
class VolumeSign {
 public:
  explicit VolumeSign(const SpaceBox& box) : apex_(box.lowest) {
    const glm::dvec3 half = 0.5 * box.highest - 0.5 * box.lowest;
    const double extent = std::max({half.x, half.y, half.z});
    const int exponent = extent > 0 ? -std::ilogb(extent) : 0;
    // In two steps, as one power may be out of range.
    scale_ = std::ldexp(1.0, exponent / 2);
    rest_of_scale_ = std::ldexp(1.0, exponent - exponent / 2);
  }

  void add(std::span<const glm::dvec3> polygon) {
    places_.clear();
    for (const glm::dvec3& p : polygon) places_.push_back((0.5 * p - 0.5 * apex_) * scale_ * rest_of_scale_);
    if (places_.size() == 3) return add_cone(places_[0], places_[1], places_[2]);
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& p : places_) middle += p;
    middle /= static_cast<double>(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) add_cone(middle, places_[i], places_[(i + 1) % places_.size()]);
  }
  int sign() const {
    const double sum = sum_ + rest_;
    if (!(std::abs(sum) > 32 * std::numeric_limits<double>::epsilon() * size_)) return 0;
    return sum > 0 ? 1 : -1;
  }

 private:
  void add_cone(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    add_term(glm::dot(a, glm::cross(b, c)));
    size_ += std::sqrt(glm::dot(a, a) * glm::dot(b, b) * glm::dot(c, c));  // a term is off by a few last bits of this
  }
  // What is lost of each sum is kept.
  void add_term(double term) {
    const double sum = sum_ + term;
    rest_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }

  glm::dvec3 apex_;
  double scale_ = 1, rest_of_scale_ = 1;
  std::vector<glm::dvec3> places_;
  double sum_ = 0, rest_ = 0, size_ = 0;
};

// The triangles of a shell in a tree.
struct ShellTriangles {
  std::vector<NumberedTriangle> triangles;
  BoxTree tree;
};

SpaceBox box_of(const NumberedTriangle& t) {
  SpaceBox box;
  for (const glm::dvec3& p : t.places) box.add(p);
  return box;
}

// Whether the ray from p along +x, moved by next to nothing along y and by far less along z, passes through a triangle;
// p is not on it.
bool ray_passes(const glm::dvec3& p, const NumberedTriangle& t) {
  const auto flat = [](const glm::dvec3& a) { return glm::dvec2(a.y, a.z); };
  const auto side = [&](const glm::dvec3& a, const glm::dvec3& b) {
    if (const int exact = orient2d(flat(a), flat(b), flat(p))) return exact;
    if (a.z != b.z) return a.z > b.z ? 1 : -1;
    return a.y < b.y ? 1 : -1;
  };
  const auto& [a, b, c] = t.places;
  const int facing = orient2d(flat(a), flat(b), flat(c));
  if (facing == 0 || side(a, b) != facing || side(b, c) != facing || side(c, a) != facing) return false;
  // Seen from +x the corners turn as in the plane of y and z, so a triangle with facing 1 has its normal towards +x.
  return orient3d(a, b, c, p) == -facing;
}

class ShellSearch {
 public:
  explicit ShellSearch(Neighbourhood& around) : mesh_(around.mesh()), components_(find_face_components(around)) {
    boxes_.resize(components_.count);
    faces_.resize(components_.count);
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      if (!mesh_.is_alive(Face(i))) continue;
      const std::uint32_t shell = components_.of_face[i];
      faces_[shell].emplace_back(i);
      for (const glm::dvec3& p : places_of(Face(i))) boxes_[shell].add(p);
    }
  }

  Shells run() {
    Shells shells;
    for (std::uint32_t i = 0; i < components_.count; ++i) shells.all.push_back({faces_[i].front(), turned(i), 0});
    if (components_.count < 2) return shells;
    tree_ = BoxTree(boxes_);
    triangles_.resize(components_.count);
    for (std::uint32_t i = 0; i < components_.count; ++i)
      if (!visit_others(i, boxes_[i], [](std::uint32_t) { return false; })) triangles_[i] = triangles_of(i);
    shells.meeting = find_meeting();
    if (shells.meeting) return shells;
    for (std::uint32_t i = 0; i < components_.count; ++i) shells.all[i].depth = depth_of(i);
    return shells;
  }

 private:
  int turned(std::uint32_t shell) {
    VolumeSign volume(boxes_[shell]);
    for (const Face f : faces_[shell]) volume.add(places_of(f));
    return volume.sign();
  }

  // One walk around the face, which may go from ring to ring; valid until the next call.
  std::span<const glm::dvec3> places_of(Face f) {
    const Halfedge first = mesh_.halfedge(f), second = mesh_.next(first);
    if (is_triangle(mesh_, first) && !mesh_.has_rings(f)) {
      triangle_ = {mesh_.position(mesh_.from(first)), mesh_.position(mesh_.from(second)),
                   mesh_.position(mesh_.to(second))};
      return triangle_;
    }
    polygon_.read(mesh_, f);
    walk_ = polygon_.keyhole_walk();
    return walk_;
  }

  ShellTriangles triangles_of(std::uint32_t shell) {
    ShellTriangles found;
    std::vector<CornerTriangle> corners;
    std::vector<SpaceBox> boxes;
    for (const Face f : faces_[shell]) {
      polygon_.read(mesh_, f);
      polygon_.triangulate(corners);
      for (const CornerTriangle& t : corners) {
        const auto place = [&](int k) { return polygon_.places()[t[static_cast<std::size_t>(k)]]; };
        // Different shells have no point in common, so what tells the corners apart does not matter.
        const NumberedTriangle triangle{{place(0), place(1), place(2)}, {3 * shell, 3 * shell + 1, 3 * shell + 2}, 0};
        if (are_collinear(place(0), place(1), place(2))) continue;
        boxes.push_back(box_of(triangle));
        found.triangles.push_back(triangle);
      }
    }
    found.tree = BoxTree(std::move(boxes));
    return found;
  }

  // The other shells whose boxes overlap a box, until visit returns false; then so does this.
  template <class Visit>
  bool visit_others(std::uint32_t shell, const SpaceBox& box, const Visit& visit) const {
    return tree_.visit([&](const SpaceBox& other) { return other.overlaps(box); },
                       [&](std::uint32_t other) { return other == shell || visit(other); });
  }

  // Among all triangles in one tree, which tells those of fans and slivers apart.
  std::optional<std::pair<Face, Face>> find_meeting() const {
    const NumberedSurface surface(mesh_);
    const OverlapTree tree(surface, threads_for(surface.slots()));
    std::optional<std::pair<Face, Face>> found;
    const auto visit = [&](std::uint32_t a, std::uint32_t b) {
      const Face f = surface.face(a), g = surface.face(b);
      if (components_.of_face[f.index] == components_.of_face[g.index]) return true;
      if (!meet_elsewhere(surface.triangle(a), surface.triangle(b))) return true;
      found = {std::min(f, g), std::max(f, g)};
      return false;
    };
    for (std::uint32_t node = 0; node < tree.node_count() && tree.visit_pairs(node, visit);) ++node;
    return found;
  }

  std::uint32_t depth_of(std::uint32_t shell) const {
    const glm::dvec3 p = mesh_.position(mesh_.from(mesh_.halfedge(faces_[shell].front())));
    const auto is_on_ray = [&](const SpaceBox& box) {
      return box.highest.x >= p.x && box.lowest.y <= p.y && p.y <= box.highest.y && box.lowest.z <= p.z &&
             p.z <= box.highest.z;
    };
    SpaceBox place;
    place.add(p);
    std::uint32_t depth = 0;
    visit_others(shell, place, [&](std::uint32_t other) {
      bool is_inside = false;
      triangles_[other].tree.visit(is_on_ray, [&](std::uint32_t n) {
        is_inside ^= ray_passes(p, triangles_[other].triangles[n]);
        return true;
      });
      depth += is_inside;
      return true;
    });
    return depth;
  }

  const Mesh& mesh_;
  FaceComponents components_;
  std::vector<std::vector<Face>> faces_;  // by shell
  std::vector<SpaceBox> boxes_;
  BoxTree tree_;
  std::vector<ShellTriangles> triangles_;  // of the shells whose boxes overlap others
  // Scratch of places_of and triangles_of.
  FacePolygon polygon_;
  std::array<glm::dvec3, 3> triangle_;
  std::vector<glm::dvec3> walk_;
};

}  // namespace

Shells find_shells(Neighbourhood& around) { return ShellSearch(around).run(); }

}  // namespace ryosen
