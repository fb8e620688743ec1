#include "core/analysis/self_intersections.h"

#include <algorithm>
#include <array>

#include "core/analysis/overlap_tree.h"
#include "core/base/sort_unique.h"
#include "core/build/parallel.h"
#include "core/geometry/triangles_meet.h"

namespace ryosen {

namespace {

void add_if_they_meet(const NumberedSurface& surface, std::uint32_t a, std::uint32_t b, std::vector<FacePair>& pairs) {
  const Face f = surface.face(a), g = surface.face(b);
  if (f != g && meet_elsewhere(surface.triangle(a), surface.triangle(b)))
    pairs.push_back({std::min(f, g), std::max(f, g)});
}

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most, unsigned threads) {
  const NumberedSurface surface(mesh);
  if (threads == 0) threads = threads_for(surface.slots());
  const OverlapTree tree(surface, threads);
  // Rounds and parts are of one size however many threads there are, so that a search that ends early ends alike.
  constexpr std::uint32_t part_size = 256, parts = 32;
  SelfIntersections result;
  for (std::uint32_t round = 0; round < tree.node_count() && result.is_all; round += parts * part_size) {
    std::array<std::vector<FacePair>, parts> found;
    for_each_task(parts, threads, [&](unsigned part) {
      const std::uint32_t begin = round + part * part_size, end = std::min(begin + part_size, tree.node_count());
      for (std::uint32_t node = begin; node < end; ++node)
        if (!tree.visit_pairs(node, [&](std::uint32_t a, std::uint32_t b) {
              add_if_they_meet(surface, a, b, found[part]);
              return found[part].size() <= most;
            }))
          return;
    });
    for (const std::vector<FacePair>& pairs : found) {
      result.is_all = result.is_all && pairs.size() <= most;
      result.pairs.insert(result.pairs.end(), pairs.begin(), pairs.end());
    }
    if (result.pairs.size() > most) sort_unique(result.pairs);
    result.is_all = result.is_all && result.pairs.size() <= most;
  }
  sort_unique(result.pairs);
  if (!result.is_all) result.pairs.resize(std::min(most, result.pairs.size()));
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
