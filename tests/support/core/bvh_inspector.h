// Holds the nodes, boxes and slots of a tree against what they must be.
#pragma once

#include "ryosen/geometry/trees/bvh.h"

namespace ryosen {

struct BvhInspector {
  const Bvh& bvh;
  std::span<const glm::dvec3> positions;

  // Names the first invariant that is violated; null where all hold. O(n).
  const char* find_defect() const {
    std::size_t seen = 0;
    if (bvh.live_ != 0)
      if (const char* defect = find_defect_in_nodes(seen)) return defect;
    if (seen != bvh.live_) return "the tree holds another number of primitives than it says";
    for (std::uint32_t slot = 0; slot < bvh.primitives_.size(); ++slot) {
      const bool belongs = bvh.primitives_[slot].size() != 0 && Bvh::is_finite(positions, bvh.primitives_[slot]);
      if (belongs != (bvh.leaf_of_[slot] != no_index)) return "a slot is missing in the tree or wrongly in it";
    }
    return nullptr;
  }

 private:
  const char* find_defect_in_nodes(std::size_t& seen) const {
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      const Bvh::Node& here = bvh.node(i);
      const FloatBox box = bvh.box(i);
      if (here.count == 0) {
        if (bvh.parent(here.first) != i) return "a child does not know its parent";
        if (!is_same(box, united(box, united(bvh.box(here.first), bvh.box(here.first + 1)))))
          return "a child reaches out of its parent's box";
        open.insert(open.end(), {here.first, here.first + 1});
        continue;
      }
      if (here.count > Bvh::leaf_capacity) return "a leaf is overfull";
      if (!is_same(box, united(box, bvh.leaf_box(positions, here)))) return "a primitive reaches out of its leaf's box";
      for (std::uint32_t k = 0; k < here.count; ++k)
        if (bvh.leaf_of_[bvh.blocks_[here.first][k]] != i) return "a slot does not know its leaf";
      seen += here.count;
    }
    return nullptr;
  }
};

inline const char* find_defect(const Bvh& bvh, std::span<const glm::dvec3> positions) {
  return BvhInspector{bvh, positions}.find_defect();
}

}  // namespace ryosen
