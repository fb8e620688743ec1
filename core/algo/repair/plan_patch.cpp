#include "core/algo/repair/plan_patch.h"

#include <algorithm>

#include "core/algo/repair/cut_ears.h"
#include "core/algo/repair/fair_patch.h"
#include "core/algo/repair/patch_crossings.h"
#include "core/algo/repair/refine_patch.h"
#include "core/geometry/predicates.h"
#include "core/geometry/single_precision.h"

namespace ryosen {

namespace {

bool is_weighed(const HoleLoop& hole) { return hole.size() <= most_weighed_corners; }

HoleTriangles best_triangles(const HoleLoop& hole, Progress& progress) {
  return is_weighed(hole) ? weigh_triangles(hole, progress) : project_triangles(hole);
}

HoleTriangles other_triangles(const HoleLoop& hole, Progress& progress) {
  return is_weighed(hole) ? project_triangles(hole) : cut_ears(hole, progress);
}

HoleTriangles fan_around_middle(const HoleLoop& hole, Progress&) {
  HoleTriangles fan;
  for (std::uint32_t i = 0; i < hole.size(); ++i) fan.triangles.push_back({i, (i + 1) % hole.size(), hole.size()});
  return fan;
}

constexpr WayToFill known_ways[] = {
    {best_triangles, true, true},    {other_triangles, true, true},     {best_triangles, true, false},
    {other_triangles, true, false},  {best_triangles, false, false},    {other_triangles, false, false},
    {fan_around_middle, true, true}, {fan_around_middle, false, false},
};

WhyOpen cause_of(NoTriangles cause) {
  return cause == NoTriangles::edge_exists ? WhyOpen::edge_exists : WhyOpen::without_area;
}

void add_middle(HolePatch& patch) {
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : patch.places) mean += p / static_cast<double>(patch.places.size());
  patch.places.push_back(mean);
  patch.parents.push_back({no_index, no_index, no_index});
}

bool has_flat_triangle(const HolePatch& patch) {
  return std::any_of(patch.triangles.begin(), patch.triangles.end(), [&](const CornerTriangle& t) {
    return are_collinear(patch.places[t[0]], patch.places[t[1]], patch.places[t[2]]);
  });
}

}  // namespace

std::span<const WayToFill> ways_to_fill() { return known_ways; }

WhyOpen plan_patch(const WayToFill& way, const HoleTriangles& base, const HoleLoop& hole, bool snaps_to_floats,
                   HolePatch& patch, Progress& progress) {
  if (base.triangles.empty()) return cause_of(base.cause);
  patch.corners = hole.size();
  patch.places = hole.places;
  patch.triangles = base.triangles;
  if (patch.triangles.size() == patch.corners) add_middle(patch);
  if (has_flat_triangle(patch)) return WhyOpen::without_area;
  if (is_flat(hole) && lies_on_surroundings(hole, patch)) return WhyOpen::crosses;
  if (way.refines) refine(patch, hole, progress);
  if (way.fairs) fair(patch, hole, progress);
  if (snaps_to_floats)
    for (std::uint32_t v = patch.corners; v < patch.places.size(); ++v) patch.places[v] = to_single(patch.places[v]);
  if (has_flat_triangle(patch)) return WhyOpen::without_area;
  return lies_on_surroundings(hole, patch) ? WhyOpen::crosses : WhyOpen::filled;
}

}  // namespace ryosen
