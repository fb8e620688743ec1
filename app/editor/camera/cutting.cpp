#include "app/editor/camera/cutting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/editor/camera/view_state.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/script.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

glm::dvec3 normal_of(ClipWay way, const Camera& camera) {
  switch (way) {
    case ClipWay::x:
    case ClipWay::minus_x:
      return {way == ClipWay::x ? 1 : -1, 0, 0};
    case ClipWay::y:
    case ClipWay::minus_y:
      return {0, way == ClipWay::y ? 1 : -1, 0};
    case ClipWay::z:
    case ClipWay::minus_z:
      return {0, 0, way == ClipWay::z ? 1 : -1};
    default:
      return -axes(camera).forward;
  }
}

// A share, or a step with its sign; none for anything else.
std::optional<double> share_of(Words arguments) {
  if (arguments.size() != 1) return std::nullopt;
  std::string_view word = arguments[0];
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto value = parse_double(word);
  return value && std::abs(*value) <= 1 ? value : std::nullopt;
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

std::optional<Text> fault_of_clip_at(Words arguments, const std::string&) {
  if (share_of(arguments)) return std::nullopt;
  return wrong_arguments("clip_at").sentence;
}

Outcome run_clip_at(const Mesh& mesh, ViewState& view, Words arguments, std::string_view) {
  const auto share = share_of(arguments);
  if (!share) return wrong_arguments("clip_at");
  if (!view.cut)
    return failed(ExitCode::refused, {"there is no clipping plane to move; clip x, for one, begins with it",
                                      "動かす断面がありません。clip x などで断面を表示してください"});
  const bool is_step = arguments[0][0] == '+' || arguments[0][0] == '-';
  move_cut(mesh, view, is_step ? view.cut->share + *share : *share);
  return {};
}

}  // namespace ryosen
