#include "ryosen/scene/view/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/scene/view/packed_normal.h"

namespace ryosen {

namespace {

// From a to b, in a direction that no size spoils; zero where there is none.
glm::dvec3 direction(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 way = 0.5 * b - 0.5 * a;
  return way == glm::dvec3(0) ? way : unit_vector(way);
}

// The angle of the corner at which an outgoing halfedge leaves, within its face; more than half a turn where the face
// is not convex there.
double corner_angle(const Mesh& mesh, Halfedge h, const glm::dvec3& normal) {
  const glm::dvec3& here = mesh.position(mesh.from(h));
  const glm::dvec3 out = direction(here, mesh.position(mesh.to(h)));
  const glm::dvec3 in = direction(here, mesh.position(mesh.from(mesh.prev(h))));
  const glm::dvec3 across = glm::cross(out, in);
  const double angle = std::atan2(glm::length(across), glm::dot(out, in));
  return glm::dot(across, normal) < 0 ? 2 * std::numbers::pi - angle : angle;
}

// Whether the surface goes on from a face to the next without a crease.
bool goes_on(Face a, const glm::dvec3& normal_of_a, Face b, const glm::dvec3& normal_of_b, double crease_cosine) {
  if (a.is_none() || b.is_none()) return false;
  if (a == b || normal_of_a == glm::dvec3(0) || normal_of_b == glm::dvec3(0)) return true;
  return glm::dot(normal_of_a, normal_of_b) >= crease_cosine;
}

}  // namespace

bool FileNormals::are_in(const Mesh& mesh) { return mesh.find_attribute(attribute_names::normal) >= 0; }

FileNormals::Reader::Reader(const FileNormals& normals, const Mesh& mesh)
    : normals_(&normals),
      indices_(find_column(mesh, attribute_names::normal)),
      pool_(find_column(mesh, attribute_names::normal_pool)) {}

std::uint32_t FileNormals::Reader::at(Vertex from, Halfedge h) const {
  if (!indices_ || !pool_ || normals_->all_edited_) return no_normal;
  if (from.index < normals_->edited_.size() && normals_->edited_[from.index]) return no_normal;
  const auto index = attribute_value<std::uint32_t>(*indices_, h.index);
  if (index >= pool_->data.size() / pool_->words()) return no_normal;
  return packed_normal(attribute_value<glm::dvec3>(*pool_, index));
}

void FileNormals::follow(const Mesh& mesh, const TouchedElements& touched) {
  if (!are_in(mesh)) return;
  all_edited_ |= touched.everything;
  if (all_edited_) return;
  edited_.resize(std::max<std::size_t>(edited_.size(), mesh.vertex_slots()));
  const auto note = [&](Vertex v) {
    if (v.index < edited_.size()) edited_[v.index] = true;
  };
  for (const Vertex v : touched.vertices) note(v);
  for (const Face f : touched.faces)
    if (mesh.exists(f) && mesh.is_alive(f))
      for (const Vertex v : vertices_around(mesh, f)) note(v);
}

void CornerNormals::read(Neighbourhood& around, Vertex v) {
  const Mesh& mesh = around.mesh();
  corners_.clear();
  for (const Halfedge h : outgoing(mesh, v)) {
    Corner corner{h, mesh.face(h), glm::dvec3(0), glm::dvec3(0)};
    if (!corner.face.is_none()) corner.normal = around.normal(corner.face);
    if (corner.normal != glm::dvec3(0)) corner.weighted = corner_angle(mesh, h, corner.normal) * corner.normal;
    corners_.push_back(corner);
  }
}

template <class Visit>
void CornerNormals::set_around(Neighbourhood& around, const SurfaceTriangles& triangles, Vertex v, Visit visit) {
  const Mesh& mesh = around.mesh();
  read(around, v);
  const std::size_t n = corners_.size();
  const auto goes_on_behind = [&](std::size_t i) {
    const Corner &a = corners_[i % n], &b = corners_[(i + 1) % n];
    return goes_on(a.face, a.normal, b.face, b.normal, crease_cosine_);
  };
  // Begins behind a gap or a crease, if there is one.
  std::size_t first = 0;
  while (first < n && goes_on_behind(first + n - 1)) ++first;
  if (first == n) first = 0;
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    glm::dvec3 sum(0);
    do sum += corners_[(first + end++) % n].weighted;
    while (end < n && goes_on_behind(first + end - 1));
    const std::uint32_t normal = packed_normal(sum);
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [halfedge, face, own, weighted] = corners_[(first + i) % n];
      if (face.is_none()) continue;
      visit(face);
      const std::uint32_t of_file = of_file_ ? of_file_->at(v, halfedge) : no_normal;
      set(mesh, triangles, face, v, of_file == no_normal ? normal : of_file);
    }
  }
}

void CornerNormals::set(const Mesh& mesh, const SurfaceTriangles& triangles, Face face, Vertex v,
                        std::uint32_t normal) {
  const std::uint32_t slot = triangles.only_slot_of(mesh, face);
  if (slot == no_index) return waiting_.push_back({face, v, normal});
  const SurfaceTriangle triangle = triangles.at(mesh, slot);
  for (std::size_t k = 0; k < 3; ++k)
    if (triangle.corners[k] == v.index) packed_[slot][k] = normal;
}

void CornerNormals::finish(const Mesh& mesh, const SurfaceTriangles& triangles) {
  const auto is_before = [](const PolygonCorner& a, const PolygonCorner& b) {
    return a.face != b.face ? a.face < b.face : a.vertex < b.vertex;
  };
  std::stable_sort(waiting_.begin(), waiting_.end(), is_before);
  for (auto begin = waiting_.cbegin(), end = begin; begin != waiting_.cend(); begin = end) {
    end = std::find_if(begin, waiting_.cend(), [&](const PolygonCorner& corner) { return corner.face != begin->face; });
    for (const std::uint32_t slot : triangles.slots_of(mesh, begin->face)) {
      const SurfaceTriangle triangle = triangles.at(mesh, slot);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex v(triangle.corners[k]);
        const auto found = std::lower_bound(begin, end, PolygonCorner{begin->face, v, 0}, is_before);
        if (found != end && found->vertex == v) packed_[slot][k] = found->normal;
      }
    }
  }
  waiting_.clear();
}

CornerNormals::CornerNormals(const Mesh& mesh, const SurfaceTriangles& triangles, double crease_deg,
                             const FileNormals* file_normals)
    : crease_deg_(crease_deg),
      crease_cosine_(std::cos(crease_deg * std::numbers::pi / 180)),
      file_normals_(file_normals),
      packed_(triangles.slots()) {
  if (file_normals_) of_file_.emplace(*file_normals_, mesh);
  Neighbourhood around(mesh);
  for (const Vertex v : live_vertices(mesh)) set_around(around, triangles, v, [](Face) {});
  finish(mesh, triangles);
  of_file_.reset();
  waiting_.shrink_to_fit();
}

std::vector<std::uint32_t> CornerNormals::update(const Mesh& mesh, const SurfaceTriangles& triangles,
                                                 const TouchedElements& touched) {
  packed_.resize(triangles.slots());
  if (file_normals_) of_file_.emplace(*file_normals_, mesh);
  std::vector<Vertex> vertices = touched.vertices;
  for (const Face f : touched.faces)
    if (mesh.exists(f) && mesh.is_alive(f))
      for (const Vertex v : vertices_around(mesh, f)) vertices.push_back(v);
  sort_unique(vertices);
  Neighbourhood around(mesh);
  std::vector<Face> faces;
  for (const Vertex v : vertices)
    if (mesh.exists(v) && mesh.is_alive(v)) set_around(around, triangles, v, [&](Face f) { faces.push_back(f); });
  finish(mesh, triangles);
  of_file_.reset();
  sort_unique(faces);
  std::vector<std::uint32_t> slots;
  for (const Face f : faces)
    for (const std::uint32_t slot : triangles.slots_of(mesh, f)) slots.push_back(slot);
  return slots;
}

}  // namespace ryosen
