// The search for the point of a surface that is farthest from another.
#pragma once

#include <functional>
#include <vector>

#include "ryosen/analysis/measure/cell_bound.h"
#include "ryosen/base/progress.h"

namespace ryosen {

// When a bound above a distance that occurs is good enough: by a share of that, or by an absolute amount.
struct FarEnough {
  double share, amount;
  double from(double found) const { return found + std::max(found * share, amount); }
};

// What is known so far: a point and its distance, and of what is looked through no point is farther than the bound.
struct Farthest {
  double distance = 0, bound = 0;
  glm::dvec3 place{0.0};
  std::uint64_t cuts = 0;  // so many cells were cut for it

  void note(const glm::dvec3& at, double far) {
    if (far > distance) distance = far, place = at;
  }
};

// Cells that are still to be looked through: their bounds, the largest first, and each cell when its turn has come.
struct FarCells {
  std::size_t count = 0;
  std::function<double(std::size_t)> bound;
  std::function<FarthestCell(std::size_t)> cell;
};

// Cuts cells, those with the largest bounds first, until no bound is more than enough, or after so many steps: then
// the bound is the largest of those that are left. The answer is the same for any number of threads. False where
// `progress` cancels.
bool search_farthest(Farthest& farthest, const TriangleTree& to, const FarCells& cells, FarEnough enough,
                     std::uint64_t most_steps, unsigned threads, Progress& progress);

}  // namespace ryosen
