#include "ryosen/ops/rules/face_lists.h"

#include <algorithm>
#include <unordered_set>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"

namespace ryosen {

std::vector<std::uint32_t> points_along(const Mesh& mesh, Halfedge start) {
  std::vector<std::uint32_t> points;
  for (Halfedge h : loop(mesh, start)) points.push_back(point(mesh, mesh.from(h)).index);
  return points;
}

std::vector<glm::dvec3> places_along(const Mesh& mesh, Halfedge start) {
  std::vector<glm::dvec3> places;
  for (Halfedge h : loop(mesh, start)) places.push_back(mesh.position(mesh.from(h)));
  return places;
}

CornerLoops loops_of(const Mesh& mesh, Face f) {
  CornerLoops loops;
  for_each_loop(mesh, f, [&](Halfedge start) { loops.add(points_along(mesh, start)); });
  return loops;
}

std::size_t bridges_of(const CornerLoops& loops) {
  const auto parts = take_out_bridges(loops);
  return parts ? parts->size() - loops.ends.size() : 0;
}

bool touches(const Mesh& mesh, Face f, Vertex v) {
  const auto corners = halfedges_around(mesh, f);
  auto corner = corners.begin();
  bool found = false;
  any_of_copies(mesh, v, [&](Vertex copy) {
    for (Halfedge h : outgoing(mesh, copy)) {
      if (corner == corners.end()) return true;
      found = mesh.face(h) == f || same_point(mesh, mesh.from(*corner), v);
      if (found) return true;
      ++corner;
    }
    return false;
  });
  return found;
}

bool is_one_simple_loop(const Mesh& mesh, Face f) {
  if (mesh.has_rings(f)) return false;
  for (Halfedge h : loop(mesh, mesh.halfedge(f)))
    if (is_bridge(mesh, h)) return false;
  return true;
}

void refuse_rings(const Mesh& mesh, Face f, Verdict& verdict) {
  std::vector<Element> witnesses{f};
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next)
    for (Halfedge h : loop(mesh, mesh.ring(r).halfedge)) witnesses.push_back(edge(h));
  for (Halfedge h : halfedges_around(mesh, f))
    if (is_bridge(mesh, h) && h < twin(h)) witnesses.push_back(edge(h));
  if (witnesses.size() > 1) verdict.reasons.push_back({Rule::has_rings, witnesses});
}

std::vector<std::uint32_t> point_set(std::span<const std::uint32_t> corners) {
  std::vector<std::uint32_t> points(corners.begin(), corners.end());
  sort_unique(points);
  return points;
}

namespace {

bool has_points(const Mesh& mesh, Face f, std::span<const std::uint32_t> points) {
  std::size_t corners = 0;
  for (Vertex v : vertices_around(mesh, f)) {
    if (++corners > 2 * points.size()) return false;
    if (!std::binary_search(points.begin(), points.end(), point(mesh, v).index)) return false;
  }
  return corners >= points.size() && point_set(loops_of(mesh, f).corners).size() == points.size();
}

}  // namespace

std::vector<Face> faces_on(const Mesh& mesh, std::span<const std::uint32_t> points, std::span<const Face> except,
                           std::size_t most) {
  std::vector<Face> found;
  std::unordered_set<Face> seen;  // a face with bridges may visit a point more than once
  const auto is_in = [](std::span<const Face> faces, Face f) {
    return std::find(faces.begin(), faces.end(), f) != faces.end();
  };
  any_of_faces_at(mesh, loneliest_point(mesh, points), [&](Face f) {
    if (is_in(except, f) || !has_points(mesh, f, points) || !seen.insert(f).second) return false;
    found.push_back(f);
    return found.size() == most;
  });
  return found;
}

Face face_on(const Mesh& mesh, std::span<const std::uint32_t> points, std::span<const Face> except) {
  const std::vector<Face> found = faces_on(mesh, points, except, 1);
  return found.empty() ? Face() : found[0];
}

Face face_on_unless(const Mesh& mesh, std::span<const std::uint32_t> points,
                    const std::function<bool(Face)>& is_left_out) {
  Face found;
  any_of_faces_at(mesh, loneliest_point(mesh, points), [&](Face f) {
    if (is_left_out(f) || !has_points(mesh, f, points)) return false;
    found = f;
    return true;
  });
  return found;
}

Face equal_face(const Mesh& mesh, Face f) {
  const Face except[] = {f};
  return face_on(mesh, point_set(loops_of(mesh, f).corners), except);
}

void EqualFaceIndex::read_faces_at(Vertex p) {
  read_.insert(p);
  for_each_face_at(mesh_, p, [&](Face f) {
    if (known_.insert(f).second) ++count_[point_set(loops_of(mesh_, f).corners)];
  });
}

// All faces on the same points are known where one of these has been read.
bool EqualFaceIndex::has_equal(Face f) {
  const std::vector<std::uint32_t> points = point_set(loops_of(mesh_, f).corners);
  const bool is_read =
      std::any_of(points.begin(), points.end(), [&](std::uint32_t p) { return read_.contains(Vertex(p)); });
  if (!is_read) read_faces_at(point(mesh_, loneliest_point(mesh_, points)));
  return count_[points] > 1;
}

}  // namespace ryosen
