#include "ryosen/io/ply_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/io/ply_attributes.h"

namespace ryosen {
namespace {

// The number in place of -1 in an unsigned type, if no vertex has it.
std::int64_t end_of_strip(Scalar type, std::size_t vertices) {
  return with_scalar(type, [&](auto zero) -> std::int64_t {
    using Number = decltype(zero);
    if constexpr (std::is_unsigned_v<Number> && sizeof(Number) < 8) {
      constexpr auto last = std::int64_t{std::numeric_limits<Number>::max()};
      if (last >= static_cast<std::int64_t>(vertices)) return last;
    }
    return -1;
  });
}

// Adds the triangles of one strip. Corners that are no vertices are left to the faces to report.
void add_triangles(const Property& corners, std::size_t begin, std::size_t end, std::uint64_t line, FaceList& faces) {
  for (std::size_t i = begin; i + 2 < end; ++i) {
    const bool is_turned = (i - begin) % 2 == 1;
    const std::int64_t a = corners.integer(i + (is_turned ? 1 : 0)), b = corners.integer(i + (is_turned ? 0 : 1)),
                       c = corners.integer(i + 2);
    if (a == b || b == c || c == a) continue;
    for (const std::int64_t corner : {a, b, c}) faces.add_corner(corner);
    faces.end_face(line);
  }
}

void warn_of_short_strip(Reporter& reporter, FilePlace place, std::size_t vertices) {
  reporter.leave_out(&LeftOut::values);
  reporter.warn("face_too_few_corners", place, [&] {
    const bool one = vertices == 1;
    return Text{
        std::string("A strip of ") + (one ? "one vertex" : "two vertices") + " makes no triangle; it is left out.",
        "頂点が " + std::to_string(vertices) + " 個のストリップは三角形にならないため、無視しました。"};
  });
}

void warn_of_further_properties(Reporter& reporter, FilePlace place, std::size_t strips) {
  reporter.leave_out(&LeftOut::values, strips);
  reporter.warn("extra_values", place, [] {
    return Text{"The strips have more properties than their vertices; these are left out.",
                "ストリップに頂点以外のプロパティがあります。これらは無視しました。"};
  });
}

// The element that says the faces in place of strips.
PropertyTable face_table() {
  Property corners;
  corners.name = "vertex_indices";
  corners.type = Scalar::int32;
  corners.is_list = true;
  corners.role = PropertyRole::corners;
  return {"face", TableKind::faces, 0, {corners}};
}

// Everything that has one entry per face or corner, for faces that came later.
void extend_to_all_faces(MeshFile& file, std::size_t faces_before) {
  IndexedMesh& mesh = file.mesh;
  if (!mesh.texcoords.index.empty()) mesh.texcoords.index.resize(mesh.corners.size(), no_index);
  if (!mesh.face_colours.values.empty()) {
    mesh.face_colours.values.resize(mesh.face_count(), glm::dvec4(0.0));
    mesh.face_colours.count.resize(mesh.face_count(), 0);
  }
  std::vector<std::uint32_t> source(mesh.face_count(), no_index);
  std::iota(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(faces_before), 0);
  file.properties = with_faces_of(file.properties, source);
}

std::uint32_t swapped(std::uint32_t value) {
  return value >> 24 | (value >> 8 & 0xff00u) | (value << 8 & 0xff0000u) | value << 24;
}

template <class Vector>
PlyTarget component_of(std::vector<Vector>& values, std::size_t component, double divisor = 1.0) {
  constexpr std::size_t stride = sizeof(Vector) / sizeof(double);
  return {values.empty() ? nullptr : &values[0][static_cast<int>(component)], stride, divisor};
}

}  // namespace

const Property* strip_corners(const PropertyTable& table) {
  if (table.kind != TableKind::other || table.name != "tristrips") return nullptr;
  const auto found = std::find_if(table.properties.begin(), table.properties.end(), [](const Property& property) {
    return property.role == PropertyRole::vertex_number && property.is_list && !is_floating(property.type);
  });
  return found == table.properties.end() ? nullptr : &*found;
}

PlyBuilder::PlyBuilder(PlyHeader header)
    : attributes_(std::move(header.attributes)), faces_(file_.mesh), places_(header.tables.tables.size()) {
  file_.properties = std::move(header.tables);
  file_.head_comments = std::move(header.comments);
  file_.encoding = header.encoding;
  reporter_ = std::move(header.reporter);
}

PlyTarget PlyBuilder::target_of(const Property& property) {
  IndexedMesh& mesh = file_.mesh;
  switch (property.role) {
    case PropertyRole::position:
      return component_of(mesh.positions, property.component);
    case PropertyRole::normal:
      return component_of(mesh.normals.pool, property.component);
    case PropertyRole::texcoord:
      return component_of(mesh.texcoords.pool, property.component);
    case PropertyRole::vertex_colour:
      return component_of(mesh.vertex_colours, property.component, colour_scale(property.type));
    case PropertyRole::face_colour:
      return component_of(mesh.face_colours.values, property.component, colour_scale(property.type));
    default:
      return {};
  }
}

std::vector<PlyTarget> PlyBuilder::begin_table(std::size_t number, FilePlace place) {
  PropertyTable& table = tables()[number];
  IndexedMesh& mesh = file_.mesh;
  places_[number] = place;
  if (table.kind == TableKind::vertices) {
    reserve_large(mesh.positions, table.rows);
    if (mesh.positions.empty()) touch_pages(mesh.positions.data(), table.rows * sizeof(glm::dvec3));
    mesh.positions.resize(table.rows);
  }
  if (table.kind == TableKind::vertices && table.rows > 0) inform_of_missing_z(table, place);
  if (table.kind == TableKind::faces) reserve_large(mesh.face_offsets, table.rows + 1);
  for (const Property& property : table.properties) {
    if (property.role == PropertyRole::normal) mesh.normals.pool.resize(table.rows);
    if (property.role == PropertyRole::texcoord) mesh.texcoords.pool.resize(table.rows);
    if (property.role == PropertyRole::vertex_colour) {
      mesh.vertex_colours.resize(table.rows, glm::dvec4(0, 0, 0, 1));
      mesh.colour_components = std::max(mesh.colour_components, property.component + 1);
    }
    if (property.role == PropertyRole::face_colour) {
      mesh.face_colours.values.resize(table.rows, glm::dvec4(0.0));
      mesh.face_colours.count.assign(table.rows, static_cast<std::uint8_t>(property.component + 1));
      mesh.face_colours.are_bytes = colour_scale(property.type) == 255.0;
    }
  }
  std::vector<PlyTarget> targets;
  for (Property& property : table.properties) {
    targets.push_back(target_of(property));
    if (property.is_list && property.role != PropertyRole::corners) property.ends.reserve(table.rows);
    if (property.is_kept() && !property.is_list) property.data.reserve(table.rows * bytes_of(property.type));
  }
  return targets;
}

void PlyBuilder::inform_of_missing_z(const PropertyTable& table, FilePlace place) {
  const auto coordinates = std::count_if(table.properties.begin(), table.properties.end(),
                                         [](const Property& p) { return p.role == PropertyRole::position; });
  if (coordinates != 2) return;
  reporter_.inform(
      "points_without_z", place,
      {"The vertices have x and y and no z; it is 0.", "頂点に x と y はありますが z がないため、z を 0 としました。"});
}

void PlyBuilder::warn_non_finite(FilePlace place) { warn_of_non_finite_vertex(reporter_, place); }

void PlyBuilder::warn_rounded(FilePlace place) {
  reporter_.leave_out(&LeftOut::values);
  reporter_.warn("rounded_number", place, [] {
    return Text{"A whole number of a vertex or face has more than the 53 bits of a double; it is rounded.",
                "頂点または面の整数が倍精度の 53 ビットに収まらないため、丸めました。"};
  });
}

std::optional<Failure> PlyBuilder::take_strips() {
  const auto strips = std::find_if(tables().begin(), tables().end(), strip_corners);
  if (strips == tables().end()) return std::nullopt;
  const bool has_lines = file_.encoding == Encoding::ascii;
  const Property& corners = *strip_corners(*strips);
  const std::int64_t last = end_of_strip(corners.type, file_.mesh.positions.size());
  const std::size_t faces_before = file_.mesh.face_count();
  for (std::size_t row = 0; row < strips->rows; ++row) {
    const FilePlace place = has_lines ? FilePlace::at_line(strip_places_[row]) : FilePlace::at_byte(strip_places_[row]);
    const std::size_t end = corners.first_value(row) + corners.value_count(row);
    if (faces_.is_full(3 * corners.value_count(row))) return too_many_corners(place);
    for (std::size_t begin = corners.first_value(row), at = begin; at <= end; ++at) {
      if (at < end && corners.integer(at) != -1 && corners.integer(at) != last) continue;
      if (at - begin == 1 || at - begin == 2) warn_of_short_strip(reporter_, place, at - begin);
      add_triangles(corners, begin, at, has_lines ? strip_places_[row] : 0, faces_);
      begin = at + 1;
    }
  }
  if (strips->rows != 0 && strips->properties.size() > 1) {
    warn_of_further_properties(
        reporter_, has_lines ? FilePlace::at_line(strip_places_.front()) : FilePlace::at_byte(strip_places_.front()),
        strips->rows);
  }
  const bool has_faces = std::any_of(tables().begin(), tables().end(),
                                     [](const PropertyTable& table) { return table.kind == TableKind::faces; });
  if (has_faces || file_.mesh.face_count() == 0)
    tables().erase(strips);
  else
    *strips = face_table();
  extend_to_all_faces(file_, faces_before);
  return std::nullopt;
}

// If every list has two numbers per corner or is empty they become texture coordinates; else they are kept as lists.
void PlyBuilder::take_corner_texcoords() {
  IndexedMesh& mesh = file_.mesh;
  for (PropertyTable& table : tables()) {
    for (Property& property : table.properties) {
      if (property.role != PropertyRole::corner_texcoord) continue;
      bool fits = mesh.texcoords.pool.empty() && table.rows == mesh.face_count();
      bool any = false;
      for (std::size_t f = 0; fits && f < table.rows; ++f) {
        const std::size_t count = property.value_count(f);
        any = any || count != 0;
        fits = count == 0 || count == 2 * mesh.face(f).size();
      }
      if (!fits || !any) {
        property.role = PropertyRole::extra;
        continue;
      }
      CornerValues& texcoords = mesh.texcoords;
      texcoords.components = 2;
      texcoords.index.reserve(mesh.corners.size());
      for (std::size_t f = 0; f < table.rows; ++f) {
        const std::size_t first = property.first_value(f), count = property.value_count(f);
        for (std::size_t i = 0; i < mesh.face(f).size(); ++i) {
          texcoords.index.push_back(count == 0 ? no_index : static_cast<std::uint32_t>(texcoords.pool.size()));
          if (count == 0) continue;
          texcoords.pool.emplace_back(property.real(first + 2 * i), property.real(first + 2 * i + 1), 0.0);
        }
      }
      release(property.data);
      release(property.ends);
    }
  }
}

// Whether no face references existing vertices, but all would with swapped bytes.
bool PlyBuilder::has_other_byte_order() const {
  const IndexedMesh& mesh = file_.mesh;
  if (file_.encoding == Encoding::ascii || mesh.quarantine.empty()) return false;
  if (mesh.quarantine.size() != mesh.face_count()) return false;
  return std::all_of(mesh.quarantine.begin(), mesh.quarantine.end(), [&](const QuarantinedFace& face) {
    return face.code == "index_out_of_range" &&
           std::all_of(face.corners.begin(), face.corners.end(), [&](std::int64_t corner) {
             return swapped(static_cast<std::uint32_t>(corner)) < mesh.positions.size();
           });
  });
}

// Lists of vertices in elements with other names may be meant as faces.
void PlyBuilder::warn_of_kept_lists() {
  for (std::size_t t = 0; t < tables().size(); ++t) {
    const PropertyTable& table = tables()[t];
    const bool has_list = std::any_of(table.properties.begin(), table.properties.end(), [](const Property& property) {
      return property.is_list && property.role == PropertyRole::vertex_number;
    });
    const bool are_lists = table.kind == TableKind::other && (has_list || table.name == "tristrips");
    if (!are_lists || table.rows == 0 || strip_corners(table)) continue;
    reporter_.warn("tristrips_kept", places_[t], [&] {
      return Text{
          "The rows of the element " + shown(table.name) + " are not read as faces; they are kept and written back.",
          "要素 " + shown(table.name) + " の行は面として読みません。そのまま保持して書き戻します。"};
    });
  }
}

// Text may have other numbers than bytes where it announces them; such colours are reals.
void PlyBuilder::widen_odd_colours() {
  const auto is_byte = [](double value) { return std::nearbyint(value * 255.0) / 255.0 == value; };
  for (PropertyTable& table : tables())
    for (const PropertyRole role : {PropertyRole::vertex_colour, PropertyRole::face_colour}) {
      bool are_bytes = true;
      for (const Property& property : table.properties) {
        if (property.role != role || property.type != Scalar::uint8) continue;
        const PlyTarget target = target_of(property);
        for (std::size_t row = 0; are_bytes && row < table.rows; ++row)
          are_bytes = is_byte(target.first[row * target.stride]);
      }
      for (Property& property : table.properties)
        if (!are_bytes && property.role == role) property.type = Scalar::float64;
    }
}

FilePlace PlyBuilder::place_of_faces() const {
  const std::vector<PropertyTable>& all = file_.properties.tables;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].rows != 0 && (all[i].kind == TableKind::faces || strip_corners(all[i]))) return places_[i];
  return {};
}

Result<MeshFile> PlyBuilder::finish() {
  IndexedMesh& mesh = file_.mesh;
  const FilePlace first_face = place_of_faces();
  warn_of_kept_lists();
  if (file_.encoding == Encoding::ascii) widen_odd_colours();
  take_corner_texcoords();
  if (std::optional<Failure> failure = take_strips()) return std::move(*failure);
  faces_.finish(reporter_);
  if (has_other_byte_order()) {
    return malformed("wrong_byte_order",
                     {"No face names vertices that exist; with their bytes the other way round all would. The byte "
                      "order is not the one that the header says.",
                      "どの面も存在しない頂点を参照しています。バイト順を逆にするとすべて正しくなるため、"
                      "ヘッダーのバイト順が誤っています。"},
                     first_face);
  }
  take_attributes(file_, std::move(attributes_));
  if (!mesh.normals.pool.empty()) mesh.normals.index = mesh.corners;
  if (!mesh.texcoords.pool.empty() && mesh.texcoords.index.empty()) {
    mesh.texcoords.index = mesh.corners;
    mesh.texcoords.components = 2;
  }
  return finished(file_, reporter_);
}

}  // namespace ryosen
