#include "ryosen/algo/simplify/flat_normals.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// The unit normal of a face; none where it has no area.
std::optional<glm::dvec3> unit_normal(const Mesh& mesh, Face f) {
  const FacePolygon polygon(mesh, f);
  if (!polygon.is_finite()) return std::nullopt;
  const glm::dvec3 normal = polygon_normal(polygon.keyhole_walk());
  const double length = glm::length(normal);
  return length > 0 ? std::optional(normal / length) : std::nullopt;
}

// Whether all corners of a face have one normal, which files write with few digits.
bool is_flat(const Mesh& mesh, Face f, const AttributeColumn& index, const AttributeColumn& pool) {
  constexpr double least_cosine = 0.9;
  const std::uint32_t first = index.data[mesh.halfedge(f).index];
  if (first == no_index) return false;
  for (const Halfedge h : halfedges_around(mesh, f))
    if (index.data[h.index] != first) return false;
  const auto own = unit_normal(mesh, f);
  const auto given = attribute_value<glm::dvec3>(pool, first);
  return !own || glm::dot(*own, given) >= least_cosine * glm::length(given);
}

}  // namespace

bool take_flat_normals(Mesh& mesh) {
  const AttributeColumn* const index = find_column(mesh, attribute_names::normal);
  const AttributeColumn* const pool = find_column(mesh, attribute_names::normal_pool);
  if (!index || !pool) return false;
  for (const Face f : live_faces(mesh))
    if (!is_flat(mesh, f, *index, *pool)) return false;
  MeshColumns columns = mesh.columns();
  std::erase_if(columns.attributes, [](const AttributeColumn& column) {
    return column.name == attribute_names::normal || column.name == attribute_names::normal_pool;
  });
  mesh = Mesh(std::move(columns));
  return true;
}

void put_flat_normals(Mesh& mesh) {
  MeshColumns columns = mesh.columns();
  auto [index, pool] = make_corner_columns(attribute_names::normal, attribute_names::normal_pool);
  index.data.assign(columns.halfedges.size(), no_index);
  std::uint32_t values = 0;
  for (const Face f : live_faces(mesh)) {
    const auto normal = unit_normal(mesh, f);
    if (!normal) continue;
    const auto words = attribute_words(*normal);
    pool.data.insert(pool.data.end(), words.begin(), words.end());
    for (const Halfedge h : halfedges_around(mesh, f)) index.data[h.index] = values;
    ++values;
  }
  columns.attributes.push_back(std::move(index));
  columns.attributes.push_back(std::move(pool));
  mesh = Mesh(std::move(columns));
}

}  // namespace ryosen
