// The standard attributes of a mesh and typed access to their values.
#pragma once

#include <array>
#include <cassert>
#include <cstring>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Names of the columns that readers fill; is_reserved_name() lists them. A corner value is an index into its pool,
// no_index where the corner has none.
namespace attribute_names {
inline constexpr std::string_view texcoord = "corner.texcoord";     // -> texcoord_pool
inline constexpr std::string_view texcoord_pool = "pool.texcoord";  // dvec3
inline constexpr std::string_view normal = "corner.normal";         // -> normal_pool
inline constexpr std::string_view normal_pool = "pool.normal";      // dvec3
inline constexpr std::string_view colour = "vertex.colour";         // dvec4
inline constexpr std::string_view weight = "vertex.weight";         // double, NaN where a vertex has none
inline constexpr std::string_view face_colour = "face.colour";      // dvec4, of so many components:
inline constexpr std::string_view face_colour_components = "face.colour_components";  // uint8, as in FaceColours::count
inline constexpr std::string_view material = "face.material";  // index into the document's table of names
inline constexpr std::string_view group = "face.group";
inline constexpr std::string_view object = "face.object";
inline constexpr std::string_view smoothing = "face.smoothing";
// The place of an edge in the list of the file, no_index where it is not listed: twice its row, and one more where the
// row has the larger end first.
inline constexpr std::string_view edge_row = "edge.row";
}  // namespace attribute_names

// The column with this name, or null.
inline const AttributeColumn* find_column(const Mesh& mesh, std::string_view name) {
  const int i = mesh.find_attribute(name);
  return i < 0 ? nullptr : &mesh.attributes()[static_cast<std::size_t>(i)];
}

// The value at an index of a column of type T.
template <AttributeValue T>
T attribute_value(const AttributeColumn& column, std::uint32_t index) {
  assert(column.type == value_type<T>);
  T value;
  std::memcpy(&value, column.data.data() + std::size_t{index} * column.words(), sizeof(T));
  return value;
}
// All values of a column of type T, which fills whole words.
template <AttributeValue T>
requires(sizeof(T) % sizeof(std::uint32_t) == 0) std::vector<T> attribute_values(const AttributeColumn& column) {
  std::vector<T> values(column.data.size() / column.words());
  if (!values.empty()) std::memcpy(values.data(), column.data.data(), values.size() * sizeof(T));
  return values;
}
// Writes one number of a value, whose type must be of floats or doubles.
void put_real_number(AttributeColumn& column, std::uint32_t index, std::uint32_t number, double value);
// One number of a value of any type as a double; 1 for true.
double number_at(const AttributeColumn& column, std::uint32_t index, std::uint32_t number = 0);
// A value as the words of a column.
template <AttributeValue T>
std::array<std::uint32_t, value_type<T>.words()> attribute_words(const T& value) {
  std::array<std::uint32_t, value_type<T>.words()> words{};
  std::memcpy(words.data(), &value, sizeof(T));
  return words;
}

// A column without elements, in which new ones get the value `fill`.
template <AttributeValue T>
AttributeColumn make_column(std::string_view name, ElementKind element, ValueRule rule, const T& fill) {
  const auto words = attribute_words(fill);
  return {std::string(name), element, value_type<T>, rule, {}, {words.begin(), words.end()}};
}
// A copy with the values of these elements, one after the other: the default for no_index.
AttributeColumn with_rows(const AttributeColumn& column, std::span<const std::uint32_t> rows);
// Whether the name is one of attribute_names, or of a column that the program makes for itself.
bool is_reserved_name(std::string_view name);
// The attributes that are neither removed nor reserved: those of files, scripts and programs.
std::vector<const AttributeColumn*> free_attributes(const Mesh& mesh);

// A corner attribute with its pool, both without values.
struct CornerColumns {
  AttributeColumn index, pool;
};
CornerColumns make_corner_columns(std::string_view index_name, std::string_view pool_name);

// A corner column with its pool, as indices into Mesh::attributes().
struct CornerAttribute {
  std::size_t index_column;
  std::size_t pool_column;
};
bool has_attributes(const Mesh& mesh, ElementKind element);
// The corner attributes that the mesh carries (texture coordinates, normals).
std::vector<CornerAttribute> corner_attributes(const Mesh& mesh);
// Whether the corners of two faces carry other values at an end of the edge that the faces share. One half of it in
// each face is given; `alike` tells that the two run in the same direction. Equal values in two places of a pool are
// equal.
bool corner_values_differ(const Mesh& mesh, Halfedge a, Halfedge b, bool alike);

}  // namespace ryosen
