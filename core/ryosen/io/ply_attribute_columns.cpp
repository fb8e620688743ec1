// The columns of attributes, and the rows of the element edge.
#include <algorithm>
#include <limits>

#include "ryosen/io/ply_columns.h"
#include "ryosen/io/ply_header.h"
#include "ryosen/mesh/attribute_text.h"

namespace ryosen {

const AttributeColumn* PlyColumns::attribute_of(TableKind kind, const Property& property) const {
  if (property.role != PropertyRole::attribute) return nullptr;
  const std::string name = attribute_of_property(kind, property.name);
  for (const AttributeColumn& column : file_.mesh.attributes)
    if (column.name == name) return &column;
  return nullptr;
}

void PlyColumns::set_attribute(PlyColumn& column, const AttributeColumn& attribute) {
  column.attribute = &attribute;
  column.type = attribute.type.scalar == Scalar::boolean ? Scalar::uint8 : attribute.type.scalar;
  column.is_list = attribute.type.count != 1 || attribute.element == ElementKind::corner;
}

// Edges of the mesh and kept rows in the order in which the file had them, others behind.
void PlyColumns::add_edge_rows(PlyTable& table, const PropertyTable* kept) const {
  const std::vector<ListedEdge>& edges = file_.mesh.edges;
  const Property* numbers = nullptr;
  for (std::size_t i = 0; kept && i < kept->properties.size(); ++i)
    if (kept->properties[i].role == PropertyRole::row) numbers = &kept->properties[i];
  const std::size_t rows = kept ? kept->rows : 0;
  std::size_t row = 0;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (; row < rows && numbers->integer(row) < std::int64_t{edges[e].row}; ++row)
      table.edges.push_back({true, static_cast<std::uint32_t>(row)});
    table.edges.push_back({false, e});
  }
  for (; row < rows; ++row) table.edges.push_back({true, static_cast<std::uint32_t>(row)});
  table.rows = table.edges.size();
}

// Attributes that the layout does not have.
void PlyColumns::add_attributes() {
  for (const AttributeColumn& attribute : file_.mesh.attributes) {
    if (has(attribute)) continue;
    const TableKind kind = attribute.element == ElementKind::vertex ? TableKind::vertices
                           : attribute.element == ElementKind::edge ? TableKind::edges
                                                                    : TableKind::faces;
    auto table = std::find_if(tables_.begin(), tables_.end(), [&](const PlyTable& each) { return each.kind == kind; });
    if (table == tables_.end()) {
      const std::string_view name = kind == TableKind::edges ? "edge" : "face";
      if (std::any_of(tables_.begin(), tables_.end(), [&](const PlyTable& each) { return each.name == name; }))
        continue;  // an element that is something else
      table = tables_.insert(tables_.end(), PlyTable{name, kind, file_.mesh.face_count(), {}, {}});
      if (kind == TableKind::edges) {
        add_edge_rows(*table, nullptr);
        for (const std::string_view end : {"vertex1", "vertex2"}) {
          PlyColumn& column = table->columns.emplace_back();
          column.name = end;
          column.type = Scalar::int32;
          column.role = PropertyRole::vertex_number;
          column.component = end == "vertex1" ? 0 : 1;
        }
      }
    }
    PlyColumn column;
    column.name = attribute.element == ElementKind::corner ? attribute.name : short_name(attribute);
    const auto has_name = [&](const PlyColumn& each) { return each.name == column.name; };
    if (has_meaning_in_ply(kind, column.name) || std::any_of(table->columns.begin(), table->columns.end(), has_name))
      column.name = attribute.name;
    if (std::any_of(table->columns.begin(), table->columns.end(), has_name)) continue;
    column.role = PropertyRole::attribute;
    set_attribute(column, attribute);
    table->columns.push_back(std::move(column));
  }
}

bool PlyColumns::has(const AttributeColumn& column) const {
  return std::any_of(tables_.begin(), tables_.end(), [&](const PlyTable& table) {
    return std::any_of(table.columns.begin(), table.columns.end(),
                       [&](const PlyColumn& each) { return each.attribute == &column; });
  });
}

const std::uint32_t* PlyColumns::corner_value(const AttributeColumn& column, std::size_t face,
                                              std::size_t corner) const {
  const QuarantinedFace* const aside = quarantined(face);
  const std::size_t words = column.words();
  if (!aside) return column.data.data() + (file_.mesh.face_offsets[face] + corner) * words;
  std::size_t at = 0;
  for (const AttributeColumn& each : file_.mesh.attributes) {
    if (&each == &column) break;
    if (each.element == ElementKind::corner) at += each.words() * aside->corners.size();
  }
  return at < aside->values.size() ? aside->values.data() + at + corner * words : column.fill.data();
}

// A type that was wide enough for the file may not be for edges that are new.
void PlyColumns::widen_ends(PlyColumn& column) const {
  std::uint32_t most = 0;
  for (const ListedEdge& e : file_.mesh.edges) most = std::max({most, e.from, e.to});
  const auto holds_most = [&](Scalar type) {
    return with_scalar(type, [&](auto zero) {
      return static_cast<double>(most) <= static_cast<double>(std::numeric_limits<decltype(zero)>::max());
    });
  };
  for (const Scalar type : {Scalar::int32, Scalar::uint32})
    if (!holds_most(column.type)) column.type = type;
}

std::uint64_t ply_unwritten_attributes(const MeshFile& file) {
  const std::vector<AttributeColumn>& all = file.mesh.attributes;
  if (all.empty()) return 0;
  const PlyColumns columns(file, Encoding::binary_little);
  return static_cast<std::uint64_t>(
      std::count_if(all.begin(), all.end(), [&](const AttributeColumn& column) { return !columns.has(column); }));
}

}  // namespace ryosen
