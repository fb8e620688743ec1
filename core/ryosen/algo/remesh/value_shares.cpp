#include "ryosen/algo/remesh/value_shares.h"

#include <algorithm>
#include <glm/vec4.hpp>

#include "ryosen/mesh/circulate.h"

namespace ryosen::remesh {

namespace {

using Words = std::span<const std::uint32_t>;

// The sum of the values at the indices by their weights. Numbers without a weight may be infinite.
template <class T>
T mixed(const AttributeColumn& column, const std::array<std::uint32_t, 3>& at, const std::array<double, 3>& weights) {
  T sum(0);
  for (std::size_t i = 0; i < 3; ++i)
    if (weights[i] != 0) sum += weights[i] * attribute_value<T>(column, at[i]);
  return sum;
}

std::size_t largest(const std::array<double, 3>& weights) {
  return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

std::array<Halfedge, 3> corners_of_face(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {h, mesh.next(h), mesh.prev(h)};
}

}  // namespace

Target::Share share_of_corner(const Mesh& mesh, Halfedge corner) {
  const Face f = mesh.face(corner);
  Target::Share share{f, {}};
  const auto corners = corners_of_face(mesh, f);
  for (std::size_t i = 0; i < 3; ++i) share.weights[i] = corners[i] == corner ? 1 : 0;
  return share;
}

void ShareWriter::write(Vertex v, const Target::Share& share) {
  const auto corners = corners_of_face(before_, share.face);
  write_vertex_values(v, {before_.from(corners[0]), before_.from(corners[1]), before_.from(corners[2])}, share);
  for (const CornerAttribute& attribute : attributes_) {
    const std::uint32_t index = value_of(attribute, corners, share);
    for (const Halfedge h : outgoing(edit_.mesh(), v))
      edit_.set_attribute(attribute.index_column, h.index, Words(&index, 1));
  }
}

void ShareWriter::write_vertex_values(Vertex v, const std::array<Vertex, 3>& corners, const Target::Share& share) {
  const std::array<std::uint32_t, 3> at{corners[0].index, corners[1].index, corners[2].index};
  const std::size_t nearest = largest(share.weights);
  for (std::size_t k = 0; k < before_.attributes().size(); ++k) {
    const AttributeColumn& column = before_.attributes()[k];
    if (column.element != ElementKind::vertex) continue;
    if (share.weights[nearest] != 1 && column.words == sizeof(glm::dvec4) / sizeof(std::uint32_t))
      edit_.set_attribute(k, v.index, attribute_words(mixed<glm::dvec4>(column, at, share.weights)));
    else
      edit_.set_attribute(k, v.index,
                          Words(column.data).subspan(std::size_t{at[nearest]} * column.words, column.words));
  }
}

std::uint32_t ShareWriter::value_of(const CornerAttribute& attribute, const std::array<Halfedge, 3>& corners,
                                    const Target::Share& share) {
  const std::vector<std::uint32_t>& indices = before_.attributes()[attribute.index_column].data;
  const std::array<std::uint32_t, 3> at{indices[corners[0].index], indices[corners[1].index],
                                        indices[corners[2].index]};
  const std::size_t nearest = largest(share.weights);
  if (share.weights[nearest] == 1 || (at[0] == at[1] && at[1] == at[2])) return at[nearest];
  if (std::find(at.begin(), at.end(), no_index) != at.end()) return no_index;
  const AttributeColumn& pool = before_.attributes()[attribute.pool_column];
  return edit_.append_value(attribute.pool_column, attribute_words(mixed<glm::dvec3>(pool, at, share.weights)));
}

}  // namespace ryosen::remesh
