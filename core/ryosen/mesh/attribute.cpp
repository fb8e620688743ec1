#include "ryosen/mesh/attribute.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

namespace ryosen {

AttributeColumn with_rows(const AttributeColumn& column, std::span<const std::uint32_t> rows) {
  const std::size_t words = column.words();
  AttributeColumn out{column.name, column.element, column.type, column.rule, {}, column.fill, 0, column.own_rule};
  out.data.reserve(rows.size() * words);
  for (const std::uint32_t row : rows) {
    const std::uint32_t* const value = row == no_index ? column.fill.data() : column.data.data() + row * words;
    out.data.insert(out.data.end(), value, value + words);
  }
  return out;
}

bool is_reserved_name(std::string_view name) {
  using namespace attribute_names;
  constexpr std::string_view reserved[] = {
      texcoord, texcoord_pool, normal, normal_pool, colour,  weight, face_colour, face_colour_components,
      material, group,         object, smoothing,   edge_row};
  return std::find(std::begin(reserved), std::end(reserved), name) != std::end(reserved);
}

std::vector<const AttributeColumn*> free_attributes(const Mesh& mesh) {
  std::vector<const AttributeColumn*> found;
  for (const AttributeColumn& column : mesh.attributes())
    if (column.is_removed == 0 && column.element != ElementKind::pool && !is_reserved_name(column.name))
      found.push_back(&column);
  return found;
}

CornerColumns make_corner_columns(std::string_view index_name, std::string_view pool_name) {
  return {make_column(index_name, ElementKind::corner, ValueRule::first, no_index),
          make_column(pool_name, ElementKind::pool, ValueRule::blend, glm::dvec3(0))};
}

double number_at(const AttributeColumn& column, std::uint32_t index, std::uint32_t number) {
  const auto* const value =
      reinterpret_cast<const std::byte*>(column.data.data() + std::size_t{index} * column.words());
  return with_scalar(column.type.scalar, [&](auto zero) {
    using Number = std::conditional_t<std::is_same_v<decltype(zero), bool>, std::uint8_t, decltype(zero)>;
    Number found;
    std::memcpy(&found, value + number * sizeof found, sizeof found);
    return static_cast<double>(found);
  });
}

void put_real_number(AttributeColumn& column, std::uint32_t index, std::uint32_t number, double value) {
  std::uint32_t* const words = column.data.data() + std::size_t{index} * column.words();
  if (column.type.scalar == Scalar::float32)
    words[number] = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  else
    std::memcpy(words + 2 * std::size_t{number}, &value, sizeof value);
}

bool has_attributes(const Mesh& mesh, ElementKind element) {
  const std::span<const AttributeColumn> all = mesh.attributes();
  return std::any_of(all.begin(), all.end(), [&](const AttributeColumn& column) { return column.is_of(element); });
}

std::vector<CornerAttribute> corner_attributes(const Mesh& mesh) {
  std::vector<CornerAttribute> found;
  const auto add = [&](std::string_view index_name, std::string_view pool_name) {
    const int index = mesh.find_attribute(index_name), pool = mesh.find_attribute(pool_name);
    if (index >= 0 && pool >= 0) found.push_back({static_cast<std::size_t>(index), static_cast<std::size_t>(pool)});
  };
  add(attribute_names::texcoord, attribute_names::texcoord_pool);
  add(attribute_names::normal, attribute_names::normal_pool);
  return found;
}

bool corner_values_differ(const Mesh& mesh, Halfedge a, Halfedge b, bool alike) {
  const Halfedge a_end = mesh.next(a), b_end = mesh.next(b);
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    const std::vector<std::uint32_t>& index = mesh.attributes()[attribute.index_column].data;
    const AttributeColumn& pool = mesh.attributes()[attribute.pool_column];
    const auto differ = [&](Halfedge corner, Halfedge other) {
      const std::uint32_t i = index[corner.index], k = index[other.index];
      if (i == k) return false;
      if (i == no_index || k == no_index) return true;
      return attribute_value<glm::dvec3>(pool, i) != attribute_value<glm::dvec3>(pool, k);
    };
    if (differ(a, alike ? b : b_end) || differ(a_end, alike ? b_end : b)) return true;
  }
  return false;
}

}  // namespace ryosen
