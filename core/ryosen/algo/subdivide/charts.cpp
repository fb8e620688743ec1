#include "ryosen/algo/subdivide/charts.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/copies.h"

namespace ryosen::subdivide {

ValueBounds::ValueBounds(const Mesh& mesh) {
  constexpr double all = std::numeric_limits<double>::infinity();
  bounds_.assign(mesh.vertex_slots(), {glm::dvec3(all), glm::dvec3(-all)});
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    std::pair<glm::dvec3, glm::dvec3> own{glm::dvec3(all), glm::dvec3(-all)};
    for (const Vertex v : vertices_around(mesh, Face(i))) {
      own.first = glm::min(own.first, mesh.position(v));
      own.second = glm::max(own.second, mesh.position(v));
    }
    for (const Vertex v : vertices_around(mesh, Face(i))) {
      auto& [lowest, highest] = bounds_[v.index];
      lowest = glm::min(lowest, own.first);
      highest = glm::max(highest, own.second);
    }
  }
}

void ValueBounds::keep_within(glm::dvec3& value, Vertex a, Vertex b) const {
  const glm::dvec3 lowest = glm::min(bounds_[a.index].first, bounds_[b.index].first),
                   highest = glm::max(bounds_[a.index].second, bounds_[b.index].second);
  if (lowest.x <= highest.x) value = glm::min(glm::max(value, lowest), highest);  // else there are no faces
}

Mesh mesh_of_values(const Mesh& mesh, const AttributeColumn& column, glm::length_t first) {
  MeshColumns columns = mesh.columns();
  columns.attributes.clear();
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const auto value = attribute_value<glm::dvec4>(column, i);
    for (glm::length_t k = 0; k < 3; ++k) columns.positions[i][k] = first + k < 4 ? value[first + k] : 0;
  }
  return Mesh(std::move(columns));
}

Charts::Charts(const Mesh& mesh, const Creases& creases, const CornerAttribute& attribute)
    : mesh_(mesh), creases_(creases), of_(mesh.halfedge_slots()) {
  build(mesh.attributes()[attribute.index_column], mesh.attributes()[attribute.pool_column]);
  take_creases();
  find_tips();
}

// A vertex of the charts for each vertex with each of its values.
void Charts::build(const AttributeColumn& index, const AttributeColumn& pool) {
  IndexedMesh list;
  list.face_offsets.assign(1, 0);
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> known(mesh_.vertex_slots());  // value, number
  const auto number_of = [&](Halfedge corner) {
    const std::uint32_t value = index.data[corner.index];
    auto& own = known[mesh_.from(corner).index];
    for (const auto& [other, number] : own)
      if (other == value) return number;
    const auto number = static_cast<std::uint32_t>(list.positions.size());
    own.emplace_back(value, number);
    list.positions.push_back(attribute_value<glm::dvec3>(pool, value));
    vertex_of_.push_back(mesh_.from(corner));
    return number;
  };
  for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
    if (const Face f(i); mesh_.is_alive(f)) {
      bool has_all = true;
      for (const Halfedge h : loop(mesh_, mesh_.halfedge(f))) has_all = has_all && index.data[h.index] != no_index;
      for (const Halfedge h : loop(mesh_, mesh_.halfedge(f)))
        if (has_all) list.corners.push_back(number_of(h));
    }
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  charts_ = from_indexed(std::move(list));
  for (std::uint32_t i = 0; i < charts_.face_slots(); ++i) {
    if (!charts_.is_alive(Face(i))) continue;
    Halfedge own = charts_.halfedge(Face(i));
    for (const Halfedge h : loop(mesh_, mesh_.halfedge(Face(i)))) {
      of_[h.index] = own;
      own = charts_.next(own);
    }
  }
}

void Charts::take_creases() {
  for (std::size_t i = vertex_of_.size(); i < charts_.vertex_slots(); ++i)  // copies
    vertex_of_.push_back(vertex_of_[point(charts_, Vertex(static_cast<std::uint32_t>(i))).index]);
  own_creases_.corners.resize(charts_.vertex_slots());
  for (std::uint32_t i = 0; i < charts_.vertex_slots(); ++i) {
    const bool stays = rule_at(mesh_, creases_, vertex_of_[i], 1).rule == VertexRule::corner;
    own_creases_.corners[i] = stays || has_copies(charts_, Vertex(i));
  }
  if (creases_.sharpness.empty()) return;
  own_creases_.sharpness.resize(charts_.edge_slots());
  for (std::uint32_t i = 0; i < mesh_.halfedge_slots(); ++i)
    if (const Halfedge own = of_[i])
      own_creases_.sharpness[edge(own).index] = creases_.sharpness_of(mesh_, Halfedge(i));
}

// Where a chart has a boundary at a vertex and the mesh has none, though the vertex has one value.
void Charts::find_tips() {
  std::vector<std::uint32_t> values(mesh_.vertex_slots());
  for (const Vertex v : vertex_of_) ++values[v.index];
  for (std::uint32_t i = 0; i < charts_.vertex_slots(); ++i)
    if (const Vertex v = vertex_of_[i];
        values[v.index] == 1 && charts_.is_boundary(Vertex(i)) && !mesh_.is_boundary(v) && !own_creases_.corners[i])
      tips_.emplace_back(Vertex(i), v);
  if (tips_.empty()) return;
  MeshColumns columns = mesh_.columns();
  columns.attributes.clear();
  std::fill(columns.positions.begin(), columns.positions.end(), glm::dvec3(0));
  for (std::uint32_t i = 0; i < charts_.vertex_slots(); ++i) {
    const Vertex v = vertex_of_[i];
    columns.positions[v.index] += charts_.position(Vertex(i)) / double(values[v.index]);
  }
  means_.emplace(std::move(columns));
}

}  // namespace ryosen::subdivide
