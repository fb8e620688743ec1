#include "core/analysis/shells.h"

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <span>

#include "core/analysis/box_nesting.h"
#include "core/analysis/box_tree.h"
#include "core/analysis/leaf_planes.h"
#include "core/analysis/overlap_tree.h"
#include "core/base/interruption.h"
#include "core/base/parallel.h"
#include "core/geometry/predicates.h"
#include "core/geometry/triangles_meet.h"
#include "core/geometry/volume_sign.h"
#include "core/mesh/face_polygon.h"

namespace ryosen {

namespace {

// The triangles of a shell in a tree.
struct ShellTriangles {
  std::vector<std::array<glm::dvec3, 3>> triangles;
  BoxTree tree;
};

// Whether the ray from p along +x, moved by next to nothing along y and by far less along z, passes through a triangle;
// p is not on it.
bool ray_passes(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t) {
  const auto flat = [](const glm::dvec3& a) { return glm::dvec2(a.y, a.z); };
  const auto side = [&](const glm::dvec3& a, const glm::dvec3& b) {
    if (const int exact = orient2d(flat(a), flat(b), flat(p))) return exact;
    if (a.z != b.z) return a.z > b.z ? 1 : -1;
    return a.y < b.y ? 1 : -1;
  };
  const auto& [a, b, c] = t;
  const int facing = orient2d(flat(a), flat(b), flat(c));
  if (facing == 0 || side(a, b) != facing || side(b, c) != facing || side(c, a) != facing) return false;
  // Seen from +x the corners turn as in the plane of y and z, so a triangle with facing 1 has its normal towards +x.
  return orient3d(a, b, c, p) == -facing;
}

class ShellSearch {
 public:
  explicit ShellSearch(Neighbourhood& around) : mesh_(around.mesh()), components_(find_face_components(around)) {
    boxes_.resize(components_.count);
    triangles_.resize(components_.count);
    faces_.resize(components_.count);
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      stop_if_interrupted();
      if (!mesh_.is_alive(Face(i))) continue;
      const std::uint32_t shell = components_.of_face[i];
      faces_[shell].emplace_back(i);
      for (const glm::dvec3& p : places_of(Face(i))) boxes_[shell].add(p);
    }
  }

  Shells run() {
    Shells shells;
    for (std::uint32_t i = 0; i < components_.count; ++i) shells.all.push_back({faces_[i].front(), turned(i), 0});
    const bool encloses_nothing =
        std::any_of(shells.all.begin(), shells.all.end(), [](const Shell& shell) { return shell.turned == 0; });
    if (components_.count < 2 || encloses_nothing) return shells;
    const BoxNesting nesting(boxes_);
    const std::vector<std::uint32_t> parents = find_parents(nesting);
    shells.meeting = find_meeting(parents);
    if (shells.meeting) return shells;
    for (std::uint32_t n = components_.count; n-- > 0;) {
      const std::uint32_t shell = nesting.order()[n];
      if (parents[shell] != no_index) shells.all[shell].depth = shells.all[parents[shell]].depth + 1;
    }
    return shells;
  }

 private:
  int turned(std::uint32_t shell) {
    RoundedVolume rounded(boxes_[shell].lowest);
    for (const Face f : faces_[shell]) rounded.add(places_of(f));
    if (const auto sign = rounded.sign()) return *sign;
    ExactVolume exact;
    for (const Face f : faces_[shell]) exact.add(places_of(f));
    return exact.sign();
  }

  // One walk around the face, which may go from ring to ring; valid until the next call.
  std::span<const glm::dvec3> places_of(Face f) {
    stop_if_interrupted();
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
    std::vector<Box> boxes;
    for (const Face f : faces_[shell]) {
      stop_if_interrupted();
      polygon_.read(mesh_, f);
      polygon_.triangulate(corners);
      for (const CornerTriangle& t : corners) {
        const auto place = [&](int k) { return polygon_.places()[t[static_cast<std::size_t>(k)]]; };
        const std::array<glm::dvec3, 3> triangle{place(0), place(1), place(2)};
        if (are_collinear(place(0), place(1), place(2))) continue;
        boxes.push_back(box_of(triangle));
        found.triangles.push_back(triangle);
      }
    }
    found.tree = BoxTree(std::move(boxes));
    return found;
  }

  // The innermost shell around each, or none, as if no two met.
  std::vector<std::uint32_t> find_parents(const BoxNesting& nesting) {
    std::vector<std::uint32_t> parents;
    for (std::uint32_t i = 0; i < components_.count; ++i) {
      const glm::dvec3 p = mesh_.position(mesh_.from(mesh_.halfedge(faces_[i].front())));
      parents.push_back(nesting.first_around(i, [&](std::uint32_t other) { return is_inside(p, other); }));
    }
    return parents;
  }

  bool is_inside(const glm::dvec3& p, std::uint32_t shell) {
    if (triangles_[shell].triangles.empty()) triangles_[shell] = triangles_of(shell);
    const ShellTriangles& found = triangles_[shell];
    const auto is_on_ray = [&](const Box& box) {
      return box.highest.x >= p.x && box.lowest.y <= p.y && p.y <= box.highest.y && box.lowest.z <= p.z &&
             p.z <= box.highest.z;
    };
    bool is_inside = false;
    found.tree.visit(is_on_ray, [&](std::uint32_t n) {
      is_inside ^= ray_passes(p, found.triangles[n]);
      return true;
    });
    return is_inside;
  }

  // If any two shells meet, then also two of which one is the parent of the other, or that have the same or no parent:
  // where those are apart, a shell parts what lies inside of it from what lies outside.
  std::optional<std::pair<Face, Face>> find_meeting(std::span<const std::uint32_t> parents) const {
    std::vector<std::vector<std::uint32_t>> families(components_.count + 1);  // the last: of those without a parent
    for (std::uint32_t i = 0; i < components_.count; ++i)
      families[std::min(parents[i], components_.count)].push_back(i);
    for (std::uint32_t i = 0; i <= components_.count; ++i) {
      if (i < components_.count && !families[i].empty()) families[i].push_back(i);
      if (const auto found = find_meeting_among(families[i])) return found;
    }
    return std::nullopt;
  }

  // Among all triangles of the shells whose boxes overlap, in one tree, which tells those of fans and slivers apart.
  std::optional<std::pair<Face, Face>> find_meeting_among(std::span<const std::uint32_t> shells) const {
    if (shells.size() < 2) return std::nullopt;
    std::vector<Box> boxes;
    for (const std::uint32_t shell : shells) boxes.push_back(boxes_[shell]);
    const BoxTree tree_of_boxes(boxes);
    std::vector<Face> faces;
    for (std::size_t i = 0; i < shells.size(); ++i) {
      const auto is_alone = [&](std::uint32_t other) { return other == i; };
      const auto overlaps = [&](const Box& box) { return box.overlaps(boxes[i]); };
      if (tree_of_boxes.visit(overlaps, is_alone)) continue;
      faces.insert(faces.end(), faces_[shells[i]].begin(), faces_[shells[i]].end());
    }
    const NumberedSurface surface(mesh_, faces);
    const OverlapTree tree(surface, threads_for(surface.slots()));
    std::optional<std::pair<Face, Face>> found;
    LeafPlanes planes(surface);
    const auto may = [&](std::uint32_t a, std::uint32_t b) {
      const Face f = surface.face(a), g = surface.face(b);
      return components_.of_face[f.index] != components_.of_face[g.index] && !planes.are_clear(a, b);
    };
    const auto visit = [&](std::uint32_t a, std::uint32_t b) {
      const Face f = surface.face(a), g = surface.face(b);
      if (!meet_elsewhere(surface.triangle(a), surface.triangle(b))) return true;
      found = {std::min(f, g), std::max(f, g)};
      return false;
    };
    for (std::uint32_t node = 0; node < tree.node_count() && tree.visit_pairs(node, may, visit);) ++node;
    return found;
  }

  const Mesh& mesh_;
  FaceComponents components_;
  std::vector<std::vector<Face>> faces_;  // by shell
  std::vector<Box> boxes_;
  std::vector<ShellTriangles> triangles_;  // of the shells that were asked whether others lie in them
  // Scratch of places_of and triangles_of.
  FacePolygon polygon_;
  std::array<glm::dvec3, 3> triangle_;
  std::vector<glm::dvec3> walk_;
};

}  // namespace

Shells find_shells(Neighbourhood& around) { return ShellSearch(around).run(); }

}  // namespace ryosen
