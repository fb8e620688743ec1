// The columns of attributes, and the rows of the element edge.
#include <algorithm>
#include <limits>
#include <set>
#include <utility>

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

void PlyColumns::set_attribute(PlyColumn& column, const AttributeColumn& attribute) const {
  if (attribute.element == ElementKind::corner)
    for (const AttributeColumn& each : file_.mesh.attributes) {
      if (&each == &attribute) break;
      column.words_before += each.element == ElementKind::corner ? each.words() : 0;
    }
  column.attribute = &attribute;
  column.type = attribute.type.scalar == Scalar::boolean ? Scalar::uint8 : attribute.type.scalar;
  column.is_list = attribute.type.count != 1 || attribute.element == ElementKind::corner;
}

// Edges of the mesh and kept rows in the order in which the file had them, others behind. A kept row gives way to an
// edge that has come to lie there.
void PlyColumns::add_edge_rows(PlyTable& table, const PropertyTable* kept) const {
  const std::vector<ListedEdge>& edges = file_.mesh.edges;
  const Property* numbers = nullptr;
  for (std::size_t i = 0; kept && i < kept->properties.size(); ++i)
    if (kept->properties[i].role == PropertyRole::row) numbers = &kept->properties[i];
  const std::size_t rows = kept ? kept->rows : 0;
  std::set<std::pair<std::int64_t, std::int64_t>> added;
  for (const ListedEdge& e : edges)
    if (e.row == no_index) added.insert(std::minmax({std::int64_t{e.from}, std::int64_t{e.to}}));
  const auto add_kept = [&](std::size_t row) {
    std::vector<std::int64_t> ends;
    for (const Property& property : kept->properties)
      if (property.role == PropertyRole::vertex_number) ends.push_back(property.integer(row));
    if (!added.contains(std::minmax({ends[0], ends[1]})))
      table.edges.push_back({true, static_cast<std::uint32_t>(row)});
  };
  std::size_t row = 0;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (; row < rows && numbers->integer(row) < std::int64_t{edges[e].row}; ++row) add_kept(row);
    table.edges.push_back({false, e});
  }
  for (; row < rows; ++row) add_kept(row);
  table.rows = table.edges.size();
}

// The table of a kind, which is added where there is none; null where its name is that of something else.
PlyTable* PlyColumns::table_of(TableKind kind) {
  const auto found =
      std::find_if(tables_.begin(), tables_.end(), [&](const PlyTable& table) { return table.kind == kind; });
  if (found != tables_.end()) return &*found;
  const std::string_view name = kind == TableKind::edges ? "edge" : "face";
  if (std::any_of(tables_.begin(), tables_.end(), [&](const PlyTable& table) { return table.name == name; }))
    return nullptr;
  PlyTable& table = tables_.emplace_back(PlyTable{name, kind, file_.mesh.face_count(), {}, {}});
  if (kind != TableKind::edges) return &table;
  add_edge_rows(table, nullptr);
  for (const std::string_view end : {"vertex1", "vertex2"}) {
    PlyColumn& column = table.columns.emplace_back();
    column.name = end;
    column.type = Scalar::int32;
    column.role = PropertyRole::vertex_number;
    column.component = end == "vertex1" ? 0 : 1;
  }
  return &table;
}

// Attributes that the layout does not have.
void PlyColumns::add_attributes() {
  if (std::any_of(file_.mesh.edges.begin(), file_.mesh.edges.end(),
                  [](const ListedEdge& e) { return e.row != no_index; }))
    table_of(TableKind::edges);
  for (const AttributeColumn& attribute : file_.mesh.attributes) {
    if (has(attribute)) continue;
    const TableKind kind = attribute.element == ElementKind::vertex ? TableKind::vertices
                           : attribute.element == ElementKind::edge ? TableKind::edges
                                                                    : TableKind::faces;
    PlyTable* const table = table_of(kind);
    if (!table) continue;
    PlyColumn column;
    column.name = short_name(attribute);
    const auto has_name = [&](const PlyColumn& each) { return each.name == column.name; };
    if (attribute_of_property(kind, column.name) != attribute.name || has_meaning_in_ply(kind, column.name) ||
        std::any_of(table->columns.begin(), table->columns.end(), has_name))
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

const std::uint32_t* PlyColumns::corner_value(const PlyColumn& column, std::size_t face, std::size_t corner) const {
  const AttributeColumn& attribute = *column.attribute;
  const QuarantinedFace* const aside = quarantined(face);
  const std::size_t words = attribute.words();
  if (!aside) return attribute.data.data() + (file_.mesh.face_offsets[face] + corner) * words;
  const std::size_t at = column.words_before * aside->corners.size() + corner * words;
  return at + words <= aside->values.size() ? aside->values.data() + at : attribute.fill.data();
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
