#include "ryosen/algo/simplify/simplify.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>

#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/preparation.h"
#include "ryosen/algo/proposals.h"
#include "ryosen/algo/seams/flat_normals.h"
#include "ryosen/algo/seams/seam_mode.h"
#include "ryosen/algo/simplify/goal_text.h"
#include "ryosen/algo/transform/moved_points.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/count_text.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/triangulate.h"

namespace ryosen {

namespace {

bool has_face_goal(const ParameterValues& values) { return values.has("faces") || values.has("ratio"); }

// A number of faces alone says nothing of the shape; whoever states an error or a distance has said what it may cost.
bool stops_by_shape(const ParameterValues& values) {
  return has_face_goal(values) && !values.has("error") && !values.has("max_distance") && !values.flag("force");
}

// Of all faces as they are when polygons are cut, those set aside included; without a number or a share, none are
// wanted and the error decides.
std::size_t faces_wanted(const ParameterValues& values, std::size_t faces) {
  constexpr double rounding = 1e-6;  // 0.29 of 100 is 29
  std::size_t wanted = has_face_goal(values) ? faces : 0;
  if (values.has("faces")) wanted = std::min(wanted, values.count("faces"));
  if (values.has("ratio"))
    wanted = std::min(wanted, static_cast<std::size_t>(values.ratio("ratio") * static_cast<double>(faces) + rounding));
  return wanted;
}

double diagonal(const Mesh& mesh) {
  const ScaledPlaces scale(mesh.positions());
  Box box;
  for (const Vertex v : live_vertices(mesh))
    if (is_finite(mesh.position(v))) box.add(scale.scaled(mesh.position(v)));
  return box.is_empty() ? 0 : scale.restored_length(glm::length(box.highest - box.lowest));
}

// The value of "error" or "max_distance", in units of the mesh; infinite without one.
double limit_of(const Mesh& mesh, const ParameterValues& values, std::string_view id) {
  if (!values.has(id)) return std::numeric_limits<double>::infinity();
  const bool is_share = values.flag("relative") && !values.was_share(id);
  return values.length(id) * (is_share ? diagonal(mesh) : 1);
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

CollapseLimits limits_of(const Mesh& mesh, const AlgorithmInput& input) {
  const ParameterValues& values = input.values;
  CollapseLimits limits;
  const std::string_view boundary = values.choice("boundary");
  limits.boundary = boundary == "free"     ? BoundaryMode::free
                    : boundary == "locked" ? BoundaryMode::locked
                                           : BoundaryMode::weighted;
  limits.seams = seam_mode_of(values);
  limits.error = limit_of(mesh, values, "error");
  limits.turn_rad = values.angle_rad("max_turn");
  limits.smallest_angle_rad = values.angle_rad("min_angle");
  limits.colour_weight = values.number("colour_weight");
  limits.fixed = fixed_vertices(mesh, values);
  limits.on_lines = input.on_lines;
  return limits;
}

// Why something cannot be kept where a face is no triangle.
std::optional<Text> why_triangles_are_needed(const Mesh& mesh, const Text& consequence) {
  for (const Face f : live_faces(mesh))
    if (!is_triangle(mesh, mesh.halfedge(f)) || mesh.has_rings(f))
      return Text{
          name_of(mesh, f) + " is no triangle, so that " + consequence.en + "; with triangulate it is cut first",
          name_of(mesh, f) + " が三角形でないため、" + consequence.ja +
              "（triangulate を指定すると先に三角形に分割します）"};
  return std::nullopt;
}

const Text distance_is_not_kept{"its distance cannot be kept", "距離を保てません"};
const Text faces_are_not_kept_apart{"faces cannot be kept from meeting", "面の交差を防げません"};

// The mesh is the one before the cut.
Text why_cut_is_too_far(const Mesh& mesh, double distance) {
  for (const Vertex v : live_vertices(mesh))
    if (std::isinf(distance) && !is_finite(mesh.position(v)))
      return {name_of(mesh, v) +
                  " has no finite position, so that its faces are measured only when they are cut; run "
                  "give_places first",
              name_of(mesh, v) + " の座標が有限でなく、切る前の面を測れません（先に give_places を実行してください）"};
  const std::string far = to_three_digits(1.005 * distance);  // not rounded down
  return {"polygons cut into triangles lie up to " + far + " from what they were; give a max_distance above that",
          "多角形を三角形に分割すると面が最大 " + far + " ずれます（max_distance をそれより大きくしてください）"};
}

constexpr std::size_t most_crossings = 100'000;  // that are counted

// The pairs of faces that meet, up to one more than are counted; none where it was cancelled.
std::optional<std::size_t> count_crossings(const Mesh& mesh, Progress& progress) {
  const auto found = find_few_self_intersections(mesh, most_crossings, progress);
  if (!found) return std::nullopt;
  return std::min(found->count, most_crossings + 1);
}

Text crossings_text(std::size_t before, std::size_t after) {
  const auto text_of = [](std::size_t count, std::string_view one, std::string_view many, std::string_view more) {
    if (count > most_crossings) return count_text(most_crossings, more, more, "# 組超");
    return count_text(count, one, many, "# 組");
  };
  const Text was = text_of(before, "One pair of faces crossed", "# pairs of faces crossed",
                           "More than # pairs of faces crossed"),
             is = text_of(after, "one still does", "# still do", "more than # still do");
  return {" " + was.en + ", " + (after == 0 ? "none still does" : is.en) + ".",
          "交わる面は " + was.ja + "から " + is.ja + "へ。"};
}

// What is simplified, or why it cannot be.
struct Prepared {
  Mesh work;  // a copy, so that what is cancelled leaves no trace
  bool is_triangulated = false;
  double distance_of_cut = 0;  // of its triangles from the polygons as they are measured; 0 where it does not matter
  std::optional<Text> refused = {};
  std::vector<std::uint8_t> flat_faces = {};  // whose normals were taken off
  std::size_t crossings = 0;                  // where no further ones may come
};

// A bound of the distance; 0 where neither has a surface, infinite where one alone has.
double distance_between(const Mesh& a, const Mesh& b, Progress& progress) {
  const bool has_a = has_surface(a), has_b = has_surface(b);
  if (!has_a || !has_b) return has_a == has_b ? 0 : std::numeric_limits<double>::infinity();
  const auto distance = surface_distance(a, b, {}, progress);
  return distance ? distance->hausdorff : 0;
}

void triangulate(Prepared& prepared, Descent* descent) {
  const bool is_asked = !prepared.flat_faces.empty() || (descent && descent->is_recording());
  Descent parts = is_asked ? Descent(prepared.work) : Descent();
  Edit batch(prepared.work, nullptr, &parts);
  Triangulate{}.apply(batch);
  batch.commit();
  if (!prepared.flat_faces.empty()) prepared.flat_faces = flags_of_parts(prepared.flat_faces, prepared.work, parts);
  if (descent && descent->is_recording()) descent->follow(parts);
}

Prepared prepare(const Mesh& mesh, const ParameterValues& values, Progress& progress, Descent* descent = nullptr) {
  if (mesh.live().faces == 0)
    return {.work = {}, .refused = Text{"there are no faces to simplify", "簡略化する面がありません"}};
  Prepared prepared{mesh, values.flag("triangulate") && Triangulate{}.check(mesh).legal()};
  prepared.flat_faces = prepare_seams(prepared.work, seam_mode_of(values));
  Edit batch(prepared.work, nullptr);
  share_equal_values(batch);
  batch.commit();
  if (prepared.is_triangulated) triangulate(prepared, descent);
  if (values.has("max_distance")) {
    prepared.refused = why_triangles_are_needed(prepared.work, distance_is_not_kept);
    if (prepared.is_triangulated) prepared.distance_of_cut = distance_between(mesh, prepared.work, progress);
    if (prepared.distance_of_cut > limit_of(mesh, values, "max_distance"))
      prepared.refused = why_cut_is_too_far(mesh, prepared.distance_of_cut);
  }
  if (prepared.refused || !values.flag("no_self_intersections")) return prepared;
  prepared.refused = why_triangles_are_needed(prepared.work, faces_are_not_kept_apart);
  if (!prepared.refused) prepared.crossings = count_crossings(prepared.work, progress).value_or(0);  // cancelled
  return prepared;
}

// One way to the goal, on a mesh of its own.
class Attempt {
 public:
  // `before` is the mesh as it was, of triangles where they were cut, and outlives it.
  Attempt(Mesh work, Descent descent, const AlgorithmInput& input, const SimplifyGoal& goal, const Mesh& before)
      : work_(std::move(work)),
        descent_(std::move(descent)),
        simplifier_(work_, limits_of(work_, input), goal, nullptr, &before, &descent_) {}
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  bool run(Progress& progress) { return simplifier_.run(progress); }
  Mesh& work() { return work_; }
  const Descent& descent() const { return descent_; }
  Simplifier& simplifier() { return simplifier_; }

 private:
  Mesh work_;
  Descent descent_;
  Simplifier simplifier_;
};

// Whether the surface of one mesh lies nearer to that of another one than a third does, as the root of the mean square.
bool lies_nearer(const Mesh& mesh, const Mesh& than, const Mesh& to, Progress& progress) {
  if (!has_surface(mesh) || !has_surface(than) || !has_surface(to)) return false;
  constexpr std::uint64_t fewest_samples = 20000, samples_per_face = 4;
  const DistanceOptions of_means{
      .gap = 1, .samples = std::max(fewest_samples, samples_per_face * std::uint64_t{to.live().faces})};
  const auto distance = surface_distance(to, mesh, of_means, progress),
             other = distance ? surface_distance(to, than, of_means, progress) : std::nullopt;
  return other && distance->rms < other->rms;
}

// Null: cancelled. More effort loses less nearly everywhere; where it loses more, the result of effort 1 takes its
// place.
std::unique_ptr<Attempt> attempted(Mesh work, Descent descent, const AlgorithmInput& input, SimplifyGoal goal,
                                   const Mesh& before, Progress& progress) {
  if (goal.effort < 2) {
    auto attempt = std::make_unique<Attempt>(std::move(work), std::move(descent), input, goal, before);
    return attempt->run(progress) ? std::move(attempt) : nullptr;
  }
  auto attempt = std::make_unique<Attempt>(work, descent, input, goal, before);
  if (!attempt->run(progress)) return nullptr;
  goal.effort = 1;
  auto other = std::make_unique<Attempt>(std::move(work), std::move(descent), input, goal, before);
  if (!other->run(progress)) return nullptr;
  const std::uint32_t faces = attempt->work().live().faces, other_faces = other->work().live().faces;
  if (std::max(faces, other_faces) > goal.faces && faces != other_faces)
    return faces < other_faces ? std::move(attempt) : std::move(other);
  const bool is_nearer = lies_nearer(other->work(), attempt->work(), before, progress);
  if (progress.is_cancelled()) return nullptr;
  return is_nearer ? std::move(other) : std::move(attempt);
}

SimplifyGoal goal_of(const Prepared& prepared, const ParameterValues& values, std::size_t faces) {
  return {faces,
          static_cast<unsigned>(values.count("effort")),
          values.flag("no_self_intersections"),
          prepared.crossings > 0,
          values.flag("remove_small"),
          stops_by_shape(values),
          values.choice("topology") == "change",
          values.flag("force"),
          limit_of(prepared.work, values, "max_distance") - prepared.distance_of_cut};
}

// Why it ended before it reached a number of faces.
Stop stop_before(const std::vector<std::size_t>& remaining, const SimplifyGoal& goal, Simplifier& simplifier,
                 Progress& progress) {
  if (simplifier.has_parts_too_far()) return Stop::shape;
  const auto held_by = [&](EdgeRule rule) { return remaining[static_cast<std::size_t>(rule)]; };
  const std::size_t error = held_by(EdgeRule::error), distance = held_by(EdgeRule::distance);
  if (distance > error) return Stop::distance;
  if (error > 0) return goal.keeps_shape ? Stop::shape : Stop::error;
  return simplifier.has_edges_held_by_boundaries(progress) ? Stop::shape : Stop::blocked;
}

// Tells what holds the edges of a mesh most of which are misoriented; false for any other.
bool leave_misoriented(const Mesh& mesh, const AlgorithmInput& input, AlgorithmResult& result, Progress& progress) {
  const EdgeAgreement agreement = count_agreement(mesh);
  if (!agreement.is_lost()) return false;
  Mesh copy = mesh;
  GoalReport& report = result.goal_report.emplace();
  report = {Stop::shape, false, 0.0};
  report.rules = find_remaining(mesh, Simplifier(copy, limits_of(copy, input), {}), progress);
  report.remaining = count_remaining(mesh, report.rules);
  if (progress.is_cancelled()) report = {Stop::cancelled, false};
  result.text = text_of_misoriented(agreement);
  return true;
}

}  // namespace

AlgorithmResult simplify(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  AlgorithmResult result;
  if (values.choice("topology") == "change" && values.flag("no_self_intersections")) {
    result.fault = {"topology=change may make faces that meet; it cannot be used with no_self_intersections",
                    "topology=change では面が交わることがあり、no_self_intersections と同時には使えません"};
    return result;
  }
  Descent descent = edit.new_descent();
  Prepared prepared = prepare(edit.mesh(), values, progress, &descent);
  if ((result.refused = prepared.refused)) return result;
  if (stops_by_shape(values) && leave_misoriented(edit.mesh(), input, result, progress)) return result;
  const std::size_t before = edit.mesh().live().faces + input.quarantined;
  const std::size_t wanted = faces_wanted(values, prepared.work.live().faces + input.quarantined);
  const SimplifyGoal goal = goal_of(prepared, values, wanted - std::min(wanted, input.quarantined));
  const std::optional<Mesh> cut = prepared.is_triangulated ? std::optional(prepared.work) : std::nullopt;
  GoalReport& report = result.goal_report.emplace();
  const auto attempt =
      attempted(std::move(prepared.work), std::move(descent), input, goal, cut ? *cut : edit.mesh(), progress);
  if (!attempt) {
    report = {Stop::cancelled, false};
    return result;
  }
  Mesh& work = attempt->work();
  Simplifier& simplifier = attempt->simplifier();
  const std::optional<std::size_t> crossings = prepared.crossings > 0 ? count_crossings(work, progress) : 0;
  const std::size_t after = work.live().faces + input.quarantined;
  const bool is_by_number = has_face_goal(values);
  if (input.wants.edge_rules || !is_by_number || after > wanted) {
    report.rules = find_remaining(work, simplifier, progress);
    report.remaining = count_remaining(work, report.rules);
  }
  if (!is_by_number || after > wanted) report.stopped = stop_before(report.remaining, goal, simplifier, progress);
  if (progress.is_cancelled()) {
    report = {Stop::cancelled, false};
    return result;
  }
  report.is_reached =
      is_by_number ? after <= wanted : report.stopped == Stop::error || report.stopped == Stop::distance;
  report.error_max = simplifier.error_max();
  const TopologyChange change{goal.changes_topology, simplifier.closed_handles(), simplifier.joined_parts(),
                              simplifier.has_parts_too_far()};
  result.text = text_of_goal(work, before, after, report, change);
  if (prepared.crossings > 0) result.text += crossings_text(prepared.crossings, *crossings);
  const Text dropped = dropped_text(edit.mesh(), seam_mode_of(values));
  result.text += dropped;
  result.changed = simplifier.collapses() + simplifier.removed_parts() + change.closed_handles + change.joined_parts +
                   (prepared.is_triangulated ? 1 : 0) + (dropped.en.empty() ? 0 : 1);
  prepared.flat_faces.resize(prepared.flat_faces.empty() ? 0 : work.face_slots());
  if (result.changed > 0 && !prepared.flat_faces.empty()) put_flat_normals(work, prepared.flat_faces, edit.mesh());
  if (result.changed > 0) edit.replace(std::move(work).columns(), attempt->descent());
  return result;
}

BuiltLevels build_levels(const Mesh& mesh, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  Prepared prepared = prepare(mesh, values, progress);
  if (prepared.refused) return {nullptr, prepared.refused};
  const CollapseLimits limits = limits_of(prepared.work, input);
  SimplifyGoal goal = goal_of(prepared, values, faces_wanted(values, mesh.live().faces));
  goal.changes_topology = false;  // a level has at most as many faces as the one before
  goal.keeps_shape = false;       // whoever goes through them sees what is lost
  goal.lets_boundaries_go = true;
  goal.effort = 0;  // and what they see is what simplify makes of it
  auto levels = std::make_unique<DetailLevels>(std::move(prepared.work));
  if (!levels->build(limits, goal, progress)) levels.reset();
  return {std::move(levels)};
}

bool DetailLevels::build(const CollapseLimits& limits, const SimplifyGoal& goal, Progress& progress) {
  assert(last() == 0);
  const bool is_done = Simplifier(mesh_, limits, goal, &journal_).run(progress);
  std::vector<std::uint32_t> faces;
  for (; journal_.can_undo(); journal_.undo(mesh_)) faces.push_back(mesh_.live().faces);
  if (!is_done) {
    journal_.clear();
    return false;
  }
  faces_.insert(faces_.end(), faces.rbegin(), faces.rend());
  return true;
}

void DetailLevels::go_to(std::size_t level) {
  assert(level <= last());
  while (journal_.position() > level) journal_.undo(mesh_);
  while (journal_.position() < level) journal_.redo(mesh_);
}

std::size_t DetailLevels::level_of(std::size_t faces) const {
  const auto found = std::partition_point(faces_.begin(), faces_.end(), [&](std::uint32_t f) { return f > faces; });
  return found == faces_.end() ? last() : static_cast<std::size_t>(found - faces_.begin());
}

}  // namespace ryosen
