#include "core/algo/simplify/simplify.h"

#include <algorithm>
#include <cmath>

#include "core/algo/simplify/remaining_edges.h"
#include "core/algo/simplify/shared_values.h"
#include "core/algo/simplify/simplifier.h"
#include "core/algo/transform/moved_points.h"
#include "core/analysis/self_intersections.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/names.h"
#include "core/ops/triangulate.h"

namespace ryosen {

namespace {

// Of all faces, those set aside included; without a number or a share, none are wanted and the error decides.
std::size_t faces_wanted(const ParameterValues& values, std::size_t faces) {
  std::size_t wanted = values.has("faces") || values.has("ratio") ? faces : 0;
  if (values.has("faces")) wanted = std::min(wanted, values.count("faces"));
  if (values.has("ratio"))
    wanted = std::min(wanted, static_cast<std::size_t>(values.ratio("ratio") * static_cast<double>(faces)));
  return wanted;
}

double diagonal(const Mesh& mesh) {
  const ScaledPlaces scale(mesh.positions());
  Box box;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (const Vertex v(i); mesh.is_alive(v) && is_finite(mesh.position(v))) box.add(scale.scaled(mesh.position(v)));
  return box.is_empty() ? 0 : scale.restored_length(glm::length(box.highest - box.lowest));
}

double error_of(const Mesh& mesh, const ParameterValues& values) {
  if (!values.has("error")) return std::numeric_limits<double>::infinity();
  return values.length("error") * (values.flag("relative") ? diagonal(mesh) : 1);
}

// By vertex: not 0 where it is locked, or where others are selected.
std::vector<std::uint8_t> fixed_vertices(const Mesh& mesh, const ParameterValues& values) {
  std::vector<std::uint8_t> fixed;
  const auto mark = [&](std::string_view id, std::uint8_t value) {
    for (Vertex point : points_of(mesh, values.elements(id)))
      for_each_copy(mesh, point, [&](Vertex copy) { fixed[copy.index] = value; });
  };
  if (values.has("select")) {
    fixed.assign(mesh.vertex_slots(), 1);
    mark("select", 0);
  }
  if (values.has("lock")) {
    fixed.resize(mesh.vertex_slots());
    mark("lock", 1);
  }
  return fixed;
}

CollapseLimits limits_of(const Mesh& mesh, const ParameterValues& values) {
  CollapseLimits limits;
  const std::string_view boundary = values.choice("boundary");
  limits.boundary = boundary == "free"     ? BoundaryMode::free
                    : boundary == "locked" ? BoundaryMode::locked
                                           : BoundaryMode::weighted;
  limits.error = error_of(mesh, values);
  limits.turn_rad = values.angle_rad("max_turn");
  limits.smallest_angle_rad = values.angle_rad("min_angle");
  limits.fixed = fixed_vertices(mesh, values);
  return limits;
}

std::optional<Text> why_faces_cannot_be_kept_apart(const Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
    if (const Face f(i); mesh.is_alive(f) && (!is_triangle(mesh, mesh.halfedge(f)) || mesh.has_rings(f)))
      return Text{
          name_of(mesh, f) + " is no triangle, so that faces cannot be kept from meeting; triangulate=on does",
          name_of(mesh, f) + " が三角形でないため、面の交差を防げません（triangulate=on で三角形に分割できます）"};
  const std::size_t pairs = find_self_intersections(mesh, 0).count;
  if (pairs == 0) return std::nullopt;
  const std::string n = std::to_string(pairs);
  return Text{n + " pairs of faces meet already, so that it cannot be kept free of them",
              "すでに " + n + " 組の面が交わっているため、交差のない状態を保てません"};
}

Text text_of(std::size_t before, std::size_t after, const Account& account) {
  const std::string a = std::to_string(before), b = std::to_string(after);
  Text text{"From " + a + " to " + b + " faces", "面 " + a + " 枚から " + b + " 枚へ"};
  if (account.stopped == Stop::error) return text + Text{"; more would go beyond the error.", "（許容誤差まで）。"};
  if (account.stopped == Stop::blocked)
    return text + Text{"; no edge that is left can collapse.", "（残りの稜線はどれも縮約できません）。"};
  return text + Text{".", "。"};
}

}  // namespace

AlgorithmResult simplify(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Mesh& mesh = edit.mesh();
  const ParameterValues& values = input.values;
  AlgorithmResult result;
  if (mesh.live().faces == 0) {
    result.refused = Text{"there are no faces to simplify", "簡略化する面がありません"};
    return result;
  }
  const std::size_t before = mesh.live().faces + input.quarantined;
  Mesh work = mesh;  // a copy, so that one that is cancelled leaves no trace
  const bool is_triangulated = values.flag("triangulate") && Triangulate{}.check(work).legal();
  {
    Edit batch(work, nullptr);
    if (is_triangulated) Triangulate{}.apply(batch);
    share_equal_values(batch);
  }
  const bool keeps_apart = values.flag("no_self_intersections");
  if (keeps_apart && (result.refused = why_faces_cannot_be_kept_apart(work))) return result;
  const std::size_t wanted = faces_wanted(values, before);
  const SimplifyGoal goal{wanted - std::min(wanted, input.quarantined), static_cast<unsigned>(values.count("effort")),
                          keeps_apart, values.flag("remove_small")};
  Simplifier simplifier(work, limits_of(work, values), goal);
  Account& account = result.account.emplace();
  if (!simplifier.run(progress)) {
    account = {Stop::cancelled, false};
    return result;
  }
  const std::size_t after = work.live().faces + input.quarantined;
  const bool has_number = values.has("faces") || values.has("ratio");
  if (input.wants_account || !has_number || after > wanted) account.remaining = count_remaining(work, simplifier);
  if (!has_number || after > wanted)
    account.stopped = account.remaining[static_cast<std::size_t>(EdgeRule::error)] > 0 ? Stop::error : Stop::blocked;
  account.is_reached = has_number ? after <= wanted : account.stopped == Stop::error;
  account.error_max = simplifier.error_max();
  result.text = text_of(before, after, account);
  result.changed = simplifier.collapses() + simplifier.removed_parts() + (is_triangulated ? 1 : 0);
  if (result.changed > 0) edit.replace(work.columns());
  return result;
}

}  // namespace ryosen
