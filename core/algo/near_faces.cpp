#include "core/algo/near_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/hubs.h"
#include "core/view/frustum.h"

namespace ryosen {

namespace {

// More than the rounding of a plane through two directions and of its distance from a third one.
constexpr double plane_rounding = 1e-13;

Primitive primitive_of(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  for (Vertex v : vertices_around(mesh, f))
    if (!is_finite(mesh.position(v))) return {};
  return Primitive::triangle(mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index, f.index);
}

// Of length 1 in its largest coordinate; of length 0 where it is the same place, and not finite where that is so far.
glm::dvec3 direction(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 way = to - from, size = glm::abs(way);
  const double largest = std::max({size.x, size.y, size.z});
  return largest > 0 ? way / largest : glm::dvec3(0);
}

bool is_somewhere(const glm::dvec3& direction) { return is_finite(direction) && direction != glm::dvec3(0); }

// What lies between two directions, and beside that by so much.
void add_sector(Frustum& cone, const glm::dvec3& a, const glm::dvec3& b, double beside) {
  const glm::dvec3 normal = glm::cross(a, b);
  for (const glm::dvec3& inwards : {normal, -normal, glm::cross(normal, a), glm::cross(b, normal)})
    cone.add(glm::dvec4(inwards, beside + plane_rounding));
}

// A triangle as thick as rounding; its box where it is too large or small for that.
Frustum slab_of(const TriangleCorners& t) {
  Frustum slab = frustum_of_box(box_of(t));
  const std::array<glm::dvec3, 3> sides{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  const glm::dvec3 normal = glm::cross(sides[0], sides[1]);
  const double longest = std::max({glm::length(sides[0]), glm::length(sides[1]), glm::length(sides[2])});
  if (!(longest > 1e-75 && longest < 1e75)) return slab;
  const auto add = [&](const glm::dvec3& inwards, const glm::dvec3& through, double size) {
    const double slack = plane_rounding * size * (glm::length(through) + longest);
    slab.add(glm::dvec4(inwards, slack - glm::dot(inwards, through)));
  };
  for (const double side : {1.0, -1.0}) add(side * normal, t[0], longest * longest);
  for (std::size_t i = 0; i < 3; ++i) add(glm::cross(normal, sides[i]), t[i], longest * longest * longest);
  return slab;
}

// The directions from a point in which a triangle lies; perhaps some more, all of them where that cannot be told, and
// where another point of the triangle lies at its place.
Frustum cone_of(const NumberedTriangle& triangle, std::uint32_t point, const glm::dvec3& from) {
  Frustum cone;
  std::array<glm::dvec3, 3> d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = direction(from, triangle.places[i]);
  if (!is_finite(d[0]) || !is_finite(d[1]) || !is_finite(d[2])) return cone;
  for (std::size_t i = 0; i < 3; ++i)
    if (d[i] == glm::dvec3(0)) {
      if (triangle.numbers[i] != point) return cone;
      const glm::dvec3 &a = d[(i + 1) % 3], &b = d[(i + 2) % 3];
      if (is_somewhere(a) && is_somewhere(b)) add_sector(cone, a, b, 0);
      return cone;
    }
  constexpr double flat = 1e-12;
  const double det = glm::dot(glm::cross(d[0], d[1]), d[2]);
  if (std::abs(det) > flat) {
    for (std::size_t i = 0; i < 3; ++i)
      cone.add(glm::dvec4((det > 0 ? 1.0 : -1.0) * glm::cross(d[i], d[(i + 1) % 3]), plane_rounding));
    return cone;
  }
  // Seen from within its plane: between two corners, the third one among them, unless the place is inside.
  std::size_t widest = 3;
  double width = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = d[i], &b = d[(i + 1) % 3], &c = d[(i + 2) % 3], normal = glm::cross(a, b);
    const bool holds_third = glm::dot(glm::cross(normal, a), c) >= -flat && glm::dot(glm::cross(b, normal), c) >= -flat;
    if (!holds_third || !(glm::dot(normal, normal) > width)) continue;
    width = glm::dot(normal, normal);
    widest = i;
  }
  if (widest < 3) add_sector(cone, d[widest], d[(widest + 1) % 3], flat);
  return cone;
}

}  // namespace

NearFaces::NearFaces(const Mesh& mesh) : mesh_(mesh), spots_(mesh.face_slots()) {
  std::vector<Primitive> primitives(mesh.face_slots());
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
    if (const Face f(i); mesh.is_alive(f)) primitives[i] = primitive_of(mesh, f);
  std::vector<Vertex> hubs;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (const Vertex v(i); mesh.is_alive(v) && !mesh.is_isolated(v) && is_hub(mesh, v)) hubs.push_back(v);
  for (Vertex v : hubs)
    for (Face f : faces_around(mesh, v))
      if (f) primitives[f.index] = {};
  tree_.build(mesh.positions(), std::move(primitives));
  for (Vertex v : hubs) follow(v);
}

// Beside hubs triangles are long and thin, and less lies in them than in their boxes.
void NearFaces::find(std::span<const NumberedTriangle> triangles, std::vector<Face>& found) {
  if (tree_.is_worn()) tree_.rebuild(mesh_.positions());
  constexpr std::size_t few = 64;
  const bool each = !hubs_.empty() && triangles.size() <= few;
  Box around;
  for (const NumberedTriangle& t : triangles) around.add(box_of(t.places));
  if (around.is_empty()) return;
  const auto first = static_cast<std::ptrdiff_t>(found.size());
  const Frustum inside = frustum_of_box(around), everywhere;
  auto add = [&](std::uint32_t slot) { found.emplace_back(slot); };
  if (around_hubs_.is_worn()) around_hubs_.rebuild(ends_);
  if (!each) tree_.visit_frustum(mesh_.positions(), inside, add);
  for (std::size_t i = 0; each && i < triangles.size(); ++i)
    tree_.visit_frustum(mesh_.positions(), slab_of(triangles[i].places), add);
  around_hubs_.visit_frustum(ends_, inside, [&](std::uint32_t slot) {
    Hub& hub = hubs_[slot];
    if (hub.tree.is_worn()) hub.tree.rebuild(hub.directions);
    const std::uint32_t own = mesh_.is_alive(hub.vertex) ? point(mesh_, hub.vertex).index : no_index;
    auto add_held = [&](std::uint32_t held) { found.emplace_back(hub.tree.primitive(held).owner); };
    if (!each) hub.tree.visit_frustum(hub.directions, everywhere, add_held);
    for (std::size_t i = 0; each && i < triangles.size(); ++i)
      hub.tree.visit_frustum(hub.directions, cone_of(triangles[i], own, hub.place), add_held);
  });
  if (!each) return;
  std::sort(found.begin() + first, found.end());
  found.erase(std::unique(found.begin() + first, found.end()), found.end());
}

void NearFaces::follow(Vertex v, bool has_only_moved) {
  if (const std::uint32_t hub = hub_of(v); hub != no_hub) {
    if (hubs_[hub].place != mesh_.position(v)) move_hub(hub, mesh_.position(v));
  } else if (!has_only_moved && !mesh_.is_isolated(v) && is_hub(mesh_, v)) {
    make_hub(v);
  }
  for (Face f : faces_around(mesh_, v))
    if (f) put(f, has_only_moved);
}

void NearFaces::forget(Face f) {
  if (f.index >= spots_.size()) return;
  const Spot spot = std::exchange(spots_[f.index], {});
  if (spot.hub == no_hub) return tree_.erase(f.index);
  Hub& hub = hubs_[spot.hub];
  hub.tree.erase(spot.slot);
  hub.free_slots.push_back(spot.slot);
  if (hub.tree.size() == 0) around_hubs_.erase(spot.hub);
}

void NearFaces::make_hub(Vertex v) {
  hub_of_.resize(std::max<std::size_t>(hub_of_.size(), mesh_.vertex_slots()), no_hub);
  hub_of_[v.index] = static_cast<std::uint32_t>(hubs_.size());
  hubs_.push_back({v, mesh_.position(v)});
  ends_.resize(2 * hubs_.size());
}

// What it holds is put anew, also where that is at another vertex by now.
void NearFaces::move_hub(std::uint32_t hub, const glm::dvec3& place) {
  std::vector<Face> held;
  const Frustum everywhere;
  hubs_[hub].tree.visit_frustum(hubs_[hub].directions, everywhere,
                                [&](std::uint32_t slot) { held.emplace_back(hubs_[hub].tree.primitive(slot).owner); });
  for (Face f : held) spots_[f.index] = {};
  hubs_[hub] = {hubs_[hub].vertex, place};
  around_hubs_.erase(hub);
  for (Face f : held)
    if (mesh_.is_alive(f)) put(f);
}

std::uint32_t NearFaces::hub_of(Face f, Halfedge& corner) const {
  if (hubs_.empty()) return no_hub;
  for (Halfedge h : halfedges_around(mesh_, f)) {
    const std::uint32_t hub = hub_of(mesh_.from(h));
    if (hub == no_hub || hubs_[hub].place != mesh_.position(mesh_.from(h))) continue;
    const auto is_apart = [&](Vertex v) { return is_somewhere(direction(hubs_[hub].place, mesh_.position(v))); };
    if (!is_apart(mesh_.to(h)) || !is_apart(mesh_.from(mesh_.prev(h)))) continue;
    corner = h;
    return hub;
  }
  return no_hub;
}

void NearFaces::put(Face f, bool has_only_moved) {
  spots_.resize(std::max<std::size_t>(spots_.size(), mesh_.face_slots()));
  Halfedge corner;
  const std::uint32_t hub = hub_of(f, corner);
  if (spots_[f.index].hub != hub) forget(f);
  if (hub != no_hub)
    put(f, hub, corner);
  else if (has_only_moved && tree_.primitive(f.index).size() > 0)
    tree_.update(mesh_.positions(), f.index);
  else
    tree_.insert(mesh_.positions(), f.index, primitive_of(mesh_, f));
}

void NearFaces::put(Face f, std::uint32_t at, Halfedge corner) {
  Hub& hub = hubs_[at];
  Spot& spot = spots_[f.index];
  if (spot.hub == no_hub) {
    spot = {at, static_cast<std::uint32_t>(hub.directions.size() / 2)};
    if (hub.free_slots.empty()) {
      hub.directions.resize(hub.directions.size() + 2);
    } else {
      spot.slot = hub.free_slots.back();
      hub.free_slots.pop_back();
    }
  }
  const TriangleCorners corners = corners_of(mesh_, corner);
  for (std::uint32_t i : {0u, 1u}) hub.directions[2 * spot.slot + i] = direction(hub.place, corners[i + 1]);
  hub.tree.insert(hub.directions, spot.slot, Primitive::segment(2 * spot.slot, 2 * spot.slot + 1, f.index));
  enlarge(at, corners);
}

void NearFaces::enlarge(std::uint32_t hub, const TriangleCorners& corners) {
  Box all = box_of(corners);
  const bool is_known = around_hubs_.primitive(hub).size() > 0;
  if (is_known) all.add(Box{ends_[2 * hub], ends_[2 * hub + 1]});
  if (is_known && all.lowest == ends_[2 * hub] && all.highest == ends_[2 * hub + 1]) return;
  ends_[2 * hub] = all.lowest;
  ends_[2 * hub + 1] = all.highest;
  around_hubs_.insert(ends_, hub, Primitive::segment(2 * hub, 2 * hub + 1, hub));
}

}  // namespace ryosen
