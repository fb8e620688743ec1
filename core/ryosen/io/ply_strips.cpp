#include "ryosen/io/ply_strips.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace ryosen {
namespace {

// The number in place of -1 in an unsigned type, if no vertex has it.
std::int64_t end_of_strip(NumberType type, std::size_t vertices) {
  return with_number_type(type, [&](auto zero) -> std::int64_t {
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
  corners.type = NumberType::i32;
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

}  // namespace

const Property* strip_corners(const PropertyTable& table) {
  if (table.kind != TableKind::other || table.name != "tristrips") return nullptr;
  const auto found = std::find_if(table.properties.begin(), table.properties.end(), [](const Property& property) {
    return property.role == PropertyRole::vertex_number && property.is_list && !is_real(property.type);
  });
  return found == table.properties.end() ? nullptr : &*found;
}

std::optional<Failure> take_strips(MeshFile& file, FaceList& faces, std::span<const std::uint64_t> places,
                                   Reporter& reporter) {
  std::vector<PropertyTable>& tables = file.properties.tables;
  const auto strips = std::find_if(tables.begin(), tables.end(), strip_corners);
  if (strips == tables.end()) return std::nullopt;
  const bool has_lines = file.encoding == Encoding::ascii;
  const Property& corners = *strip_corners(*strips);
  const std::int64_t last = end_of_strip(corners.type, file.mesh.positions.size());
  const std::size_t faces_before = file.mesh.face_count();
  for (std::size_t row = 0; row < strips->rows; ++row) {
    const FilePlace place = has_lines ? FilePlace::at_line(places[row]) : FilePlace::at_byte(places[row]);
    const std::size_t end = corners.first_value(row) + corners.value_count(row);
    if (faces.is_full(3 * corners.value_count(row))) return too_many_corners(place);
    for (std::size_t begin = corners.first_value(row), at = begin; at <= end; ++at) {
      if (at < end && corners.integer(at) != -1 && corners.integer(at) != last) continue;
      if (at - begin == 1 || at - begin == 2) warn_of_short_strip(reporter, place, at - begin);
      add_triangles(corners, begin, at, has_lines ? places[row] : 0, faces);
      begin = at + 1;
    }
  }
  if (strips->rows != 0 && strips->properties.size() > 1) {
    warn_of_further_properties(
        reporter, has_lines ? FilePlace::at_line(places.front()) : FilePlace::at_byte(places.front()), strips->rows);
  }
  const bool has_faces = std::any_of(tables.begin(), tables.end(),
                                     [](const PropertyTable& table) { return table.kind == TableKind::faces; });
  if (has_faces || file.mesh.face_count() == 0)
    tables.erase(strips);
  else
    *strips = face_table();
  extend_to_all_faces(file, faces_before);
  return std::nullopt;
}

}  // namespace ryosen
