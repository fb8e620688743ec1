#include "ryosen/indexed/lost_vertices.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// Live points indexed by position.
class PointsByPlace {
 public:
  explicit PointsByPlace(const Mesh& mesh) : mesh_(mesh) {
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
      const Vertex v(i);
      if (mesh.is_alive(v) && point(mesh, v) == v && is_place(mesh.position(v))) points_.push_back(v);
    }
    std::sort(points_.begin(), points_.end(), [&](Vertex a, Vertex b) {
      return is_before(mesh_.position(a), mesh_.position(b)) || (mesh_.position(a) == mesh_.position(b) && a < b);
    });
  }

  // The lowest point at a position, or none.
  Vertex at(const glm::dvec3& place) const {
    if (!is_place(place)) return Vertex();
    const auto found = std::lower_bound(points_.begin(), points_.end(), place,
                                        [&](Vertex v, const glm::dvec3& p) { return is_before(mesh_.position(v), p); });
    return found != points_.end() && mesh_.position(*found) == place ? *found : Vertex();
  }

 private:
  static bool is_place(const glm::dvec3& p) { return !std::isnan(p.x) && !std::isnan(p.y) && !std::isnan(p.z); }
  static bool is_before(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }

  const Mesh& mesh_;
  std::vector<Vertex> points_;
};

}  // namespace

LostVertices find_lost(const Mesh& mesh, const FileTables& tables, std::span<const Vertex> used_beside) {
  std::vector<Vertex> gone;
  const auto add = [&](std::int64_t number) {
    if (number < 0 || number >= std::int64_t{mesh.file_vertices()}) return;
    const Vertex v(static_cast<std::uint32_t>(number));
    if (!mesh.is_alive(v)) gone.push_back(v);
  };
  for (const QuarantinedFace& face : tables.quarantine) std::for_each(face.corners.begin(), face.corners.end(), add);
  for (const Vertex v : used_beside) add(v.index);
  sort_unique(gone);
  LostVertices lost;
  if (gone.empty()) return lost;
  const PointsByPlace points(mesh);
  for (const Vertex v : gone) {
    const Vertex there = points.at(mesh.position(v));
    // A file vertex with a higher number does not replace it: it keeps its own row of values.
    if (!there.is_none() && (there < v || there.index >= mesh.file_vertices()))
      lost.replacements.emplace_back(v, there);
    else
      lost.kept.push_back(v);
  }
  return lost;
}

}  // namespace ryosen
