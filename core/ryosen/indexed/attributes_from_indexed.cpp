#include "ryosen/indexed/attributes_from_indexed.h"

#include <cstring>
#include <limits>

#include "ryosen/mesh/attribute.h"

namespace ryosen {

namespace {

template <class T>
void copy_words(AttributeColumn& column, const std::vector<T>& values) {
  column.data.resize(values.size() * column.words);
  if (!values.empty()) std::memcpy(column.data.data(), values.data(), values.size() * sizeof(T));
}

AttributeColumn make_column(std::string_view name, ElementKind element, std::size_t value_bytes, std::uint32_t fill) {
  const auto words = static_cast<std::uint32_t>(value_bytes / sizeof(std::uint32_t));
  return {std::string(name), element, words, {}, std::vector<std::uint32_t>(words, fill)};
}

void add_corner_values(const CornerValues& values, std::string_view index_name, std::string_view pool_name,
                       const CornerPairing& pairing, MeshColumns& c) {
  if (values.pool.empty() && values.index.empty()) return;
  AttributeColumn index = make_column(index_name, ElementKind::corner, sizeof(std::uint32_t), no_index);
  index.data.assign(c.halfedges.size(), no_index);
  for (std::size_t corner = 0; corner < values.index.size(); ++corner)
    index.data[pairing.halfedge[corner].index] = values.index[corner];
  AttributeColumn pool = make_column(pool_name, ElementKind::pool, sizeof(glm::dvec3), 0);
  copy_words(pool, values.pool);
  c.attributes.push_back(std::move(index));
  c.attributes.push_back(std::move(pool));
}

void add_face_names(const FaceNames& names, std::string_view name, MeshColumns& c) {
  if (names.index.empty()) return;
  AttributeColumn column = make_column(name, ElementKind::face, sizeof(std::uint32_t), no_index);
  column.data = names.index;
  c.attributes.push_back(std::move(column));
}

void add_colours(const IndexedMesh& source, MeshColumns& c) {
  if (source.vertex_colours.empty()) return;
  AttributeColumn column = make_column(attribute_names::colour, ElementKind::vertex, sizeof(glm::dvec4), 0);
  // NaN marks "no colour", the value of new vertices.
  const glm::dvec4 none(std::numeric_limits<double>::quiet_NaN());
  std::memcpy(column.fill.data(), &none, sizeof none);
  copy_words(column, source.vertex_colours);
  // Copies of a point take its colour.
  column.data.resize(c.vertex_halfedge.size() * column.words);
  for (std::size_t v = source.vertex_colours.size(); v < c.vertex_halfedge.size(); ++v) {
    const Vertex point = c.copy_point[v];
    std::memcpy(column.data.data() + v * column.words, &source.vertex_colours[point.index], sizeof(glm::dvec4));
  }
  c.attributes.push_back(std::move(column));
}

}  // namespace

void add_attributes(const IndexedMesh& source, const CornerPairing& pairing, MeshColumns& c) {
  add_corner_values(source.texcoords, attribute_names::texcoord, attribute_names::texcoord_pool, pairing, c);
  add_corner_values(source.normals, attribute_names::normal, attribute_names::normal_pool, pairing, c);
  add_colours(source, c);
  add_face_names(source.materials, attribute_names::material, c);
  add_face_names(source.groups, attribute_names::group, c);
  add_face_names(source.objects, attribute_names::object, c);
  add_face_names(source.smoothing, attribute_names::smoothing, c);
}

}  // namespace ryosen
