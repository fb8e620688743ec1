// Fewer misoriented edges on a component that cannot be oriented.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace ryosen {

// The faces 0 .. of a connected component and, face after face, the neighbours across their sides: each joint of two
// different faces is named from both of them.
struct FaceGraph {
  struct Side {
    std::uint32_t face;
    bool agrees;  // whether the two run their edge in opposite directions as they are
  };
  std::vector<std::uint32_t> offsets{0};  // of each face into sides, and the end
  std::vector<Side> sides;

  std::uint32_t size() const { return static_cast<std::uint32_t>(offsets.size() - 1); }
};

// A choice of faces that turn, and the joints that disagree after it: the seam.
class Seam {
 public:
  Seam(const FaceGraph& graph, std::vector<bool> turned) : graph_(graph), turned_(std::move(turned)) {}

  const std::vector<bool>& turned() const { return turned_; }
  // The number of joints that disagree. O(joints).
  std::size_t size() const;

  // Turns patches, the faces joined by joints that agree, and single faces while that makes the seam shorter; at the end
  // the faces are one patch and no face disagrees with more neighbours than it agrees with. It never gets longer, though
  // it need not become the shortest that there is. Which faces lie on the same side of the seam does not depend on
  // whether all faces had been turned before. A pass over the patches, and over the faces, is O(faces + joints).
  void shorten();

 private:
  bool disagrees(std::uint32_t face, const FaceGraph::Side& side) const {
    return side.agrees == (turned_[face] != turned_[side.face]);
  }
  void join_patches();
  bool turn_faces();
  bool disagrees_mostly(std::uint32_t face) const;

  const FaceGraph& graph_;
  std::vector<bool> turned_;
};

}  // namespace ryosen
