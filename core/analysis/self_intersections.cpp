#include "core/analysis/self_intersections.h"

#include <algorithm>
#include <utility>

#include "core/analysis/overlap_tree.h"
#include "core/base/parallel.h"
#include "core/base/sort_unique.h"
#include "core/geometry/triangles_meet.h"

namespace ryosen {

namespace {

// Distinct pairs, full once there are more than `most`. Faces with many triangles report a pair repeatedly.
class PairList {
 public:
  explicit PairList(std::size_t most) : most_(most), compact_at_(most) {}

  void add(const FacePair& pair) {
    pairs_.push_back(pair);
    if (pairs_.size() > compact_at_) compact();
  }
  void compact() {
    sort_unique(pairs_);
    compact_at_ = std::max(most_, 2 * pairs_.size());
    is_full_ = pairs_.size() > most_;
  }
  bool is_full() const { return is_full_; }
  std::vector<FacePair> take() { return std::exchange(pairs_, {}); }

 private:
  std::size_t most_, compact_at_;
  std::vector<FacePair> pairs_;
  bool is_full_ = false;
};

void add_if_they_meet(const NumberedSurface& surface, std::uint32_t a, std::uint32_t b, PairList& pairs) {
  const Face f = surface.face(a), g = surface.face(b);
  if (f != g && meet_elsewhere(surface.triangle(a), surface.triangle(b))) pairs.add({std::min(f, g), std::max(f, g)});
}

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most, unsigned threads) {
  const NumberedSurface surface(mesh);
  if (threads == 0) threads = threads_for(surface.slots());
  const OverlapTree tree(surface, threads);
  // Round and part sizes do not depend on the thread count, so that a search cut short by `most` is deterministic.
  constexpr std::uint32_t part_size = 256, parts = 8;
  PairList all(most);
  for (std::uint32_t round = 0; round < tree.node_count() && !all.is_full(); round += parts * part_size) {
    std::vector<PairList> found(parts, PairList(most));
    for_each_task(parts, threads, [&](unsigned part) {
      const std::uint32_t begin = round + part * part_size, end = std::min(begin + part_size, tree.node_count());
      for (std::uint32_t node = begin; node < end; ++node)
        if (!tree.visit_pairs(node, [&](std::uint32_t a, std::uint32_t b) {
              add_if_they_meet(surface, a, b, found[part]);
              return !found[part].is_full();
            }))
          return;
    });
    for (PairList& pairs : found)
      for (const FacePair& pair : pairs.take())
        if (!all.is_full()) all.add(pair);
  }
  all.compact();
  SelfIntersections result{all.take(), !all.is_full()};
  if (!result.is_all) result.pairs.resize(most);
  return result;
}

std::vector<Face> faces_of(const std::vector<FacePair>& pairs) {
  std::vector<Face> faces;
  faces.reserve(2 * pairs.size());
  for (const FacePair& pair : pairs) {
    faces.push_back(pair.first);
    faces.push_back(pair.second);
  }
  sort_unique(faces);
  return faces;
}

}  // namespace ryosen
