#include "core/pick/bvh.h"

namespace ryosen {

const char* Bvh::find_defect(std::span<const glm::dvec3> positions) const {
  std::size_t seen = 0;
  if (live_ != 0) {
    if (const char* defect = find_defect_below(positions, 0, seen)) return defect;
  }
  if (seen != live_) return "the tree holds another number of primitives than it says";
  for (std::uint32_t slot = 0; slot < primitives_.size(); ++slot) {
    const bool belongs = primitives_[slot].size() != 0 && is_finite(positions, primitives_[slot]);
    if (belongs != (leaf_of_[slot] != no_index)) return "a slot is missing in the tree or wrongly in it";
  }
  return nullptr;
}

const char* Bvh::find_defect_below(std::span<const glm::dvec3> positions, std::uint32_t top, std::size_t& seen) const {
  std::vector<std::uint32_t> open = {top};
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    const Node& here = node(i);
    if (here.count == 0) {
      if (parent(here.first) != i) return "a child does not know its parent";
      if (!is_same(box(i), united(box(i), united(box(here.first), box(here.first + 1))))) {
        return "a child reaches out of its parent's box";
      }
      open.insert(open.end(), {here.first, here.first + 1});
      continue;
    }
    if (here.count > leaf_capacity) return "a leaf is overfull";
    if (!is_same(box(i), united(box(i), leaf_box(positions, here)))) return "a primitive reaches out of its leaf's box";
    for (std::uint32_t k = 0; k < here.count; ++k) {
      if (leaf_of_[blocks_[here.first][k]] != i) return "a slot does not know its leaf";
    }
    seen += here.count;
  }
  return nullptr;
}

}  // namespace ryosen
