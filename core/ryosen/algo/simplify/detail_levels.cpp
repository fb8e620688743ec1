#include "ryosen/algo/simplify/detail_levels.h"

#include <algorithm>
#include <cassert>

namespace ryosen {

bool DetailLevels::build(const CollapseLimits& limits, const SimplifyGoal& goal, Progress& progress) {
  assert(last() == 0);
  const bool is_done = Simplifier(mesh_, limits, goal, &journal_).run(progress);
  std::vector<std::uint32_t> faces;
  for (; journal_.can_undo(); journal_.undo(mesh_)) faces.push_back(mesh_.live().faces);
  if (!is_done) {
    journal_.clear();
    return false;
  }
  faces_.insert(faces_.end(), faces.rbegin(), faces.rend());
  return true;
}

void DetailLevels::go_to(std::size_t level) {
  assert(level <= last());
  while (journal_.position() > level) journal_.undo(mesh_);
  while (journal_.position() < level) journal_.redo(mesh_);
}

std::size_t DetailLevels::level_of(std::size_t faces) const {
  const auto found = std::partition_point(faces_.begin(), faces_.end(), [&](std::uint32_t f) { return f > faces; });
  return found == faces_.end() ? last() : static_cast<std::size_t>(found - faces_.begin());
}

}  // namespace ryosen
