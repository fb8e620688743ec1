// Heuristic reduction of misoriented edges on a non-orientable component.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace ryosen {

// The dual graph of a connected component in compressed form: faces from 0, and per face the neighbours across its
// sides. Each joint of two different faces is listed from both.
struct FaceGraph {
  struct Side {
    std::uint32_t face;
    bool agrees;  // whether the two currently traverse their edge in opposite directions
  };
  std::vector<std::uint32_t> offsets{0};  // per face into sides; faces + 1 entries
  std::vector<Side> sides;

  std::uint32_t size() const { return static_cast<std::uint32_t>(offsets.size() - 1); }
};

// A set of faces to flip. The seam is the joints that disagree after flipping.
class Seam {
 public:
  Seam(const FaceGraph& graph, std::vector<bool> turned) : graph_(graph), turned_(std::move(turned)) {}

  const std::vector<bool>& turned() const { return turned_; }
  // The number of joints that disagree. O(joints).
  std::size_t size() const;

  // Flips patches (faces connected through joints that agree) and single faces while that shortens the seam; at the end
  // there is one patch and no face disagrees with more neighbours than it agrees with. The seam never gets longer; the
  // result is a local optimum. The partition of the faces does not depend on whether all faces were flipped before.
  // Each pass over patches and faces is O(faces + joints).
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
