// Copies of points: one surgery adds many and takes many out, each at a cost that does not grow with their number.
//
// The links of a mesh lead from a copy to the next one alone, so that the one before it is found by a walk around all
// of them. Here it is kept for points with many copies, from the second walk on.
#pragma once

#include <set>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "ryosen/mesh/edit.h"

namespace ryosen {

// Knows of changes that are made through it alone.
class CopyRings {
 public:
  explicit CopyRings(Edit& edit) : edit_(edit) {}

  // As join_copies().
  void join(Vertex a, Vertex b);
  // As leave_copies(); where v is the copy after another one, which is named, without a walk around all of them.
  void leave(Vertex v, Vertex other);
  // Unlinks these copies of one point, each once. Where the representative goes and others stay, one of these is
  // unlinked in its place, which is returned: the last one with edges or, if there is none, the last one.
  Vertex leave_all(std::span<const Vertex> going);

 private:
  bool knows(Vertex p) const { return rings_.contains(p); }
  // At the second call for a point with so many copies that walks around them cost more than what is kept.
  bool get_to_know(Vertex p);
  void know(Vertex p);
  void unlink(Vertex v, Vertex before);
  Vertex leave_small(std::span<const Vertex> going);

  Edit& edit_;
  std::unordered_map<Vertex, std::set<Vertex>> rings_;  // by point
  std::unordered_map<Vertex, Vertex> before_;           // of the copies there
  std::unordered_set<Vertex> walked_;                   // points
};

}  // namespace ryosen
