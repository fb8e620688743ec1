#include "ryosen/algo/remesh/covered_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/geometry/closest.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::remesh {

CoveredPoints::CoveredPoints(const Mesh& mesh, const Features& features, double spacing) {
  first_.assign(mesh.face_slots(), no_index);
  FaceNormals area_normals(mesh.face_slots(), glm::dvec3(0));
  for (const Face f : live_faces(mesh)) area_normals[f.index] = area_normal(corners_of(mesh, mesh.halfedge(f)));
  points_.reserve(2 * mesh.live().vertices);
  for (const Vertex v : live_vertices(mesh))
    if (!features.vertices[v.index] || features.is_weighed(v)) add_vertex(mesh, area_normals, v);
  for (const Edge e : live_edges(mesh))
    if (!features.edges[e.index] || features.is_weighed(e)) add_edge(mesh, area_normals, e, spacing);
}

void CoveredPoints::add_vertex(const Mesh& mesh, const FaceNormals& area_normals, Vertex v) {
  glm::dvec3 sum(0);
  double size = 0, most = -2;
  Face best;
  for (const Halfedge h : outgoing(mesh, v)) {
    const glm::dvec3& area = area_normals[mesh.face(h).index];
    sum += area;
    size += glm::length(area);
  }
  const glm::dvec3 normal = glm::length(sum) > 0.3 * size ? unit_or_zero(sum) : glm::dvec3(0);
  for (const Halfedge h : outgoing(mesh, v)) {
    const glm::dvec3& area = area_normals[mesh.face(h).index];
    if (const double cosine = glm::dot(unit_or_zero(area), normal); cosine > most) {
      most = cosine;
      best = mesh.face(h);
    }
  }
  points_.push_back({mesh.position(v), most > least_facing ? normal : glm::dvec3(0), 0, no_index});
  give(static_cast<std::uint32_t>(points_.size() - 1), best);
}

void CoveredPoints::add_edge(const Mesh& mesh, const FaceNormals& area_normals, Edge e, double spacing) {
  const Halfedge h = halfedge(e);
  const glm::dvec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
  const auto parts = static_cast<std::uint32_t>(std::clamp(std::ceil(glm::distance(a, b) / spacing), 1.0, 10000.0));
  if (parts == 1) return;
  const glm::dvec3 normal = unit_or_zero(unit_or_zero(area_normals[mesh.face(h).index]) +
                                         unit_or_zero(area_normals[mesh.face(twin(h)).index]));
  for (std::uint32_t i = 1; i < parts; ++i) {
    const double along = double(i) / parts;
    points_.push_back({(1 - along) * a + along * b, normal, 0, no_index});
    give(static_cast<std::uint32_t>(points_.size() - 1), mesh.face(h));
  }
}

void CoveredPoints::give(std::uint32_t point, Face f) {
  make_room(f.index + 1);
  points_[point].next = first_[f.index];
  first_[f.index] = point;
}

bool CoveredStep::are_at_one(const glm::dvec3& area_normal, const Point& point) {
  const double product = glm::dot(area_normal, point.normal);
  return product >= 0 || product >= CoveredPoints::least_facing * glm::length(area_normal);
}

bool CoveredStep::faces(const Point& point, std::size_t change) const {
  return changes_[change].kind != Change::Kind::goes && (is_any_way_ || are_at_one(normals_[change], point));
}

double CoveredStep::distance(const Point& point, std::size_t change) const {
  const auto& [a, b, c] = changes_[change].corners;
  return glm::length(way_from_triangle(a, b, c, point.place));
}

// Of one of the points of a face. Its own face is taken where it is near enough, without a look at the others.
bool CoveredStep::find_answer(std::uint32_t i, std::size_t own, double reach, double near_enough) {
  const Point& point = covered_.points_[i];
  const bool has_own = faces(point, own);
  double own_distance = std::numeric_limits<double>::infinity();
  if (has_own) {
    if (const double most = point.distance + changes_[own].moved; most <= reach) {
      answers_.push_back({i, changes_[own].face, most});
      return true;
    }
    own_distance = distance(point, own);
  }
  Answer answer{i, changes_[own].face, own_distance};
  for (std::size_t k = 0; k < changes_.size() && answer.distance > near_enough; ++k)
    if (k != own && faces(point, k))
      if (const double found = distance(point, k); found < answer.distance) answer = {i, changes_[k].face, found};
  if (!(answer.distance <= std::max(reach, point.distance))) return false;
  answers_.push_back(answer);
  return true;
}

bool CoveredStep::would_stay(std::span<const Change> changes, double reach, double near_enough) {
  answers_.clear();
  normals_.clear();
  old_.clear();
  changes_ = changes;
  is_any_way_ = !std::isfinite(reach);
  is_move_ = false;
  if (changes.size() > most_faces) return false;
  for (const Change& change : changes)
    normals_.push_back(change.kind == Change::Kind::goes ? glm::dvec3(0) : area_normal(change.corners));
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const Face f = changes[k].face;
    if (changes[k].kind == Change::Kind::comes_or_stays || f.index >= covered_.first_.size()) continue;
    old_.push_back(f);
    for (std::uint32_t i = covered_.first_[f.index]; i != no_index; i = covered_.points_[i].next)
      if (!find_answer(i, k, reach, near_enough)) return false;
  }
  return true;
}

void CoveredStep::begin_move(double moved) {
  old_.clear();
  answers_.clear();
  is_move_ = true;
  moved_ = moved;
}

bool CoveredStep::keeps_points(Face f, const glm::dvec3& area_normal, double reach) {
  if (f.index >= covered_.first_.size()) return true;
  old_.push_back(f);
  for (std::uint32_t i = covered_.first_[f.index]; i != no_index;) {
    const Point& point = covered_.points_[i];
    if (!(point.distance + moved_ <= reach) || !are_at_one(area_normal, point)) return false;
    i = point.next;
  }
  return true;
}

void CoveredStep::hand_over() {
  for (const Face f : old_) {
    if (is_move_)
      for (std::uint32_t i = covered_.first_[f.index]; i != no_index; i = covered_.points_[i].next)
        covered_.points_[i].distance += moved_;
    else
      covered_.first_[f.index] = no_index;
  }
  for (const Answer& answer : answers_) {
    covered_.points_[answer.point].distance = answer.distance;
    covered_.give(answer.point, answer.face);
  }
}

}  // namespace ryosen::remesh
