#include "app/editor/shown/snapping.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "app/editor/camera/framing.h"
#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/pointing.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

struct NearPoint {
  double distance_px;
  ScreenPoint seen;
  Vertex point;
  bool operator<(const NearPoint& other) const {
    return std::tie(distance_px, seen.depth, point) < std::tie(other.distance_px, other.seen.depth, other.point);
  }
};

}  // namespace

Vertex held_point(Findings& findings, const ViewState& view, const Preferences& preferences,
                  const std::vector<MovedPoint>& moved, glm::dvec2 pixel) {
  if (moved.size() == 1) return moved[0].point;
  const Mesh& mesh = findings.mesh();
  const double radius_px = snap_radius_px * preferences.size_scale();
  std::vector<NearPoint> near;
  for (const MovedPoint& each : moved) {
    const auto seen = project(view.camera, view.size, mesh.position(each.point));
    if (!seen) continue;
    const double distance_px = glm::length(seen->pixel - pixel);
    if (distance_px <= radius_px) near.push_back({distance_px, *seen, each.point});
  }
  std::sort(near.begin(), near.end());
  const bool is_all_seen = pick_depth(view) == Picker::Depth::through || findings.preparing();
  for (const NearPoint& each : near)
    if (is_all_seen ||
        findings.picker(view).is_seen(mesh, view.camera, view.size, each.seen, mesh.position(each.point)))
      return each.point;
  return {};
}

std::optional<SnapTarget> snap_target(Findings& findings, const ViewState& view, const Preferences& preferences,
                                      glm::dvec2 pixel, const PassedOver& own) {
  const Size size = view.size;
  if (findings.preparing() || pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height)
    return std::nullopt;
  constexpr std::pair<PickMode, double> sorts[] = {
      {PickMode::vertex, snap_radius_px}, {PickMode::edge, pick_radius_px}, {PickMode::face, 0}};
  for (const auto& [what, radius_px] : sorts)
    if (const auto picked = findings.picker(view).pick(findings.mesh(), view.camera, size, pixel, what,
                                                       pick_depth(view), radius_px * preferences.size_scale(), &own))
      return SnapTarget{picked->element, picked->place, name_to_select(findings.mesh(), picked->element)};
  return std::nullopt;
}

RoundStep step_of_ground(const Mesh& mesh) {
  glm::dvec3 size(0);
  with_places_of_edges(mesh, [&](std::span<const glm::dvec3> places) {
    const Box box = bounds_of(places);
    size = box.highest - box.lowest;
  });
  const double extent = ground_extent(size);
  return ground_step(extent > 0 && std::isfinite(extent) ? extent : 1);
}

}  // namespace ryosen
