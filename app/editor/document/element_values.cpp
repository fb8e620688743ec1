#include "app/editor/document/element_values.h"

#include <cmath>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/attribute_text.h"

namespace ryosen {
namespace {

// The table of names whose numbers a column has, or null.
const std::vector<std::string>* names_of(const AttributeColumn& column, const FileTables& tables) {
  using namespace attribute_names;
  return column.name == material    ? &tables.materials
         : column.name == group     ? &tables.groups
         : column.name == object    ? &tables.objects
         : column.name == smoothing ? &tables.smoothing
                                    : nullptr;
}

// The pool whose values a corner column refers to, or null.
const AttributeColumn* pool_of(const Mesh& mesh, const AttributeColumn& column) {
  if (column.name != attribute_names::texcoord && column.name != attribute_names::normal) return nullptr;
  for (const CornerAttribute& each : corner_attributes(mesh))
    if (&mesh.attributes()[each.index_column] == &column) return &mesh.attributes()[each.pool_column];
  return nullptr;
}

std::string text_of(const AttributeColumn& column, std::uint32_t index) {
  return value_text(column.type, column.data.data() + std::size_t{index} * column.words());
}

std::string text_of(const Mesh& mesh, const FileTables& tables, const AttributeColumn& column, std::uint32_t index) {
  if (const AttributeColumn* const pool = pool_of(mesh, column)) {
    const std::uint32_t place = column.data[index];
    return place == no_index ? "" : text_of(*pool, place);
  }
  if (const std::vector<std::string>* const names = names_of(column, tables)) {
    const std::uint32_t name = column.data[index];
    return name < names->size() ? (*names)[name] : "";
  }
  const bool may_be_none = column.name == attribute_names::colour || column.name == attribute_names::weight;
  if (may_be_none && std::isnan(number_at(column, index))) return "";
  if (column.name != attribute_names::face_colour) return text_of(column, index);
  const AttributeColumn* const components = find_column(mesh, attribute_names::face_colour_components);
  const ValueType type{Scalar::float64, attribute_value<std::uint8_t>(*components, index)};
  return value_text(type, column.data.data() + std::size_t{index} * column.words());
}

// Columns that are part of another one, or of the order of the file.
bool is_hidden(const AttributeColumn& column) {
  return column.name == attribute_names::edge_row || column.name == attribute_names::face_colour_components;
}

}  // namespace

std::vector<ElementValue> values_of(const Mesh& mesh, const FileTables& tables, const Element& element) {
  constexpr ElementKind kinds[] = {ElementKind::vertex, ElementKind::corner, ElementKind::edge, ElementKind::face};
  const ElementKind kind = kinds[static_cast<std::size_t>(element.kind)];
  std::vector<ElementValue> values;
  if (element.kind == Element::Kind::halfedge && mesh.is_outside(element.halfedge())) return values;
  for (const AttributeColumn& column : mesh.attributes()) {
    if (!column.is_of(kind) || is_hidden(column)) continue;
    std::string text = text_of(mesh, tables, column, element.index);
    if (!text.empty()) values.push_back({std::string(short_name(column)), std::move(text), !names_of(column, tables)});
  }
  return values;
}

}  // namespace ryosen
