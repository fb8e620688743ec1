#include "ryosen/io/ply_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>

#include "ryosen/geometry/single_precision.h"
#include "ryosen/indexed/indexed.h"
#include "ryosen/io/byte_colours.h"

namespace ryosen {
namespace {

bool type_holds(Scalar type, double value) {
  if (type == Scalar::float64) return true;
  if (type == Scalar::float32) {
    if (!std::isfinite(value)) return true;
    if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) return false;
    return static_cast<double>(static_cast<float>(value)) == value;
  }
  return with_scalar(type, [&](auto zero) {
    using Number = decltype(zero);
    constexpr double whole_limit = 9007199254740992.0;  // whole numbers below it are exact doubles
    if (!(std::abs(value) <= whole_limit) || std::trunc(value) != value || (value == 0 && std::signbit(value)))
      return false;
    const auto least = static_cast<double>(std::numeric_limits<Number>::lowest());
    const auto most = static_cast<double>(std::numeric_limits<Number>::max());
    return value >= least && value <= most;
  });
}

// Where reading makes floats, if it is how the float is printed: with its shortest digits.
bool is_shortest_of_single(double value) {
  if (type_holds(Scalar::float32, value)) return true;
  if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) return false;
  char text[32];
  const char* const end = std::to_chars(text, text + sizeof text, static_cast<float>(value)).ptr;
  double printed = 0;
  std::from_chars(text, end, printed);
  return printed == value;
}

// The scaled number that reading converts back to the same colour component, integral if possible.
double scaled_colour(double component, double scale) {
  if (scale == 1.0) return component;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double scaled = component * scale;
  for (const double candidate :
       {std::nearbyint(scaled), scaled, std::nextafter(scaled, infinity), std::nextafter(scaled, -infinity)})
    if (candidate / scale == component) return candidate;
  return scaled;
}

// A rounding of colours to bytes may go a little beyond black and white, as weighted means do.
bool rounds_to_byte(double component) {
  const double byte = std::nearbyint(component * 255.0);
  return byte >= 0 && byte <= 255;
}

bool is_colour(PropertyRole role) { return role == PropertyRole::vertex_colour || role == PropertyRole::face_colour; }

}  // namespace

int ply_face_colour_components(const FaceColours& colours) {
  int components = 0;
  for (const std::uint8_t count : colours.count) {
    if (count == 1 || (count != 0 && components != 0 && count != components)) return 0;
    if (count != 0) components = count;
  }
  return components;
}

std::uint64_t ply_rounded_colours(const MeshFile& file) {
  const auto is_byte_colour = [](const Property& p) { return is_colour(p.role) && p.type == Scalar::uint8; };
  const std::vector<PropertyTable>& layout = file.properties.tables;
  if (std::none_of(layout.begin(), layout.end(), [&](const PropertyTable& table) {
        return std::any_of(table.properties.begin(), table.properties.end(), is_byte_colour);
      }))
    return 0;
  const PlyColumns columns(file, Encoding::binary_little);
  std::uint64_t count = 0;
  for (const PlyTable& table : columns.tables()) {
    if (table.kind != TableKind::vertices && table.kind != TableKind::faces) continue;
    std::vector<const PlyColumn*> bytes;
    for (const PlyColumn& column : table.columns)
      if (is_colour(column.role) && column.type == Scalar::uint8 && column.is_of_layout) bytes.push_back(&column);
    for (std::size_t row = 0; row < table.rows && !bytes.empty(); ++row)
      count += std::any_of(bytes.begin(), bytes.end(),
                           [&](const PlyColumn* column) { return !byte_meant(columns.mesh_value(*column, row)); });
  }
  return count;
}

PlyColumns::PlyColumns(const MeshFile& file, Encoding encoding)
    : file_(file),
      normals_(per_vertex(file.mesh, file.mesh.normals)),
      texcoords_(per_vertex(file.mesh, file.mesh.texcoords)),
      face_colour_components_(ply_face_colour_components(file.mesh.face_colours)),
      has_decimals_(file.properties.has_decimal_reals),
      writes_decimals_(encoding == Encoding::ascii) {
  const IndexedMesh& mesh = file.mesh;
  if (!mesh.quarantine.empty()) {
    aside_.assign(mesh.face_count(), no_index);
    for (std::size_t i = 0; i < mesh.quarantine.size(); ++i)
      aside_[mesh.quarantine[i].face] = static_cast<std::uint32_t>(i);
  }
  add_layout();
  add_missing();
  add_attributes();
  for (PlyTable& table : tables_) {
    for (PlyColumn& column : table.columns) widen(table, column);
    using enum PropertyRole;
    for (const PropertyRole role : {position, normal, texcoord, vertex_colour, face_colour})
      widen_together(table, role);
  }
}

const QuarantinedFace* PlyColumns::quarantined(std::size_t face) const {
  if (aside_.empty() || aside_[face] == no_index) return nullptr;
  return &file_.mesh.quarantine[aside_[face]];
}

std::size_t PlyColumns::corner_count(std::size_t face) const {
  const QuarantinedFace* const aside = quarantined(face);
  return aside ? aside->corners.size() : file_.mesh.face(face).size();
}

bool PlyColumns::has_data(PropertyRole role, std::uint8_t component) const {
  switch (role) {
    case PropertyRole::normal:
      return normals_.has_value();
    case PropertyRole::texcoord:
      return texcoords_.has_value() && !has_corner_texcoords_;
    case PropertyRole::corner_texcoord:
      return has_corner_texcoords_;
    case PropertyRole::vertex_colour:
      return !file_.mesh.vertex_colours.empty() && component < file_.mesh.colour_components;
    case PropertyRole::face_colour:
      return component < face_colour_components_;
    default:
      return true;
  }
}

void PlyColumns::add_layout() {
  const CornerValues& texcoords = file_.mesh.texcoords;
  bool was_per_corner = false;
  for (const PropertyTable& table : file_.properties.tables)
    for (const Property& property : table.properties)
      was_per_corner = was_per_corner || property.role == PropertyRole::corner_texcoord;
  has_corner_texcoords_ = !texcoords.index.empty() && (was_per_corner || !texcoords_);
  for (const PropertyTable& table : file_.properties.tables) {
    PlyTable& out = tables_.emplace_back();
    out.name = table.name;
    out.kind = table.kind;
    out.rows = table.kind == TableKind::vertices ? file_.mesh.positions.size()
               : table.kind == TableKind::faces  ? file_.mesh.face_count()
                                                 : table.rows;
    if (table.kind == TableKind::edges) add_edge_rows(out, &table);
    for (const Property& property : table.properties) {
      const AttributeColumn* const attribute = attribute_of(table.kind, property);
      if (!has_data(property.role, property.component) || property.role == PropertyRole::row) continue;
      if (property.role == PropertyRole::attribute && !attribute) continue;  // it has been removed
      PlyColumn& column = out.columns.emplace_back(PlyColumn{property});
      if (attribute) set_attribute(column, *attribute);
      if (table.kind == TableKind::edges) column.kept = &property;
      column.is_of_layout = true;
      if (is_colour(property.role)) column.scale = colour_scale(property.type);
      if (property.is_kept()) column.kept = &property;
    }
  }
}

void PlyColumns::add_reals(PlyTable& table, PropertyRole role, std::initializer_list<std::string_view> names) {
  std::uint8_t component = 0;
  const auto first = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const PlyColumn& column) { return column.role == role; });
  const Scalar type = first != table.columns.end() ? first->type : is_colour(role) ? Scalar::uint8 : Scalar::float32;
  for (const std::string_view name : names) {
    const bool is_there = std::any_of(table.columns.begin(), table.columns.end(), [&](const PlyColumn& column) {
      return column.role == role && column.component == component;
    });
    if (!is_there && has_data(role, component)) {
      const auto last = std::find_if(table.columns.rbegin(), table.columns.rend(),
                                     [&](const PlyColumn& column) { return column.role == role; });
      const auto behind = last == table.columns.rend() ? table.columns.end() : last.base();
      PlyColumn& column = *table.columns.insert(behind, PlyColumn());
      column.name = name;
      column.type = type;
      column.role = role;
      column.component = component;
      if (is_colour(role)) column.scale = colour_scale(column.type);
    }
    ++component;
  }
}

void PlyColumns::add_missing() {
  const auto table_of = [&](TableKind kind, std::string_view name, std::size_t rows) -> PlyTable& {
    for (PlyTable& table : tables_)
      if (table.kind == kind) return table;
    // Vertices come first.
    return *tables_.insert(kind == TableKind::vertices ? tables_.begin() : tables_.end(),
                           PlyTable{name, kind, rows, {}, {}});
  };
  using enum PropertyRole;
  PlyTable& vertices = table_of(TableKind::vertices, "vertex", file_.mesh.positions.size());
  add_reals(vertices, position, {"x", "y", "z"});
  add_reals(vertices, normal, {"nx", "ny", "nz"});
  add_reals(vertices, texcoord, {"s", "t"});
  add_reals(vertices, vertex_colour, {"red", "green", "blue", "alpha"});
  // A file with only points gets no face element.
  const bool has_faces =
      std::any_of(tables_.begin(), tables_.end(), [](const PlyTable& table) { return table.kind == TableKind::faces; });
  if (file_.properties.has_layout() && !has_faces && file_.mesh.face_count() == 0) return;
  PlyTable& faces = table_of(TableKind::faces, "face", file_.mesh.face_count());
  const auto add_list = [&](PropertyRole role, std::string_view name, Scalar type) {
    const bool is_there = std::any_of(faces.columns.begin(), faces.columns.end(),
                                      [&](const PlyColumn& column) { return column.role == role; });
    if (is_there) return;
    PlyColumn column;
    column.name = name;
    column.type = type;
    column.is_list = true;
    column.role = role;
    faces.columns.insert(role == corners ? faces.columns.begin() : faces.columns.end(), column);
  };
  add_list(corners, "vertex_indices", Scalar::int32);
  if (has_corner_texcoords_) add_list(corner_texcoord, "texcoord", Scalar::float32);
  add_reals(faces, face_colour, {"red", "green", "blue", "alpha"});
}

double PlyColumns::mesh_value(const PlyColumn& column, std::size_t row) const {
  const IndexedMesh& mesh = file_.mesh;
  const int c = column.component;
  switch (column.role) {
    case PropertyRole::position:
      return mesh.positions[row][c];
    case PropertyRole::normal:
      return value_of(mesh.normals, (*normals_)[row])[c];
    case PropertyRole::texcoord:
      return value_of(mesh.texcoords, (*texcoords_)[row])[c];
    case PropertyRole::vertex_colour: {
      const glm::dvec4& colour = mesh.vertex_colours[row];
      return std::isnan(colour.x) ? 1.0 : colour[c];  // no colour: white
    }
    default:
      return mesh.face_colours.count[row] == 0 ? 1.0 : mesh.face_colours.values[row][c];
  }
}

double PlyColumns::value(const PlyColumn& column, std::size_t row) const {
  const double value = mesh_value(column, row);
  if (!is_colour(column.role)) return value;
  return column.type == Scalar::uint8 ? std::nearbyint(value * column.scale) : scaled_colour(value, column.scale);
}

const std::vector<glm::dvec3>& PlyColumns::corner_texcoords(std::size_t face) const {
  const CornerValues& texcoords = file_.mesh.texcoords;
  scratch_.clear();
  bool any = false;
  const auto add = [&](std::uint32_t index) {
    any = any || index != no_index;
    scratch_.push_back(value_of(texcoords, index));
  };
  if (const QuarantinedFace* const aside = quarantined(face)) {
    for (const std::uint32_t index : aside->texcoords) add(index);
  } else {
    for (std::size_t i = file_.mesh.face_offsets[face]; i < file_.mesh.face_offsets[face + 1]; ++i)
      add(texcoords.index[i]);
  }
  if (!any) scratch_.clear();
  return scratch_;
}

bool PlyColumns::holds_value(Scalar type, const PlyColumn& column, double value) const {
  if (type == Scalar::uint8 && is_colour(column.role))
    return column.is_of_layout ? rounds_to_byte(value) : byte_meant(value).has_value();
  if (type == Scalar::float32 && has_decimals_) {
    const bool stay_decimals = writes_decimals_ && column.role != PropertyRole::corner_texcoord;
    return stay_decimals ? is_decimal_of_single(value) : is_shortest_of_single(value);
  }
  return type_holds(type, is_colour(column.role) ? scaled_colour(value, colour_scale(type)) : value);
}

bool PlyColumns::holds(Scalar type, const PlyColumn& column, std::size_t rows) const {
  if (column.role == PropertyRole::corner_texcoord) {
    for (std::size_t row = 0; row < rows; ++row) {
      for (const glm::dvec3& value : corner_texcoords(row))
        if (!holds_value(type, column, value.x) || !holds_value(type, column, value.y)) return false;
    }
    return true;
  }
  for (std::size_t row = 0; row < rows; ++row)
    if (!holds_value(type, column, mesh_value(column, row))) return false;
  return true;
}

void PlyColumns::widen(const PlyTable& table, PlyColumn& column) {
  if (column.role == PropertyRole::vertex_number && table.kind == TableKind::edges) return widen_ends(column);
  if (column.is_list && (!column.kept || column.attribute)) {
    const bool is_of_element = column.attribute && column.attribute->element != ElementKind::corner;
    const std::size_t count = column.attribute ? column.attribute->type.count : 1;
    std::size_t longest = is_of_element ? count : 0;
    const std::size_t per_corner = column.role == PropertyRole::corner_texcoord ? 2 : count;
    for (std::size_t row = 0; row < table.rows && !is_of_element; ++row)
      longest = std::max(longest, per_corner * corner_count(row));
    for (const Scalar type : {column.count_type, Scalar::uint8, Scalar::uint16, Scalar::uint32}) {
      column.count_type = type;
      if (type_holds(type, static_cast<double>(longest))) break;
    }
  }
  if (column.role == PropertyRole::corners) return widen_corners(column);
  if (column.role != PropertyRole::corner_texcoord || holds(column.type, column, table.rows)) return;
  column.type = holds(Scalar::float32, column, table.rows) ? Scalar::float32 : Scalar::float64;
}

void PlyColumns::widen_together(PlyTable& table, PropertyRole role) {
  std::vector<PlyColumn*> columns;
  for (PlyColumn& column : table.columns)
    if (column.role == role) columns.push_back(&column);
  const auto keeps = [&](const PlyColumn* column) { return holds(column->type, *column, table.rows); };
  if (std::all_of(columns.begin(), columns.end(), keeps)) return;
  const bool are_singles = std::all_of(columns.begin(), columns.end(), [&](const PlyColumn* column) {
    return column->type != Scalar::float64 && holds(Scalar::float32, *column, table.rows);
  });
  for (PlyColumn* const column : columns) {
    column->type = are_singles ? Scalar::float32 : Scalar::float64;
    column->scale = 1.0;
  }
}

void PlyColumns::widen_corners(PlyColumn& column) {
  std::int64_t least = 0, most = 0;
  for (std::size_t face = 0; face < file_.mesh.face_count(); ++face) {
    for_each_corner(face, [&](std::int64_t corner) {
      least = std::min(least, corner);
      most = std::max(most, corner);
    });
  }
  // Numbers that fit no type are out of range anyway; the writer saturates them (a loss: Holds::wide_numbers).
  for (const Scalar type : {column.type, Scalar::int32, Scalar::uint32, Scalar::int32}) {
    column.type = type;
    if (type_holds(type, static_cast<double>(least)) && type_holds(type, static_cast<double>(most))) break;
  }
}

}  // namespace ryosen
