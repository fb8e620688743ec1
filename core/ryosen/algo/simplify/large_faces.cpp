// The areas of faces of many corners while edges collapse: kept, since summing them anew for each of their edges would
// cost the square of their corners.
#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

void CollapseSurface::find_large_faces() {
  constexpr std::size_t least_corners = 32;
  for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
    const Face f(i);
    if (!mesh_.is_alive(f) || is_triangle(mesh_, mesh_.halfedge(f))) continue;
    const std::size_t corners = corner_count(mesh_, f);
    if (corners >= least_corners)
      large_faces_.emplace(f, LargeFace{summed_area_vector(f, Vertex(), Vertex(), {}), corners});
  }
}

glm::dvec3 CollapseSurface::area_vector(Face f) const {
  if (!large_faces_.empty())
    if (const auto found = large_faces_.find(f); found != large_faces_.end()) return found->second.area_vector;
  return summed_area_vector(f, Vertex(), Vertex(), {});
}

// Of a large face only the sides at the corners that move are summed, as they were and as they come to be.
glm::dvec3 CollapseSurface::area_vector(Face f, Vertex a, Vertex b, const glm::dvec3& place) const {
  const auto found = large_faces_.empty() ? large_faces_.end() : large_faces_.find(f);
  if (found == large_faces_.end()) {
    looked_at_ += corner_count(mesh_, f);
    return summed_area_vector(f, a, b, place);
  }
  const glm::dvec3 origin = states_[a.index].place;
  const auto before = [&](Vertex v) { return states_[v.index].place - origin; };
  const auto after = [&](Vertex v) { return (v == a || v == b ? place : states_[v.index].place) - origin; };
  glm::dvec3 sum = found->second.area_vector;
  const auto add_side = [&](Halfedge h) {
    const Vertex u = mesh_.from(h), v = mesh_.to(h);
    sum += glm::cross(after(u), after(v)) - glm::cross(before(u), before(v));
  };
  for (Vertex end : {a, b})
    for (Halfedge h : outgoing(mesh_, end)) {
      ++looked_at_;
      if (mesh_.face(h) != f) continue;
      add_side(h);
      if (const Vertex u = mesh_.from(mesh_.prev(h)); u != a && u != b) add_side(mesh_.prev(h));
    }
  return sum;
}

void CollapseSurface::follow_large_faces(Halfedge h, const Placing& placing) {
  if (large_faces_.empty()) return;
  const glm::dvec3 place = scale_.scaled(position_of(placing));
  const Vertex a = mesh_.from(h), b = mesh_.to(h);
  std::vector<Face> faces;
  for (Vertex end : {a, b})
    for (Halfedge corner : outgoing(mesh_, end))
      if (const Face f = mesh_.face(corner); f && large_faces_.contains(f)) faces.push_back(f);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  for (Face f : faces) {
    LargeFace& large = large_faces_.at(f);
    // Summed anew from time to time, so that rounding does not add up.
    const bool is_worn = ++large.changes > large.corners;
    large.area_vector = is_worn ? summed_area_vector(f, a, b, place) : area_vector(f, a, b, place);
    if (!is_worn) continue;
    looked_at_ += large.corners;
    large.changes = 0;
  }
}

}  // namespace ryosen
