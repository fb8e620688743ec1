#include "ryosen/algo/crossings/near_faces.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

Primitive primitive_of(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  for (Vertex v : vertices_around(mesh, f))
    if (!is_finite(mesh.position(v))) return {};
  return Primitive::triangle(mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index, f.index);
}

}  // namespace

NearFaces::NearFaces(const Mesh& mesh) : mesh_(mesh), spots_(mesh.face_slots()) {
  std::vector<Primitive> primitives(mesh.face_slots());
  for (const Face f : live_faces(mesh)) primitives[f.index] = primitive_of(mesh, f);
  std::vector<Vertex> hubs;
  for (const Vertex v : live_vertices(mesh))
    if (point(mesh, v) == v && is_hub_point(mesh, v)) hubs.push_back(v);
  for (Vertex v : hubs) for_each_face_at(mesh, v, [&](Face f) { primitives[f.index] = {}; });
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
  const Frustum inside = frustum_of_box(around);
  auto add = [&](std::uint32_t slot) { found.emplace_back(slot); };
  auto add_face = [&](Face f) { found.push_back(f); };
  if (around_groups_.is_worn()) around_groups_.rebuild(ends_);
  if (!each) tree_.visit_box(mesh_.positions(), around, add);
  for (std::size_t i = 0; each && i < triangles.size(); ++i)
    tree_.visit_frustum(mesh_.positions(), directions::slab_of(triangles[i].places), add);
  around_groups_.visit_frustum(ends_, inside, [&](std::uint32_t slot) {
    Group& group = groups_[slot];
    if (!each) return group.faces.for_each(add_face);
    std::array<std::uint32_t, 2> numbers{none, none};
    for (std::size_t i = 0; i < 2; ++i)
      if (group.hubs[i] != none) numbers[i] = hubs_[group.hubs[i]].point;
    for (const NumberedTriangle& t : triangles) group.faces.find(t, numbers, add_face);
  });
  if (!each) return;
  std::sort(found.begin() + first, found.end());
  found.erase(std::unique(found.begin() + first, found.end()), found.end());
}

// Of a point whose first copy is another one by now nothing is known: its faces are found by their boxes.
std::uint32_t NearFaces::hub_of(Vertex v) const {
  if (hubs_.empty()) return none;
  const Vertex first = point(mesh_, v);
  return first.index < hub_of_.size() ? hub_of_[first.index] : none;
}

void NearFaces::follow(Vertex v, bool has_only_moved) {
  if (const std::uint32_t hub = hub_of(v); hub != none) {
    if (hubs_[hub].place != mesh_.position(v)) move_hub(hub, mesh_.position(v));
  } else if (!has_only_moved && !mesh_.is_isolated(v) && is_hub_point(mesh_, v)) {
    return make_hub(v);
  }
  for (Face f : faces_around(mesh_, v))
    if (f) put(f, has_only_moved);
}

void NearFaces::forget(Face f) {
  if (f.index >= spots_.size()) return;
  const Spot spot = std::exchange(spots_[f.index], {});
  if (spot.group == none) return tree_.erase(f.index);
  FacesAtHubs& faces = groups_[spot.group].faces;
  faces.erase(spot.slot);
  if (faces.size() == 0) around_groups_.erase(spot.group);
}

void NearFaces::make_hub(Vertex v) {
  const std::uint32_t number = point(mesh_, v).index;
  hub_of_.resize(std::max<std::size_t>(hub_of_.size(), mesh_.vertex_slots()), none);
  hub_of_[number] = static_cast<std::uint32_t>(hubs_.size());
  hubs_.push_back({number, mesh_.position(v)});
  for_each_face_at(mesh_, v, [&](Face f) { put(f); });
}

// What it holds is put anew, also where that is at another vertex by now.
void NearFaces::move_hub(std::uint32_t hub, const glm::dvec3& place) {
  hubs_[hub].place = place;
  std::vector<Face> held;
  for (const std::uint32_t group : hubs_[hub].groups) {
    groups_[group].faces.for_each([&](Face f) { held.push_back(f); });
    groups_[group].faces = FacesAtHubs(places_of(groups_[group].hubs));
    around_groups_.erase(group);
  }
  for (Face f : held) spots_[f.index] = {};
  for (Face f : held)
    if (mesh_.is_alive(f)) put(f);
}

std::vector<glm::dvec3> NearFaces::places_of(const std::array<std::uint32_t, 2>& hubs) const {
  std::vector<glm::dvec3> places;
  for (const std::uint32_t hub : hubs)
    if (hub != none) places.push_back(hubs_[hub].place);
  return places;
}

NearFaces::Home NearFaces::home_of(Face f) const {
  Home home{.corners = corners_of(mesh_, mesh_.halfedge(f))};
  if (hubs_.empty()) return home;
  TriangleCorners& c = home.corners;
  for (const std::size_t i : {0u, 1u, 2u})
    if (!directions::is_somewhere(directions::direction(c[i], c[(i + 1) % 3]))) return home;
  std::array<std::pair<std::uint32_t, glm::dvec3>, 3> corners;
  std::size_t i = 0;
  for (const Halfedge h : halfedges_around(mesh_, f)) {
    const std::uint32_t hub = hub_of(mesh_.from(h));
    corners[i] = {hub != none && hubs_[hub].place == c[i] ? hub : none, c[i]};
    ++i;
  }
  std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  home.hubs = {corners[0].first, corners[1].first};
  for (i = 0; i < 3; ++i) c[i] = corners[i].second;
  return home;
}

std::uint32_t NearFaces::group_of(const std::array<std::uint32_t, 2>& hubs) {
  const std::uint64_t key = std::uint64_t{hubs[0]} << 32u | hubs[1];
  const auto [at, is_new] = group_at_.try_emplace(key, static_cast<std::uint32_t>(groups_.size()));
  if (!is_new) return at->second;
  groups_.push_back({hubs, FacesAtHubs(places_of(hubs))});
  ends_.resize(2 * groups_.size());
  for (const std::uint32_t hub : hubs)
    if (hub != none) hubs_[hub].groups.push_back(at->second);
  return at->second;
}

void NearFaces::put(Face f, bool has_only_moved) {
  spots_.resize(std::max<std::size_t>(spots_.size(), mesh_.face_slots()));
  const Home home = home_of(f);
  const std::uint32_t group = home.hubs[0] == none ? none : group_of(home.hubs);
  if (spots_[f.index].group != group) forget(f);
  if (group != none)
    put(f, group, home.corners);
  else if (has_only_moved && tree_.primitive(f.index).size() > 0)
    tree_.update(mesh_.positions(), f.index);
  else
    tree_.insert(mesh_.positions(), f.index, primitive_of(mesh_, f));
}

void NearFaces::put(Face f, std::uint32_t group, const TriangleCorners& corners) {
  FacesAtHubs& faces = groups_[group].faces;
  Spot& spot = spots_[f.index];
  if (spot.group == none)
    spot = {group, faces.add(f, corners)};
  else
    faces.change(spot.slot, corners);
  const Box& all = faces.reach();
  const bool is_known = around_groups_.primitive(group).size() > 0;
  if (is_known && all.lowest == ends_[2 * group] && all.highest == ends_[2 * group + 1]) return;
  ends_[2 * group] = all.lowest;
  ends_[2 * group + 1] = all.highest;
  around_groups_.insert(ends_, group, Primitive::segment(2 * group, 2 * group + 1, group));
}

}  // namespace ryosen
