#include "core/analysis/self_intersections.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/base/sort_unique.h"
#include "core/build/parallel.h"
#include "core/geometry/predicates.h"
#include "core/geometry/triangles_meet.h"
#include "core/mesh/copies.h"
#include "core/pick/surface_triangles.h"

namespace ryosen {

namespace {

// By floats: where two boxes of doubles overlap, so do these, because rounding keeps the order of numbers.
struct OverlapBox {
  std::array<float, 3> lowest, highest;

  // Without branches, which nobody could foretell.
  bool overlaps(const OverlapBox& b) const {
    int apart = 0;
    for (std::size_t i = 0; i < 3; ++i)
      apart |= static_cast<int>(lowest[i] > b.highest[i]) | static_cast<int>(b.lowest[i] > highest[i]);
    return apart == 0;
  }
  void grow(const OverlapBox& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      lowest[i] = std::min(lowest[i], b.lowest[i]);
      highest[i] = std::max(highest[i], b.highest[i]);
    }
  }
};

OverlapBox box_of_nothing() {
  constexpr float far = std::numeric_limits<float>::infinity();
  return {{far, far, far}, {-far, -far, -far}};
}

struct BoxedTriangle {
  OverlapBox box;
  std::uint32_t slot;
};

// A balanced tree of boxes over the triangles, halved at the median of the widest axis. Nodes lie in depth-first order,
// so that whatever comes later in the order of leaves lies behind.
class OverlapTree {
 public:
  OverlapTree(std::vector<BoxedTriangle> triangles, unsigned threads) : triangles_(std::move(triangles)) {
    if (triangles_.empty()) return;
    nodes_.resize(node_count(0, size()));
    build(0, 0, size(), threads);
  }

  std::uint32_t node_count() const { return static_cast<std::uint32_t>(nodes_.size()); }

  // Visits each pair of triangles with overlapping boxes of which the one that comes first is in the leaf `node`.
  template <class Visit>
  void visit_pairs(std::uint32_t node, Visit visit) const {
    const Node& leaf = nodes_[node];
    if (leaf.count == 0) return;
    const auto pair_up = [&](std::uint32_t i, const Node& other, std::uint32_t begin) {
      const BoxedTriangle& t = triangles_[i];
      for (std::uint32_t j = begin; j < other.first + other.count; ++j)
        if (t.box.overlaps(triangles_[j].box)) visit(t.slot, triangles_[j].slot);
    };
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) pair_up(i, leaf, i + 1);
    for (std::uint32_t k = node + 1; k < nodes_.size();) {
      const Node& other = nodes_[k];
      if (!leaf.box.overlaps(other.box)) {
        k = other.behind;
        continue;
      }
      if (other.count > 0)
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
          if (triangles_[i].box.overlaps(other.box)) pair_up(i, other, other.first);
      ++k;
    }
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;

  struct Node {
    OverlapBox box;
    std::uint32_t behind;     // the first node that is not below this one
    std::uint32_t first = 0;  // a leaf's triangles
    std::uint32_t count = 0;
  };

  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }
  static std::uint32_t leaf_count(std::uint32_t triangles) { return (triangles + leaf_size - 1) / leaf_size; }
  static std::uint32_t node_count(std::uint32_t first, std::uint32_t last) { return 2 * leaf_count(last - first) - 1; }

  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last, unsigned threads) {
    Node& n = nodes_[node];
    n.behind = node + node_count(first, last);
    n.box = box_of_nothing();
    if (last - first <= leaf_size) {
      n.first = first;
      n.count = last - first;
      for (std::uint32_t i = first; i < last; ++i) n.box.grow(triangles_[i].box);
      return;
    }
    const std::uint32_t middle = first + leaf_size * ((leaf_count(last - first) + 1) / 2);
    halve(first, middle, last);
    const std::uint32_t left = node + 1, right = left + node_count(first, middle);
    for_each_part(2, threads > 1 ? 2 : 1, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t half = begin; half < end; ++half)
        half == 0 ? build(left, first, middle, threads / 2) : build(right, middle, last, threads / 2);
    });
    n.box.grow(nodes_[left].box);
    n.box.grow(nodes_[right].box);
  }

  void halve(std::uint32_t first, std::uint32_t middle, std::uint32_t last) {
    const auto center = [](const BoxedTriangle& t, std::size_t axis) {
      return t.box.lowest[axis] + t.box.highest[axis];
    };
    OverlapBox centers = box_of_nothing();
    for (std::uint32_t i = first; i < last; ++i) {
      const BoxedTriangle& t = triangles_[i];
      const std::array<float, 3> c{center(t, 0), center(t, 1), center(t, 2)};
      centers.grow({c, c});
    }
    std::size_t axis = 0;
    const auto width = [&](std::size_t k) { return centers.highest[k] - centers.lowest[k]; };
    for (std::size_t k = 1; k < 3; ++k)
      if (width(k) > width(axis)) axis = k;
    std::nth_element(triangles_.begin() + first, triangles_.begin() + middle, triangles_.begin() + last,
                     [&](const BoxedTriangle& a, const BoxedTriangle& b) {
                       const float x = center(a, axis), y = center(b, axis);
                       return x != y ? x < y : a.slot < b.slot;
                     });
  }

  std::vector<BoxedTriangle> triangles_;
  std::vector<Node> nodes_;
};

// The triangles of the mesh with their corners by point.
class NumberedSurface {
 public:
  explicit NumberedSurface(const Mesh& mesh) : mesh_(mesh), triangles_(mesh) {
    choose_frame();
    if (!mesh.has_copies()) return;
    point_.assign(mesh.vertex_slots(), no_index);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
      if (mesh.is_alive(Vertex(i)) && point_[i] == no_index)
        for_each_copy(mesh, Vertex(i), [&](Vertex copy) { point_[copy.index] = i; });
  }

  NumberedTriangle triangle(std::uint32_t slot) const {
    NumberedTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles_.triangles()[slot][k];
      t.places[k] = mesh_.position(Vertex(v));
      t.numbers[k] = point_.empty() ? v : point_[v];
    }
    t.sides = triangles_.edge_bits()[slot];
    return t;
  }
  Face face(std::uint32_t slot) const { return Face(triangles_.faces()[slot]); }
  std::uint32_t slots() const { return static_cast<std::uint32_t>(triangles_.triangles().size()); }

  std::vector<BoxedTriangle> boxed_triangles(unsigned threads) const {
    std::vector<BoxedTriangle> boxed(slots());
    for_each_part(slots(), threads, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t slot = begin; slot < end; ++slot) boxed[slot] = boxed_triangle(slot);
    });
    std::erase_if(boxed, [](const BoxedTriangle& t) { return t.slot == no_index; });
    return boxed;
  }

 private:
  // Floats are finest around zero, and hold a mesh that is about one unit large.
  void choose_frame() {
    glm::dvec3 lowest(std::numeric_limits<double>::infinity()), highest(-lowest);
    for (std::uint32_t slot = 0; slot < slots(); ++slot)
      for (const std::uint32_t v : triangles_.triangles()[slot]) {
        lowest = glm::min(lowest, mesh_.position(Vertex(v)));
        highest = glm::max(highest, mesh_.position(Vertex(v)));
      }
    if (slots() == 0) return;
    origin_ = lowest * 0.5 + highest * 0.5;
    const glm::dvec3 half = highest * 0.5 - lowest * 0.5;
    const double size = std::max({half.x, half.y, half.z});
    if (size > 0.0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
  }

  BoxedTriangle boxed_triangle(std::uint32_t slot) const {
    const auto& corners = triangles_.triangles()[slot];
    const auto place = [&](std::size_t k) -> const glm::dvec3& { return mesh_.position(Vertex(corners[k])); };
    BoxedTriangle t{box_of_nothing(), are_collinear(place(0), place(1), place(2)) ? no_index : slot};
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 p = (place(k) - origin_) * scale_;
      const std::array<float, 3> f{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
      t.box.grow({f, f});
    }
    return t;
  }

  const Mesh& mesh_;
  SurfaceTriangles triangles_;
  std::vector<std::uint32_t> point_;  // by vertex; empty while the mesh has no copies
  glm::dvec3 origin_{0.0};
  double scale_ = 1.0;
};

}  // namespace

std::vector<FacePair> find_self_intersections(const Mesh& mesh, unsigned threads) {
  const NumberedSurface surface(mesh);
  if (threads == 0) threads = threads_for(surface.slots());
  const OverlapTree tree(surface.boxed_triangles(threads), threads);
  constexpr std::uint32_t stride = 1024;
  std::atomic<std::uint32_t> next = 0;
  std::vector<std::vector<FacePair>> found(threads);
  for_each_part(threads, threads, [&](unsigned t, std::uint32_t, std::uint32_t) {
    for (std::uint32_t begin = next.fetch_add(stride); begin < tree.node_count(); begin = next.fetch_add(stride))
      for (std::uint32_t node = begin; node < std::min(begin + stride, tree.node_count()); ++node)
        tree.visit_pairs(node, [&](std::uint32_t a, std::uint32_t b) {
          const Face f = surface.face(a), g = surface.face(b);
          if (f != g && meet_elsewhere(surface.triangle(a), surface.triangle(b)))
            found[t].push_back({std::min(f, g), std::max(f, g)});
        });
  });
  for (unsigned t = 1; t < threads; ++t) found[0].insert(found[0].end(), found[t].begin(), found[t].end());
  sort_unique(found[0]);
  return std::move(found[0]);
}

std::vector<Face> faces_of(const std::vector<FacePair>& pairs) {
  std::vector<Face> faces;
  faces.reserve(2 * pairs.size());
  for (const FacePair& pair : pairs) {
    faces.push_back(pair.first);
    faces.push_back(pair.second);
  }
  sort_unique(faces);
  return faces;
}

}  // namespace ryosen
