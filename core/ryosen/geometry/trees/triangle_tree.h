// A tree of boxes over triangles that do not change: nearest triangles of very many points.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/handle.h"
#include "ryosen/geometry/closest.h"
#include "ryosen/geometry/trees/primitive.h"

namespace ryosen {

// Triangles and points have numbers of the tree's own, such that near ones are near in memory too: go over them in this
// order. Coordinates are those given times a scale that is a power of two; choose one that brings them to at most
// about 1.
//
// Every node has four children; which ones follows from its number, halves of each range being parted at the median
// along the widest axis. Nodes of long narrow triangles have boxes that lie along these, so that a point in the middle
// of a fan is not in the boxes of all its spokes. Built in O(n log n), 30 to 60 bytes per triangle. A query takes O(log
// n) where the nearest triangles are few. It answers the same whatever was asked before.
class TriangleTree {
 public:
  TriangleTree() = default;
  // All primitives are triangles with finite corners.
  TriangleTree(std::span<const glm::dvec3> positions, std::span<const Primitive> triangles, double scale);

  std::uint32_t size() const { return static_cast<std::uint32_t>(corners_.size()); }
  bool is_empty() const { return corners_.empty(); }
  const std::array<std::uint32_t, 3>& corners(std::uint32_t t) const { return corners_[t]; }
  std::uint32_t owner(std::uint32_t t) const { return owners_[t]; }
  std::span<const glm::dvec3> points() const { return points_; }
  // Half the longest side of the box around the points.
  double reach() const { return reach_; }
  std::array<glm::dvec3, 3> places(std::uint32_t t) const {
    const auto& [a, b, c] = corners_[t];
    return {points_[a], points_[b], points_[c]};
  }

  struct Near {
    double distance = 0;
    std::uint32_t triangle = no_index;
  };
  // Of a finite point in the same scale. `hint`: a triangle that is near, if one is known; the nearer, the faster. Of
  // several nearest triangles any. The tree is not empty.
  Near nearest(const glm::dvec3& p, std::uint32_t hint = no_index) const;
  // The nearest of those whose normal is at less than a right angle to the direction; none where there is none.
  Near nearest_facing(const glm::dvec3& p, const glm::dvec3& direction) const;
  // The nearest of those that `is_asked`; none where there is none.
  Near nearest_of(const glm::dvec3& p, const std::function<bool(std::uint32_t)>& is_asked) const;
  // Of several points that lie near each other. `near` holds a hint for each, and then the answer.
  void nearest(std::span<const glm::dvec3> points, std::span<Near> near) const;
  // Of how many triangles the distance is computed to find the nearest one, without a hint.
  std::size_t triangles_asked_for(const glm::dvec3& p) const;
  double distance(const glm::dvec3& p, std::uint32_t t) const { return glm::length(way(p, t)); }
  // Twice the area along the normal.
  glm::dvec3 area_normal(std::uint32_t t) const {
    const auto [a, b, c] = places(t);
    return glm::cross(b - a, c - a);
  }
  // p minus its nearest point on the triangle.
  glm::dvec3 way(const glm::dvec3& p, std::uint32_t t) const {
    const auto& [a, b, c] = corners_[t];
    return way_from_triangle(points_[a], points_[b], points_[c], p);
  }

  std::size_t bytes() const;

 private:
  static constexpr std::uint32_t width = 4;
  // Bounds of four children in the tree's frame, (p - origin_), or turned into one of `turns_`; an absent one is empty.
  // `first`: the first child, a triangle in nodes of the lowest level.
  struct alignas(16) Node {
    std::array<std::array<float, width>, 3> lowest, highest;
    std::uint32_t first;
    std::uint32_t has_triangles;
    std::uint32_t turn = no_index;  // by place in turns_; none: the axes are those of the places
  };
  // A node whose boxes lie along what is in them. Beside them each child lies between lines in the plane of the first
  // two axes, two ways: along its own sides where it narrows to a point, so that of the spokes of a fan that one is the
  // nearest which is.
  struct Turn {
    glm::dmat3 axes;  // in rows
    std::array<std::array<glm::dvec2, width>, 2> across;
    std::array<std::array<float, width>, 2> lowest, highest;  // of the places along `across`
  };
  // What of the triangles a node stands for.
  struct Content {
    std::uint32_t begin, end;
    double area;
  };
  static constexpr std::size_t most_shared = 48;  // nodes with triangles looked at for several points together
  class NearQuery;
  class FarQuery;

  bool is_far(const glm::dvec3& local) const;
  template <class Query, class IsAsked>
  Near nearest(const Query& query, const glm::dvec3& p, std::uint32_t hint, const IsAsked& is_asked) const;
  bool find_shared(std::span<const glm::dvec3> points, std::span<Near> near,
                   std::array<std::uint32_t, most_shared>& shared, std::size_t& count) const;
  void take(std::span<const glm::dvec3> positions, std::span<const Primitive> triangles,
            std::span<const std::uint32_t> order, double scale);
  void add_levels();
  void turn_slender_nodes();
  Content content_of(const Node& node, std::span<const Content> below) const;
  void turn(Node& node, const Content& content, std::span<const Content> below);

  ColumnVector<glm::dvec3> points_;
  ColumnVector<std::array<std::uint32_t, 3>> corners_;
  std::vector<std::uint32_t> owners_;
  ColumnVector<Node> nodes_;  // level after level from the lowest; the root is the last
  std::vector<Turn> turns_;
  glm::dvec3 origin_{0.0};
  double reach_ = 0;  // largest magnitude of a coordinate in the frame
};

}  // namespace ryosen
