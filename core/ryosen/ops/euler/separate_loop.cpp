#include "ryosen/ops/euler/separate_loop.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "ryosen/geometry/locate.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/rules/face_corners.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/shares.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

constinit const OpInfo SeparateLoop::info{.id = "separate_loop",
                                          .name_en = "Divide face",
                                          .name_ja = "ループ分割",
                                          .line = {.lists = {face_corner_parameters},
                                                   .read_rest = read_corners_of<SeparateLoop>,
                                                   .print_rest = print_corners_of<SeparateLoop>},
                                          .help_en = "divides a face by an edge from corner A to corner B",
                                          .help_ja = "面を角 A と角 B を結ぶ稜線で分割する",
                                          .target = OpTargetKind::selection,
                                          .group = OpGroup::euler,
                                          .aliases = "divide mef",
                                          .topology = Topology::kept,
                                          .on_selection = OnSelection::all};

namespace {

// The corners to the left of an edge from the corner after `into_a` to the one after `into_b`: from b to a.
std::vector<Halfedge> left_part(const Mesh& mesh, Halfedge into_a, Halfedge into_b) {
  std::vector<Halfedge> part;
  for (Halfedge h = mesh.next(into_b); h != mesh.next(into_a); h = mesh.next(h)) part.push_back(h);
  part.push_back(mesh.next(into_a));
  return part;
}

std::vector<glm::dvec3> places_of(const Mesh& mesh, const std::vector<Halfedge>& corners) {
  std::vector<glm::dvec3> places;
  for (Halfedge h : corners) places.push_back(mesh.position(mesh.from(h)));
  return places;
}

// How the face is divided: the corners of the new face, those that remain, and the rings that move to the new face.
struct Parts {
  bool left_is_new = true;
  std::vector<Halfedge> fresh, kept;
  std::vector<std::uint32_t> rings;
};

Place locate_ring(const Mesh& mesh, Halfedge start, const std::vector<glm::dvec3>& polygon, int axis) {
  for (Halfedge h : loop(mesh, start))
    if (const Place place = locate(mesh.position(mesh.from(h)), polygon, axis); place != Place::on) return place;
  return Place::on;
}

Parts divide(const Mesh& mesh, Halfedge into_a, Halfedge into_b) {
  Parts parts;
  const Face f = mesh.face(into_a);
  parts.fresh = left_part(mesh, into_a, into_b);
  parts.kept = left_part(mesh, into_b, into_a);
  if (!mesh.has_rings(f)) return parts;
  const glm::dvec3 normal = polygon_normal(FacePolygon(mesh, f).keyhole_walk());
  const std::uint32_t own = ring_of(mesh, into_a);
  // When a ring is divided, only one part is bounded by itself; the other also has the outer loop.
  if (own != no_index && projected_area(places_of(mesh, parts.fresh), normal) <= 0 &&
      projected_area(places_of(mesh, parts.kept), normal) > 0) {
    parts.left_is_new = false;
    std::swap(parts.fresh, parts.kept);
  }
  const std::vector<glm::dvec3> polygon = places_of(mesh, parts.fresh);
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next)
    if (r != own && locate_ring(mesh, mesh.ring(r).halfedge, polygon, view_axis(normal)) == Place::inside)
      parts.rings.push_back(r);
  return parts;
}

std::vector<std::uint32_t> points_of(const Mesh& mesh, const std::vector<Halfedge>& corners) {
  std::vector<std::uint32_t> points;
  for (Halfedge h : corners) points.push_back(point(mesh, mesh.from(h)).index);
  return points;
}

// The corner lists of the old face and of the new one.
std::pair<CornerLoops, CornerLoops> lists_after(const Mesh& mesh, Face f, std::uint32_t own, const Parts& parts) {
  CornerLoops kept, fresh;
  kept.add(points_of(mesh, parts.kept));
  fresh.add(points_of(mesh, parts.fresh));
  if (own != no_index) kept.add(points_along(mesh, mesh.halfedge(f)));
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next) {
    if (r == own) continue;
    const bool goes = std::find(parts.rings.begin(), parts.rings.end(), r) != parts.rings.end();
    (goes ? fresh : kept).add(points_along(mesh, mesh.ring(r).halfedge));
  }
  return {std::move(kept), std::move(fresh)};
}

}  // namespace

Verdict SeparateLoop::check(const Mesh& mesh) const {
  Verdict verdict;
  if (!are_corners_of_one_face(mesh, {into_a, into_b}, verdict)) return verdict;
  const Face f = mesh.face(into_a);
  const std::uint32_t own = ring_of(mesh, into_a);
  if (own != ring_of(mesh, into_b)) return refused_by(Rule::different_loops, {f, mesh.to(into_a), mesh.to(into_b)});
  const std::vector<Halfedge> existing = sheets_between(mesh, mesh.to(into_a), mesh.to(into_b));
  if (!existing.empty()) return refused_by(Rule::edge_exists, {edge(existing.front())});
  const auto [kept, fresh] = lists_after(mesh, f, own, divide(mesh, into_a, into_b));
  if (!take_out_bridges(kept) || !take_out_bridges(fresh)) return refused_by(Rule::loop, {f});
  if (const Face other = equal_face(mesh, f)) verdict.refuse(Rule::loses_duplicate, {f, other});
  const Face except[] = {f};
  for (const CornerLoops* list : {&kept, &fresh})
    if (const Face other = face_on(mesh, point_set(list->corners), except))
      verdict.refuse(Rule::duplicate_face, {std::min(f, other), std::max(f, other)});
  return verdict;
}

std::vector<Reason> SeparateLoop::warnings(const Mesh& mesh) const {
  const FaceGeometry before(FacePolygon(mesh, mesh.face(into_a)).keyhole_walk());
  const Parts parts = divide(mesh, into_a, into_b);
  if (before.is_degenerate()) return {};
  for (const auto* part : {&parts.fresh, &parts.kept}) {
    const FaceGeometry after(places_of(mesh, *part));
    if (after.is_degenerate()) return {{Rule::degenerate, {mesh.face(into_a)}}};
    // A ring runs the other way round, but the face that is divided from it does not.
    if ((part == &parts.fresh || ring_of(mesh, into_a) == no_index) && before.turns_against(after))
      return {{Rule::normal_turns, {mesh.face(into_a)}}};
  }
  return {};
}

OpEffect SeparateLoop::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  const Face f = m.face(into_a);
  const Parts parts = divide(m, into_a, into_b);
  const std::uint32_t own = ring_of(m, into_a);
  const Halfedge start = own == no_index ? m.halfedge(f) : m.ring(own).halfedge;
  const Halfedge h = link_inside(edit, into_a, into_b);
  const Halfedge of_fresh = parts.left_is_new ? h : twin(h);
  const Face fresh = edit.add_face(m.next(of_fresh));
  set_face_along(edit, of_fresh, fresh);
  if (m.face(start) == fresh) {
    // The loop keeps its stored start if that corner stays; else it starts at the new edge.
    if (own == no_index)
      edit.set_halfedge(f, twin(of_fresh));
    else
      edit.set_ring_halfedge(own, twin(of_fresh));
  }
  for (std::uint32_t r : parts.rings) {
    const Halfedge ring_start = m.ring(r).halfedge;
    edit.remove_ring(f, r);
    edit.add_ring(fresh, ring_start);
    set_face_along(edit, ring_start, fresh);
  }
  const Face halves[] = {f, fresh};
  edit.divide<Face>(f, halves, [&] { return areas_of(m, halves); });
  return {.created = {edge(h), fresh}, .changed = {f, fresh}};
}

}  // namespace ryosen
