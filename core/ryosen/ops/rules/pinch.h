// Warning for operators that increase the number of face fans at a point (a pinch): legal but doubtful.
//
//      \ f |
//     f \ | /  g        the fans of a point are the groups of its faces (over all copies) that are connected through
//        p              edges there, whatever their direction and number of faces
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ryosen/base/verdict.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The points that get more fans by a new face on a loop of points. Cost: the one-rings of its points.
std::vector<Vertex> pinched_by_face(const Mesh& mesh, std::span<const std::uint32_t> loop);

// The points that keep other faces, in more fans than before, when these faces (ascending) are removed. `apart`: they
// are detached instead of removed, and their fans count too. Cost: the one-rings of their points.
std::vector<Vertex> pinched_without(const Mesh& mesh, std::span<const Face> faces, bool apart = false);

// The points that after welding have more fans than either of the two before. Pairs: removed, remaining; returns the
// remaining. Cost: their one-rings.
std::vector<Vertex> pinched_by_weld(const Mesh& mesh, std::span<const std::pair<Vertex, Vertex>> pairs);

// What to warn of where a face comes to lie in the cycle of outside halfedges.
std::vector<Reason> warnings_of_face_in(const Mesh& mesh, Halfedge outside);

// Adds the warning if there are any.
void warn_of_pinch(const std::vector<Vertex>& points, std::vector<Reason>& reasons);

// Warnings of points that deletions would pinch, for many deletions one after another.
//
// The faces at a point hang together through the points beside it: a corner joins the two at its sides. A point comes
// apart where a corner goes that alone joins two which have other corners too. What is joined is kept from question to
// question, so that one costs what is near the corner, and where it may come apart the smaller of the two sides.
class PinchWatch {
 public:
  explicit PinchWatch(const Mesh& mesh) : mesh_(mesh) {}

  // Whether pinched_without() names a point. The faces are ascending.
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
