#include "ryosen/ops/rules/shorten_seam.h"

#include <cstddef>
#include <numeric>

namespace ryosen {

std::size_t Seam::size() const {
  std::size_t twice = 0;
  for (std::uint32_t f = 0; f < graph_.size(); ++f)
    for (std::uint32_t i = graph_.offsets[f]; i < graph_.offsets[f + 1]; ++i) twice += disagrees(f, graph_.sides[i]);
  return twice / 2;
}

void Seam::shorten() {
  // Flipping a single face may split its patch, so repeat.
  do join_patches();
  while (turn_faces());
}

// Traverses the patches breadth-first, alternating flipped and unflipped across the seam: all joints between two
// patches disagree, so flipping one of them makes all agree.
void Seam::join_patches() {
  std::vector<bool> seen(graph_.size(), false), flipped(graph_.size(), false);
  std::vector<std::uint32_t> patch, reached;
  std::vector<std::pair<std::uint32_t, bool>> beyond{{0, false}};
  for (std::size_t next = 0; next < beyond.size(); ++next) {
    const auto [start, flip] = beyond[next];
    if (seen[start]) continue;
    seen[start] = true;
    patch.assign(1, start);
    for (std::size_t k = 0; k < patch.size(); ++k) {
      const std::uint32_t f = patch[k];
      flipped[f] = flip;
      for (std::uint32_t i = graph_.offsets[f]; i < graph_.offsets[f + 1]; ++i) {
        const FaceGraph::Side& side = graph_.sides[i];
        if (seen[side.face]) continue;
        if (disagrees(f, side)) {
          beyond.emplace_back(side.face, !flip);
        } else {
          seen[side.face] = true;
          patch.push_back(side.face);
        }
      }
    }
  }
  for (std::uint32_t f = 0; f < graph_.size(); ++f) turned_[f] = turned_[f] != flipped[f];
}

bool Seam::disagrees_mostly(std::uint32_t face) const {
  std::uint32_t against = 0;
  for (std::uint32_t i = graph_.offsets[face]; i < graph_.offsets[face + 1]; ++i)
    against += disagrees(face, graph_.sides[i]);
  return 2 * against > graph_.offsets[face + 1] - graph_.offsets[face];
}

// Each flip shortens the seam, so the total queue length is bounded.
bool Seam::turn_faces() {
  std::vector<std::uint32_t> queue(graph_.size());
  std::iota(queue.begin(), queue.end(), 0u);
  std::vector<bool> waits(graph_.size(), true);
  bool any = false;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::uint32_t f = queue[next];
    waits[f] = false;
    if (!disagrees_mostly(f)) continue;
    any = true;
    turned_[f] = !turned_[f];
    for (std::uint32_t i = graph_.offsets[f]; i < graph_.offsets[f + 1]; ++i) {
      const std::uint32_t other = graph_.sides[i].face;
      if (waits[other]) continue;
      waits[other] = true;
      queue.push_back(other);
    }
  }
  return any;
}

}  // namespace ryosen
