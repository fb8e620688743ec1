#include "app/editor/camera/cutting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/editor/camera/view_state.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

glm::dvec3 normal_of(ClipWay way, const Camera& camera) {
  if (way == ClipWay::x || way == ClipWay::minus_x) return {way == ClipWay::x ? 1 : -1, 0, 0};
  if (way == ClipWay::y || way == ClipWay::minus_y) return {0, way == ClipWay::y ? 1 : -1, 0};
  if (way == ClipWay::z || way == ClipWay::minus_z) return {0, 0, way == ClipWay::z ? 1 : -1};
  return -axes(camera).forward;
}

}  // namespace

void cut_across(const Mesh& mesh, ViewState& view, ClipWay way) {
  view.cut.reset();
  if (way == ClipWay::off) return;
  view.cut = Cut{way, 0.5, {normal_of(way, view.camera), 0}};
  move_cut(mesh, view, 0.5);
}

void move_cut(const Mesh& mesh, ViewState& view, double share) {
  Cut& cut = *view.cut;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    if (!mesh.is_alive(Vertex(i))) continue;
    const double along = glm::dot(cut.plane.normal, mesh.position(Vertex(i)));
    if (!std::isfinite(along)) continue;
    lowest = std::min(lowest, along);
    highest = std::max(highest, along);
  }
  cut.share = std::clamp(share, 0.0, 1.0);
  cut.plane.offset = lowest <= highest ? std::lerp(lowest, highest, cut.share) : 0;
}

}  // namespace ryosen
