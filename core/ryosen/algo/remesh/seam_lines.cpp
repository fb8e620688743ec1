#include "ryosen/algo/remesh/seam_lines.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen::remesh {

namespace {

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 way = b - a;
  const double square = glm::dot(way, way);
  const double along = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
  return glm::distance(p, a + along * way);
}

}  // namespace

// The values of each attribute must tell the two sides apart at the start where they do at the end, and both ends of a
// side must have one or none.
bool SeamLines::values_allow(Halfedge h) const {
  const Halfedge o = twin(h);
  for (const CornerAttribute& attribute : corner_attributes(mesh_)) {
    const std::vector<std::uint32_t>& index = mesh_.attributes()[attribute.index_column].data;
    const std::uint32_t left = index[h.index], left_end = index[mesh_.next(h).index],
                        right = index[mesh_.next(o).index], right_end = index[o.index];
    if ((left == no_index) != (left_end == no_index) || (right == no_index) != (right_end == no_index)) return false;
    if (left == right && left_end != right_end) return false;
  }
  return true;
}

// The other weighed halfedge that leaves the start of h.
Halfedge SeamLines::other_weighed(Halfedge h) const {
  for (const Halfedge around : outgoing(mesh_, mesh_.from(h)))
    if (around != h && features_.is_weighed(edge(around))) return around;
  return {};
}

bool SeamLines::stays_near(std::span<const glm::dvec3> places, const glm::dvec3& a, const glm::dvec3& b,
                           double reach) const {
  return std::all_of(places.begin(), places.end(),
                     [&](const glm::dvec3& p) { return distance_to_segment(p, a, b) <= reach; });
}

bool SeamLines::allows_collapse(Halfedge h, double reach) {
  if (!features_.is_weighed(edge(h)) || !features_.is_weighed(mesh_.from(h)) || !values_allow(h)) return false;
  const Halfedge other = other_weighed(h);
  if (!other) return false;
  gone_ = edge(h);
  longer_ = beside_ = edge(other);
  for (const Halfedge side : {h, twin(h)}) {
    const Edge one = edge(mesh_.prev(side)), two = edge(mesh_.next(side));
    if (features_.edges[one.index] && features_.edges[two.index]) return false;
    if (one == longer_) beside_ = two;
    if (two == longer_) beside_ = one;
  }
  places_.assign(1, mesh_.position(mesh_.from(h)));
  for (const Edge e : {gone_, longer_})
    if (const auto found = left_.find(e); found != left_.end())
      places_.insert(places_.end(), found->second.begin(), found->second.end());
  return stays_near(places_, mesh_.position(mesh_.to(other)), mesh_.position(mesh_.to(h)), reach);
}

// Between seams values are equal, though perhaps twice in the pool.
void SeamLines::share_values(Halfedge h) {
  const Halfedge other = other_weighed(h);
  for (const CornerAttribute& attribute : corner_attributes(mesh_)) {
    const std::vector<std::uint32_t>& index = mesh_.attributes()[attribute.index_column].data;
    const auto share = [&](Halfedge first, Halfedge with) {
      const std::uint32_t value = index[with.index];
      Halfedge corner = first;
      do {
        edit_.set_attribute(attribute.index_column, corner.index, std::span(&value, 1));
        corner = mesh_.counter_clockwise(corner);
      } while (!features_.edges[edge(corner).index]);
    };
    share(h, h);
    share(other, mesh_.next(twin(h)));
  }
}

void SeamLines::collapsed() {
  left_.erase(gone_);
  left_.erase(longer_);
  left_[mesh_.is_alive(longer_) ? longer_ : beside_] = std::move(places_);
}

void SeamLines::split(Edge e, Vertex middle) {
  const auto found = left_.find(e);
  if (found == left_.end()) return;
  const Places places = std::move(found->second);
  left_.erase(found);
  std::vector<Halfedge> halves;
  for (const Halfedge h : outgoing(mesh_, middle))
    if (features_.is_weighed(edge(h))) halves.push_back(h);
  for (const glm::dvec3& place : places) {
    const auto distance = [&](Halfedge h) {
      return distance_to_segment(place, mesh_.position(middle), mesh_.position(mesh_.to(h)));
    };
    const auto nearest = std::min_element(halves.begin(), halves.end(),
                                          [&](Halfedge a, Halfedge b) { return distance(a) < distance(b); });
    if (nearest != halves.end()) left_[edge(*nearest)].push_back(place);
  }
}

}  // namespace ryosen::remesh
