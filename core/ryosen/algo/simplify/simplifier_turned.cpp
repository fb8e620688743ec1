// How a simplifier mends faces that have come to look against the input (input_sides.h): few do, and where they do
// small changes nearby are enough. None of these breaks a limit that holds for collapses, but that the face mended may
// turn back as far as it likes. Where the input alternates from face to face nearly all do; so this ends where it has
// looked at the input too often, and leaves hubs as they are.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "ryosen/algo/simplify/ring_values.h"
#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/triangle_corners.h"
#include "ryosen/ops/swap_edge.h"

namespace ryosen {

namespace {

std::array<Halfedge, 3> sides_of(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {h, mesh.next(h), mesh.prev(h)};
}

// Ways as long as its longest side, in 26 directions.
std::vector<glm::dvec3> all_around(const TriangleCorners& t) {
  const double length = std::max({glm::length(t[1] - t[0]), glm::length(t[2] - t[1]), glm::length(t[0] - t[2])});
  std::vector<glm::dvec3> ways;
  for (int x : {-1, 0, 1})
    for (int y : {-1, 0, 1})
      for (int z : {-1, 0, 1})
        if (x != 0 || y != 0 || z != 0) ways.push_back(length * glm::normalize(glm::dvec3(x, y, z)));
  return ways;
}

constexpr std::size_t fewest_looks = std::size_t{1} << 18, looks_per_face = 32;

}  // namespace

bool Simplifier::may_look_further() const {
  return sides_->looks() < fewest_looks + looks_per_face * input_->live().faces;
}

bool Simplifier::is_turned(Face f) const { return is_turned(corners_of(mesh_, mesh_.halfedge(f))); }

// The input is only looked at where a face may be turned: where its corners and their neighbours came from.
std::vector<Face> Simplifier::find_turned() {
  std::vector<Face> found;
  std::vector<std::uint8_t> is_near(mesh_.vertex_slots());
  for (const Face f : live_faces(mesh_))
    if (surface_.may_look_against_input(f)) found.push_back(f);
  std::vector<Vertex> corners;
  for (Face f : found)
    for (Halfedge side : sides_of(mesh_, f)) corners.push_back(mesh_.from(side));
  sort_unique(corners);
  for (Vertex v : corners)
    for (Halfedge h : outgoing(mesh_, v)) is_near[mesh_.to(h).index] = 1;
  const std::span<const Vertex> merged = find_merged();
  for (std::uint32_t i = 0; i < merged.size(); ++i)
    if (merged[i]) is_near[i] = is_near[merged[i].index];
  sides_.emplace(*input_, is_near);
  std::erase_if(found, [&](Face f) { return !may_look_further() || !is_turned(f); });
  return found;
}

// Each step but a few leaves fewer of them, perhaps others than before.
bool Simplifier::mend_turned(Progress& progress) {
  std::vector<Face> turned = find_turned();
  turned_ = turned.size();
  for (bool is_mending = true; is_mending && !turned.empty();) {
    is_mending = false;
    std::vector<Face> left;
    for (Face f : turned) {
      if (!progress.go_on()) return false;
      if (!mesh_.is_alive(f) || (may_look_further() && !is_turned(f))) continue;
      const bool is_changed = may_look_further() && mend(f, left);
      is_mending |= is_changed;
      if (!is_changed) left.push_back(f);
    }
    sort_unique(left);
    std::erase_if(left, [&](Face f) { return !mesh_.is_alive(f) || (may_look_further() && !is_turned(f)); });
    turned = std::move(left);
  }
  still_turned_ = turned.size();
  return progress.go_on();
}

// Whether something was changed; adds the faces that have.
bool Simplifier::mend(Face f, std::vector<Face>& changed) {
  constexpr std::size_t most_passed_on = 16;
  const std::array<Halfedge, 3> sides = sides_of(mesh_, f);
  const auto add_around = [&](Vertex v) {
    for (Face g : faces_around(mesh_, v))
      if (g) changed.push_back(g);
    return true;
  };
  for (Halfedge side : sides)
    if (swap_mends(side)) {
      changed.insert(changed.end(), {mesh_.face(side), mesh_.face(twin(side))});
      return true;
    }
  for (Halfedge side : sides)
    if (const Vertex v = mesh_.from(side); move_mends(v, f, false)) return add_around(v);
  for (Halfedge side : sides)
    if (const Vertex v = collapse_mends(side)) return add_around(v);
  if (passed_on_ == most_passed_on) return false;
  for (Halfedge side : sides)
    if (const Vertex v = mesh_.from(side); move_mends(v, f, true)) {
      ++passed_on_;
      return add_around(v);
    }
  return false;
}

bool Simplifier::swap_mends(Halfedge h) {
  if (!surface_.may_swap(h) || surface_.swap_spoils_face(h)) return false;
  const auto at = [&](Halfedge corner) { return mesh_.position(mesh_.from(corner)); };
  const glm::dvec3 a = at(h), b = at(twin(h)), c = at(mesh_.prev(h)), d = at(mesh_.prev(twin(h)));
  if (is_turned({c, a, d}) || is_turned({d, b, c}) || !SwapEdge{h}.is_legal(mesh_)) return false;
  if (distance_guard_) {
    if (distance_guard_->swap_may_exceed(h)) return false;
    distance_guard_->follow();
  }
  SwapEdge{h}.apply(*edit_);
  ++swaps_;
  return true;
}

std::size_t Simplifier::turned_around(Vertex v, const glm::dvec3& position, std::size_t enough) const {
  std::size_t count = 0;
  for (Halfedge corner : outgoing(mesh_, v))
    if (!mesh_.is_outside(corner) &&
        is_turned({position, mesh_.position(mesh_.to(corner)), mesh_.position(mesh_.from(mesh_.prev(corner)))}))
      if (++count == enough) break;
  return count;
}

// To where a vertex was in the input, along its edges and away from a face.
std::vector<glm::dvec3> Simplifier::ways_of(Vertex v, Face f) const {
  const glm::dvec3 here = mesh_.position(v);
  std::vector<glm::dvec3> ways{input_->position(v) - here};
  for (Halfedge h : outgoing(mesh_, v)) ways.push_back(mesh_.position(mesh_.to(h)) - here);
  const TriangleCorners t = corners_of(mesh_, mesh_.halfedge(f));
  const glm::dvec3 normal = area_normal(t), away = glm::length(t[1] - t[0]) / glm::length(normal) * normal;
  ways.insert(ways.end(), {away, -away});
  return ways;
}

// By a part of a way or a little back: of the places where fewer faces look against the input, the one of the least
// error. Or of those where another face does instead of this one, which may be easier to mend.
bool Simplifier::move_mends(Vertex v, Face f, bool may_pass_on) {
  constexpr std::array shares{0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 0.9, -0.05, -0.1, -0.25, -0.5};
  if (!surface_.is_free(v) || is_hub(v) || (surface_.keeps_boundaries() && mesh_.is_boundary(v))) return false;
  const std::vector<glm::dvec3> ways = may_pass_on ? all_around(corners_of(mesh_, mesh_.halfedge(f))) : ways_of(v, f);
  const glm::dvec3 here = mesh_.position(v);
  const std::array<Halfedge, 3> sides = sides_of(mesh_, f);
  const auto turns_this = [&](const glm::dvec3& position) {
    TriangleCorners t = corners_of(mesh_, sides[0]);
    for (std::size_t i = 0; i < 3; ++i)
      if (mesh_.from(sides[i]) == v) t[i] = position;
    return is_turned(t);
  };
  const std::size_t most = turned_around(v, here) - (may_pass_on ? 0 : 1);
  double least = surface_.error_limit();
  std::optional<glm::dvec3> best;
  for (const glm::dvec3& way : ways)
    for (const double share : shares) {
      if (!may_look_further()) return false;
      const glm::dvec3 position = here + share * way;
      const double error = surface_.error_of_move(v, position);
      if (!(error <= least) || surface_.move_spoils_face(v, position, f) || (may_pass_on && turns_this(position)) ||
          turned_around(v, position, most + 1) > most ||
          (distance_guard_ && distance_guard_->move_may_exceed(v, position)))
        continue;
      least = error;
      best = position;
    }
  if (!best) return false;
  if (distance_guard_) {
    if (distance_guard_->move_may_exceed(v, *best)) return false;  // proves it again, after others
    distance_guard_->follow();
  }
  if (has_vertex_values_) RingValues(surface_, v, surface_.scale().scaled(*best)).write_vertex(*edit_, v);
  edit_->set_position(v, *best);
  surface_.move(v, *best);
  error_max_ = std::max(error_max_, least);
  return true;
}

bool Simplifier::turns_fewer(Halfedge h, const Placing& placing) const {
  const glm::dvec3 position = surface_.position_of(placing);
  const Vertex a = mesh_.from(h), b = mesh_.to(h);
  std::size_t before = 0, after = 0;
  for (Halfedge end : {h, twin(h)})
    for (Halfedge corner : outgoing(mesh_, mesh_.from(end))) {
      const Face g = mesh_.face(corner);
      if (!g) continue;
      const Vertex x = mesh_.to(corner), y = mesh_.from(mesh_.prev(corner));
      const bool goes = x == a || x == b || y == a || y == b;
      if (goes && end != h) continue;  // counted at the other end
      before += is_turned(g);
      if (!goes) after += is_turned({position, mesh_.position(x), mesh_.position(y)});
    }
  return after < before;
}

// Wherever in the order that stands; it goes beyond the goal by a face or two, a hundredth of it in all.
Vertex Simplifier::collapse_mends(Halfedge side) {
  const Freedom freedom = surface_.freedom(side);
  if (!freedom.is_possible || mesh_.live().faces + goal_.faces / 100 < goal_.faces + 2) return {};
  const Halfedge h = freedom.halfedge;
  if (is_hub(mesh_.from(h)) || is_hub(mesh_.to(h))) return {};
  const Legality legality = this->legality(h);
  if (legality == Legality::none) return {};
  std::vector<Placing> places{surface_.lowest(freedom)};
  if (!freedom.is_anchored)
    for (const Placing& other : surface_.others(freedom)) places.push_back(other);
  for (const Placing& placing : places)
    if (refusal(freedom, placing, EdgeRule::free) == EdgeRule::free && turns_fewer(h, placing)) {
      const Vertex a = mesh_.from(h), b = mesh_.to(h);
      collapse(freedom, placing, legality);
      return mesh_.is_alive(b) ? b : a;
    }
  return {};
}

}  // namespace ryosen
