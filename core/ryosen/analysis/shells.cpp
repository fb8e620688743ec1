#include "ryosen/analysis/shells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <numeric>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/analysis/box_tree.h"
#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/analysis/numbered_surface.h"
#include "ryosen/analysis/overlap_tree.h"
#include "ryosen/base/handle.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/geometry/volume_sign.h"
#include "ryosen/mesh/face_polygon.h"

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

// The planes of the triangles that a search asks about one after the other: those of a leaf. For one thread; refers to
// the surface.
class LeafPlanes {
 public:
  explicit LeafPlanes(const NumberedSurface& surface) : surface_(surface) { slots_.fill(no_index); }

  // Whether b lies on one side of the plane of a, so that they cannot meet; often false where it does. Quick for the
  // few a that were asked about last.
  bool are_clear(std::uint32_t a, std::uint32_t b) {
    std::size_t i = 0;
    while (i < slots_.size() && slots_[i] != a) ++i;
    if (i == slots_.size()) {
      i = oldest_;
      oldest_ = (oldest_ + 1) % slots_.size();
      slots_[i] = a;
      planes_[i] = TrianglePlane(surface_.triangle(a).places);
    }
    return planes_[i].is_clear_of(surface_.triangle(b).places);
  }

 private:
  const NumberedSurface& surface_;
  std::array<std::uint32_t, 4> slots_;
  std::array<TrianglePlane, 4> planes_;
  std::size_t oldest_ = 0;
};

// Which boxes enclose a box, inner ones first: a tree of boxes, split by position where they lie side by side and by
// rank in the order below where they overlap. Built in O(n log n). Boxes are known by their numbers.
class BoxNesting {
 public:
  explicit BoxNesting(std::span<const Box> boxes)
      : boxes_(boxes.begin(), boxes.end()), order_(boxes.size()), rank_(boxes.size()), ranks_(boxes.size()) {
    // An enclosing box begins further left. Where both begin at one place neither lies inside the other.
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return boxes_[a].lowest.x != boxes_[b].lowest.x ? boxes_[a].lowest.x > boxes_[b].lowest.x : a < b;
    });
    std::iota(ranks_.begin(), ranks_.end(), 0u);
    for (const std::uint32_t rank : ranks_) rank_[order_[rank]] = rank;
    build(0, static_cast<std::uint32_t>(ranks_.size()));
  }

  // All boxes, each before those that enclose it.
  std::span<const std::uint32_t> order() const { return order_; }
  // Asks is_it(number) of the boxes that enclose box `number`, in that order, until one is; else no_index.
  template <class IsIt>
  std::uint32_t first_around(std::uint32_t number, const IsIt& is_it) const {
    const std::uint32_t own = rank_[number];
    using Entry = std::pair<std::uint32_t, std::uint32_t>;  // the lowest rank that may be below, and the node or none
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    const auto wait = [&](std::uint32_t k) {
      const Node& node = nodes_[k];
      if (node.last_rank > own && node.box.encloses(boxes_[number])) waiting.emplace(std::max(node.first_rank, own), k);
    };
    wait(0);
    while (!waiting.empty()) {
      const auto [rank, k] = waiting.top();
      waiting.pop();
      if (k == no_index) {
        if (is_it(order_[rank])) return order_[rank];
        continue;
      }
      const Node& node = nodes_[k];
      if (node.count == 0) {
        wait(k + 1);
        wait(node.first);
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (ranks_[i] > own && box(ranks_[i]).encloses(boxes_[number])) waiting.emplace(ranks_[i], no_index);
    }
    return no_index;
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Node {
    Box box;
    std::uint32_t first_rank, last_rank;
    std::uint32_t first, count;  // a leaf's range of ranks_; else the second child and 0, the first child follows
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, no_index, 0, first, last - first});
    for (std::uint32_t i = first; i < last; ++i) {
      Node& node = nodes_[at];
      node.box.add(box(ranks_[i]));
      node.first_rank = std::min(node.first_rank, ranks_[i]);
      node.last_rank = std::max(node.last_rank, ranks_[i]);
    }
    if (last - first <= leaf_size) return at;
    part(first, last);
    const std::uint32_t middle = first + (last - first) / 2;
    build(first, middle);
    nodes_[at].count = 0;
    const std::uint32_t second = build(middle, last);
    nodes_[at].first = second;
    return at;
  }

  // By place along the axis in which the boxes lie furthest apart for their size. Where they cover each other along all
  // axes, by rank, so that the inner ones are found without looking at the outer ones.
  void part(std::uint32_t first, std::uint32_t last) {
    Box middles;
    glm::dvec3 sizes(0.0);
    for (std::uint32_t i = first; i < last; ++i) {
      const Box& b = box(ranks_[i]);
      middles.add(b.middle());
      sizes += (0.5 * b.highest - 0.5 * b.lowest) / static_cast<double>(last - first);
    }
    const glm::dvec3 width = 0.5 * middles.highest - 0.5 * middles.lowest;
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (width[k] * sizes[axis] > width[axis] * sizes[k]) axis = k;
    const auto begin = ranks_.begin() + first, end = ranks_.begin() + last;
    std::nth_element(begin, begin + (last - first) / 2, end, [&](std::uint32_t a, std::uint32_t b) {
      const double x = box(a).middle()[axis], y = box(b).middle()[axis];
      return width[axis] > sizes[axis] && x != y ? x < y : a < b;
    });
  }

  const Box& box(std::uint32_t rank) const { return boxes_[order_[rank]]; }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_, rank_;  // numbers by rank, and the inverse
  std::vector<std::uint32_t> ranks_;         // in the order of the leaves
  std::vector<Node> nodes_;
};

class ShellSearch {
 public:
  ShellSearch(const Mesh& mesh, FaceComponents components)
      : mesh_(mesh),
        components_(std::move(components)),
        bodies_(components_.count),
        has_volume_(components_.count, true) {
    boxes_.resize(components_.count);
    triangles_.resize(components_.count);
    faces_.resize(components_.count);
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      stop_if_interrupted();
      const std::uint32_t shell = components_.of_face[i];
      if (shell == no_index) continue;
      faces_[shell].emplace_back(i);
      for (const glm::dvec3& p : places_of(Face(i))) boxes_[shell].add(p);
    }
  }

  // Where shells meet their depths are not known.
  Shells run() {
    Shells shells = turned_shells();
    const bool encloses_nothing =
        std::any_of(shells.all.begin(), shells.all.end(), [](const Shell& shell) { return shell.turned == 0; });
    if (components_.count < 2 || encloses_nothing) return shells;
    const BoxNesting nesting(boxes_);
    const std::vector<std::uint32_t> parents = find_parents(nesting);
    shells.meeting = find_meeting(parents);
    if (!shells.meeting) add_depths(nesting, parents, shells);
    return shells;
  }

  Shells run_with_bodies() {
    Shells shells = turned_shells();
    for (std::uint32_t i = 0; i < components_.count; ++i) has_volume_[i] = shells.all[i].turned != 0;
    if (components_.count < 2) return shells;
    const BoxNesting nesting(boxes_);
    std::vector<std::uint32_t> parents = find_parents(nesting);
    shells.meeting = find_meeting(parents);
    if (shells.meeting) {
      join_bodies();
      parents = find_parents(nesting);
    }
    add_depths(nesting, parents, shells);
    return shells;
  }

 private:
  Shells turned_shells() {
    Shells shells;
    for (std::uint32_t i = 0; i < components_.count; ++i) shells.all.push_back({faces_[i].front(), turned(i), 0});
    return shells;
  }

  static void add_depths(const BoxNesting& nesting, std::span<const std::uint32_t> parents, Shells& shells) {
    for (std::size_t n = shells.all.size(); n-- > 0;) {
      const std::uint32_t shell = nesting.order()[n];
      if (parents[shell] != no_index) shells.all[shell].depth = shells.all[parents[shell]].depth + 1;
    }
  }

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

  // The innermost shell of another body around each, or none. As long as no shells are joined, as if no two met.
  std::vector<std::uint32_t> find_parents(const BoxNesting& nesting) {
    std::vector<std::uint32_t> parents(components_.count, no_index);
    for (std::uint32_t i = 0; i < components_.count; ++i) {
      if (!has_volume_[i]) continue;
      const glm::dvec3 p = mesh_.position(mesh_.from(mesh_.halfedge(faces_[i].front())));
      parents[i] = nesting.first_around(i, [&](std::uint32_t other) {
        return has_volume_[other] && bodies_.root(other) != bodies_.root(i) && is_inside(p, other);
      });
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
  std::optional<std::pair<Face, Face>> find_meeting(std::span<const std::uint32_t> parents) {
    std::vector<std::vector<std::uint32_t>> families(components_.count + 1);  // the last: of those without a parent
    for (std::uint32_t i = 0; i < components_.count; ++i)
      if (has_volume_[i]) families[std::min(parents[i], components_.count)].push_back(i);
    std::optional<std::pair<Face, Face>> found;
    for (std::uint32_t i = 0; i <= components_.count && !found; ++i) {
      if (i < components_.count && !families[i].empty()) families[i].push_back(i);
      for_each_meeting(families[i], [&](Face f, Face g) {
        found = {std::min(f, g), std::max(f, g)};
        return false;
      });
    }
    return found;
  }

  // Shells that meet become one body.
  void join_bodies() {
    std::vector<std::uint32_t> shells;
    for (std::uint32_t i = 0; i < components_.count; ++i)
      if (has_volume_[i]) shells.push_back(i);
    for_each_meeting(shells, [&](Face f, Face g) {
      bodies_.join(components_.of_face[f.index], components_.of_face[g.index]);
      return true;
    });
  }

  // Calls visit for faces of two bodies that meet until it returns false. Among all triangles of the shells whose boxes
  // overlap, in one tree, which tells those of fans and slivers apart.
  template <class Visit>
  void for_each_meeting(std::span<const std::uint32_t> shells, const Visit& visit) {
    if (shells.size() < 2) return;
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
    LeafPlanes planes(surface);
    const auto body = [&](std::uint32_t slot) { return bodies_.root(components_.of_face[surface.face(slot).index]); };
    const auto may = [&](std::uint32_t a, std::uint32_t b) { return body(a) != body(b) && !planes.are_clear(a, b); };
    const auto ask = [&](std::uint32_t a, std::uint32_t b) {
      return !meet_elsewhere(surface.triangle(a), surface.triangle(b)) || visit(surface.face(a), surface.face(b));
    };
    for (std::uint32_t node = 0; node < tree.node_count() && tree.visit_pairs(node, may, ask);) ++node;
  }

  const Mesh& mesh_;
  FaceComponents components_;
  DisjointSets bodies_;                   // of shells that meet
  std::vector<bool> has_volume_;          // else it counts for no other
  std::vector<std::vector<Face>> faces_;  // by shell
  std::vector<Box> boxes_;
  std::vector<ShellTriangles> triangles_;  // of the shells that were asked whether others lie in them
  // Scratch of places_of and triangles_of.
  FacePolygon polygon_;
  std::array<glm::dvec3, 3> triangle_;
  std::vector<glm::dvec3> walk_;
};

}  // namespace

Shells find_shells(Neighbourhood& around) { return ShellSearch(around.mesh(), find_face_components(around)).run(); }

Shells nest_shells(const Mesh& mesh, FaceComponents components) {
  return ShellSearch(mesh, std::move(components)).run_with_bodies();
}

}  // namespace ryosen
