// Simplification: fewer faces on nearly the same surface, by collapses of edges (simplifier.h).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/algo/simplify/simplifier.h"

namespace ryosen {

// To a number of faces, a share of them, or an error, whichever comes first; to a number only while the shape stays.
// Vertices and faces that stay keep their numbers. Cost: O(n) and a constant number of questions per collapse.
AlgorithmResult simplify(Edit& edit, const AlgorithmInput& input, Progress& progress);

// All levels of detail of a mesh: the whole sequence of collapses, to be gone through forward and back [Hoppe96].
class DetailLevels {
 public:
  // The mesh as it is.
  explicit DetailLevels(Mesh mesh) : mesh_(std::move(mesh)), faces_{mesh_.live().faces} {}

  // Collapses its edges to a goal and goes back to level 0. False where it was cancelled: there is no other level then.
  bool build(const CollapseLimits& limits, const SimplifyGoal& goal, Progress& progress);

  // On the level where it is. At each level its columns are the same to the byte, whichever way it was reached.
  const Mesh& mesh() const { return mesh_; }
  // How many collapses there are, and how many of them are done.
  std::size_t last() const { return faces_.size() - 1; }
  std::size_t level() const { return journal_.position(); }
  // Up to the last one. Cost: the cells that the collapses between changed, a microsecond or so for each collapse.
  void go_to(std::size_t level);

  // Live faces on a level; they become fewer from level to level, or as many stay.
  std::size_t faces(std::size_t level) const { return faces_[level]; }
  // The first level that has at most so many; the last one where none has.
  std::size_t level_of(std::size_t faces) const;
  // Held beside the mesh.
  std::size_t bytes() const { return journal_.bytes() + faces_.capacity() * sizeof(faces_[0]); }

 private:
  Mesh mesh_;
  Journal journal_;                   // an entry for each collapse
  std::vector<std::uint32_t> faces_;  // by level
};

// What simplify() does with these values and effort 0, as levels of detail: from the mesh, triangulated where that is
// asked for, to the goal, or as far as it goes, whatever becomes of the shape. The level with as many faces has the
// bytes of what simplify() makes of that goal, but for normals of flat faces, which levels do not have. Null with a
// clause where it cannot be done, without one where it was cancelled.
struct BuiltLevels {
  std::unique_ptr<DetailLevels> levels;
  std::optional<Text> refused = {};
};
BuiltLevels build_levels(const Mesh& mesh, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
