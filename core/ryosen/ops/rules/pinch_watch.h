// Warnings of points that deletions would pinch, for many deletions one after another.
//
// The faces at a point hang together through the points beside it: a corner joins the two at its sides. A point comes
// apart where a corner goes that alone joins two which have other corners too. What is joined is kept from question to
// question, so that one costs what is near the corner, and where it may come apart the smaller of the two sides.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

class PinchWatch {
 public:
  explicit PinchWatch(const Mesh& mesh) : mesh_(mesh) {}

  // Whether pinched_without() (rules/pinch.h) names a point. The faces are ascending.
  bool is_pinched_without(std::span<const Face> faces);
  // Call before these are deleted; nothing else changes what is watched.
  void loses(std::span<const Face> faces);
  // Corners and points that were looked at: what the work is measured by.
  std::uint64_t looks() const { return looks_; }

 private:
  struct Corner {
    Vertex point, before, after;
  };
  // By a point beside, how many corners lead on to which others.
  using Beside = std::unordered_map<Vertex, std::uint32_t>;
  using Corners = std::unordered_map<Vertex, Beside>;

  std::vector<Corner> corners_of(std::span<const Face> faces) const;
  Corners& corners_at(Vertex p);
  static void add(Corners& corners, Vertex before, Vertex after);
  static void remove(Corners& corners, Vertex before, Vertex after);
  int parts_more_without(Corners& corners, const Corner& corner);
  bool are_joined(const Corners& corners, Vertex a, Vertex b);

  const Mesh& mesh_;
  std::unordered_map<Vertex, Corners> watched_;  // by point
  std::uint64_t looks_ = 0;
};

}  // namespace ryosen
