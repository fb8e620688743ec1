#include "ryosen/algo/repair/plan_patch.h"

#include <algorithm>

#include "ryosen/algo/repair/hole_triangles.h"
#include "ryosen/algo/repair/fair_patch.h"
#include "ryosen/algo/repair/patch_crossings.h"
#include "ryosen/algo/repair/refine_patch.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/single_precision.h"

namespace ryosen {

namespace {

bool is_weighed(const HoleLoop& hole) { return hole.size() <= most_weighed_corners; }

// The growth of edges per unit of distance from the rim: slowly where the triangles are to be even, and fast
// where a few do.
constexpr double growth_of_fair = 0.1, growth_of_flat = 0.4;

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

HoleTriangles projected_triangles(const HoleLoop& hole, Progress&) { return project_triangles(hole); }

HoleTriangles unprojected_triangles(const HoleLoop& hole, Progress& progress) {
  return is_weighed(hole) ? weigh_triangles(hole, progress) : cut_ears(hole, progress);
}

constexpr WayToFill fair_ways[] = {
    {best_triangles, Fineness::fair},    {other_triangles, Fineness::fair},   {best_triangles, Fineness::even},
    {other_triangles, Fineness::even},   {best_triangles, Fineness::bare},    {other_triangles, Fineness::bare},
    {fan_around_middle, Fineness::fair}, {fan_around_middle, Fineness::bare},
};

constexpr WayToFill unfaired_ways[] = {
    {best_triangles, Fineness::even},  {other_triangles, Fineness::even},   {best_triangles, Fineness::bare},
    {other_triangles, Fineness::bare}, {fan_around_middle, Fineness::bare},
};

constexpr WayToFill planar_ways[] = {
    {projected_triangles, Fineness::even}, {unprojected_triangles, Fineness::even},
    {projected_triangles, Fineness::bare}, {unprojected_triangles, Fineness::bare},
    {fan_around_middle, Fineness::bare},
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

// In the last turn no more vertices come.
constexpr FairMove moves[] = {FairMove::all_the_way, FairMove::all_the_way, FairMove::along_normals,
                              FairMove::along_normals};
constexpr std::size_t last_turn = std::size(moves) - 1;

void fair_in_turn(std::size_t turn, HolePatch& patch, const HoleLoop& hole, Progress& progress) {
  constexpr double steps = 10000;
  const auto report = [&](double share) {
    return progress.go_on(static_cast<std::size_t>((static_cast<double>(turn) + share) * steps),
                          static_cast<std::size_t>(steps) * std::size(moves));
  };
  Progress of_turn(report, {});
  fair(patch, hole, moves[turn], of_turn);
}

// The weights and the spacing follow the places, so that both are done in turns; so many that the places stay.
void fair_and_refine(HolePatch& patch, const HoleLoop& hole, Progress& progress) {
  for (std::size_t turn = 0; turn < last_turn; ++turn) {
    fair_in_turn(turn, patch, hole, progress);
    refine(patch, hole, growth_of_fair, progress);
  }
}

void round_places(const PatchStyle& style, HolePatch& patch) {
  for (std::uint32_t v = patch.corners; v < patch.places.size(); ++v) {
    glm::dvec3& place = patch.places[v];
    if (style.plane) place = style.plane->nearest(place);
    if (style.snaps_to_floats) place = to_single(place);
  }
}

}  // namespace

std::span<const WayToFill> ways_to_fill(const PatchStyle& style) {
  if (style.fairs) return fair_ways;
  return style.plane ? std::span<const WayToFill>(planar_ways) : unfaired_ways;
}

PlanResult arrange_patch(const WayToFill& way, const HoleTriangles& base, const HoleLoop& hole, const PatchStyle& style,
                         HolePatch& patch, Progress& progress) {
  if (base.triangles.empty()) return {cause_of(base.cause)};
  patch.corners = hole.size();
  patch.places = hole.places;
  patch.triangles = base.triangles;
  if (patch.triangles.size() == patch.corners) add_middle(patch);
  const bool refines = way.fineness >= Fineness::even, fairs = way.fineness == Fineness::fair;
  if (refines) swap_edges(patch, hole, progress);
  if (has_flat_triangle(patch)) return {WhyOpen::without_area};
  if (!style.may_cross && is_flat(hole))
    if (const auto side = side_on_surroundings(hole, patch)) return {WhyOpen::crosses, hole.sides[*side]};
  if (refines) refine(patch, hole, fairs ? growth_of_fair : growth_of_flat, progress);
  if (fairs) fair_and_refine(patch, hole, progress);
  return {};
}

PlanResult finish_patch(const WayToFill& way, const HoleLoop& hole, const PatchStyle& style, HolePatch& patch,
                        Progress& progress) {
  if (way.fineness == Fineness::fair) {
    fair_in_turn(last_turn, patch, hole, progress);
    swap_edges(patch, hole, progress);
  }
  round_places(style, patch);
  if (has_flat_triangle(patch)) return {WhyOpen::without_area};
  if (style.may_cross) return {};
  const auto side = side_on_surroundings(hole, patch);
  return side ? PlanResult{WhyOpen::crosses, hole.sides[*side]} : PlanResult{};
}

}  // namespace ryosen
