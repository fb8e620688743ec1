#include "ryosen/algo/seams/flat_normals.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/analysis/disjoint_sets.h"
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

// Whether all corners of a face have one normal, which is its own but for the few digits that files write.
bool has_own_normal(const Mesh& mesh, Face f, const AttributeColumn& index, const AttributeColumn& pool) {
  constexpr double least_cosine = 0.9998476951563913;  // of 1 degree
  const std::uint32_t first = index.data[mesh.halfedge(f).index];
  if (first == no_index) return false;
  for (const Halfedge h : halfedges_around(mesh, f))
    if (index.data[h.index] != first) return false;
  const auto own = unit_normal(mesh, f);
  const auto given = attribute_value<glm::dvec3>(pool, first);
  const double length = glm::length(given);
  return length > 0 && (!own || glm::dot(*own, given) >= least_cosine * length);
}

// A face with the normal of one that is not flat is part of a smooth surface.
std::vector<std::uint8_t> find_flat(const Mesh& mesh, const AttributeColumn& index, const AttributeColumn& pool) {
  std::vector<std::uint8_t> is_flat(mesh.face_slots());
  for (const Face f : live_faces(mesh)) is_flat[f.index] = has_own_normal(mesh, f, index, pool);
  DisjointSets alike(mesh.face_slots());
  for (const Edge e : live_edges(mesh)) {
    const Halfedge h = halfedge(e), o = twin(h);
    if (mesh.is_outside(h) || mesh.is_outside(o)) continue;
    if (index.data[h.index] == index.data[mesh.next(o).index] || index.data[mesh.next(h).index] == index.data[o.index])
      alike.join(mesh.face(h).index, mesh.face(o).index);
  }
  std::vector<std::uint8_t> is_smooth(mesh.face_slots());
  for (const Face f : live_faces(mesh))
    if (!is_flat[f.index]) is_smooth[alike.root(f.index)] = 1;
  for (const Face f : live_faces(mesh))
    if (is_smooth[alike.root(f.index)]) is_flat[f.index] = 0;
  return is_flat;
}

// The value that the corners of a face had before, by one that it still has; no_index where it has none of them.
std::uint32_t old_value(const Mesh& mesh, Face f, const AttributeColumn& index, const Mesh& before) {
  for (const Halfedge h : halfedges_around(mesh, f))
    if (before.exists(h) && before.is_alive(h) && before.face(h) == f) return index.data[h.index];
  return no_index;
}

bool is_as_it_was(const Mesh& mesh, Face f, const Mesh& before) {
  for (const Halfedge h : halfedges_around(mesh, f)) {
    if (!before.exists(h) || !before.is_alive(h) || before.face(h) != f || before.next(h) != mesh.next(h)) return false;
    if (before.position(before.from(h)) != mesh.position(mesh.from(h))) return false;
  }
  return true;
}

// But for rounding.
bool looks_along(const glm::dvec3& normal, const glm::dvec3& given) {
  constexpr double most = 1e-14;
  return glm::distance(normal, given / glm::length(given)) <= most;
}

}  // namespace

std::vector<std::uint8_t> take_flat_normals(Mesh& mesh) {
  const AttributeColumn* const index = find_column(mesh, attribute_names::normal);
  const AttributeColumn* const pool = find_column(mesh, attribute_names::normal_pool);
  if (!index || !pool) return {};
  std::vector<std::uint8_t> is_flat = find_flat(mesh, *index, *pool);
  const auto count = static_cast<std::size_t>(std::count(is_flat.begin(), is_flat.end(), std::uint8_t{1}));
  if (count == 0) return {};
  const auto k = static_cast<std::size_t>(index - mesh.attributes().data());
  MeshColumns columns = mesh.columns();
  if (count == mesh.live().faces) {
    std::erase_if(columns.attributes, [](const AttributeColumn& column) {
      return column.name == attribute_names::normal || column.name == attribute_names::normal_pool;
    });
  } else {
    for (const Face f : live_faces(mesh))
      if (is_flat[f.index])
        for (const Halfedge h : halfedges_around(mesh, f)) columns.attributes[k].data[h.index] = no_index;
  }
  mesh = Mesh(std::move(columns));
  return is_flat;
}

std::vector<std::uint8_t> flags_of_parts(const std::vector<std::uint8_t>& is_flat, const Mesh& parts,
                                         const Descent& descent) {
  std::vector<std::uint8_t> flags(parts.face_slots());
  for (const Face f : live_faces(parts))
    if (const Face whole = descent.origin(f)) flags[f.index] = is_flat[whole.index];
  return flags;
}

void put_flat_normals(Mesh& mesh, const std::vector<std::uint8_t>& is_flat, const Mesh& before) {
  MeshColumns columns = mesh.columns();
  const AttributeColumn &old_index = *find_column(before, attribute_names::normal),
                        &old_pool = *find_column(before, attribute_names::normal_pool);
  if (mesh.find_attribute(attribute_names::normal) < 0) {
    columns.attributes.insert(columns.attributes.end(), {old_index, old_pool});
    std::vector<std::uint32_t>& data = columns.attributes[columns.attributes.size() - 2].data;
    data.assign(columns.halfedges.size(), no_index);
  }
  const auto column = [&](std::string_view name) -> AttributeColumn& {
    return *std::find_if(columns.attributes.begin(), columns.attributes.end(),
                         [&](const AttributeColumn& each) { return each.name == name && each.is_removed == 0; });
  };
  AttributeColumn &index = column(attribute_names::normal), &pool = column(attribute_names::normal_pool);
  auto values = static_cast<std::uint32_t>(pool.data.size() / pool.words());
  for (const Face f : live_faces(mesh)) {
    if (!is_flat[f.index]) continue;
    const auto normal = unit_normal(mesh, f);
    const std::uint32_t old = old_value(mesh, f, old_index, before);
    const bool stays = old != no_index && (!normal || is_as_it_was(mesh, f, before) ||
                                           looks_along(*normal, attribute_value<glm::dvec3>(old_pool, old)));
    if (!stays && !normal) continue;
    for (const Halfedge h : halfedges_around(mesh, f)) index.data[h.index] = stays ? old : values;
    if (stays) continue;
    const auto words = attribute_words(*normal);
    pool.data.insert(pool.data.end(), words.begin(), words.end());
    ++values;
  }
  mesh = Mesh(std::move(columns));
}

}  // namespace ryosen
