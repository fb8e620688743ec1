#include "ryosen/algo/repair/patch_choice.h"

#include <algorithm>
#include <utility>

#include "ryosen/algo/repair/folded_patch.h"
#include "ryosen/base/sort_unique.h"

namespace ryosen {

namespace {

using PatchPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // ascending, the earlier patch first

// The pairs of patches that would make the same edge between points of loops.
PatchPairs pairs_with_an_edge(std::span<const PlannedPatch> planned) {
  using Made = std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;  // points, patch
  std::vector<Made> made;
  for (std::uint32_t k = 0; k < planned.size(); ++k)
    for (const CornerTriangle& t : planned[k].patch.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(t[i], t[(i + 1) % 3]);
        const bool is_side = b == a + 1 || (a == 0 && b == planned[k].patch.corners - 1);
        if (b < planned[k].patch.corners && !is_side)
          made.emplace_back(std::minmax(planned[k].hole.points[a], planned[k].hole.points[b]), k);
      }
  sort_unique(made);
  PatchPairs pairs;
  for (std::size_t i = 0; i < made.size(); ++i)
    for (std::size_t j = i + 1; j < made.size() && made[j].first == made[i].first; ++j)
      pairs.emplace_back(made[i].second, made[j].second);
  sort_unique(pairs);
  return pairs;
}

// Finds what keeps patches out: themselves or the surface, or others.
PatchCrossings obstacles(const Mesh& mesh, std::span<const PlannedPatch> planned, Takes takes, Progress& progress) {
  if (takes < Takes::crossing) return find_patch_crossings(mesh, planned, progress);
  PatchCrossings found{std::vector<bool>(planned.size(), false), std::vector<Face>(planned.size()), {}};
  for (std::uint32_t k = 0; k < planned.size() && takes == Takes::crossing; ++k)
    found.crosses[k] = crosses_itself(planned[k].patch);
  return found;
}

// Excludes both patches of a pair, or the later one only.
void exclude(bool both, const PatchPairs& pairs, WhyOpen why, PatchChoice& choice) {
  const std::vector<WhyOpen> before = choice.cause;
  const std::vector<WhyOpen>& is_in = both ? before : choice.cause;
  for (const auto& [a, b] : pairs) {
    if (is_in[a] != WhyOpen::filled || is_in[b] != WhyOpen::filled) continue;
    if (both) choice.cause[a] = why;
    choice.cause[b] = why;
    choice.conflicts[a] = choice.conflicts[b] = true;
  }
}

}  // namespace

PatchChoice choose_patches(const Mesh& mesh, std::span<const PlannedPatch> planned, Takes takes, Progress& progress) {
  PatchCrossings found = obstacles(mesh, planned, takes, progress);
  PatchChoice choice{std::vector<WhyOpen>(planned.size(), WhyOpen::filled), std::move(found.crossed),
                     std::vector<bool>(planned.size(), false)};
  for (std::uint32_t k = 0; k < planned.size(); ++k)
    if (found.crosses[k]) choice.cause[k] = WhyOpen::crosses;
  exclude(takes == Takes::clear, pairs_with_an_edge(planned), WhyOpen::edge_exists, choice);
  exclude(takes == Takes::clear, found.pairs, WhyOpen::crosses, choice);
  return choice;
}

}  // namespace ryosen
