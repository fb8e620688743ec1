#include "ryosen/io/off_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/io/byte_colours.h"

namespace ryosen {

void OffBuilder::reserve(std::size_t vertices, std::size_t faces) {
  file_.mesh.positions.reserve(vertices);
  file_.mesh.face_offsets.reserve(faces + 1);
  file_.mesh.face_lines.reserve(faces);
}

bool OffBuilder::add_vertex(const double* values, std::size_t count, std::uint64_t line) {
  IndexedMesh& mesh = file_.mesh;
  const std::size_t before = numbers_before_colour(), after = numbers_after_colour();
  mesh.positions.emplace_back(values[0], values[1], values[2]);
  if (line != 0) mesh.vertex_lines.add(line);
  if (kind_.has_normals) mesh.normals.pool.emplace_back(values[3], values[4], values[5]);
  std::size_t colours = count - before - after;
  const bool has_meaning = kind_.has_colours ? colours == 0 || colours == 3 || colours == 4 : colours == 0;
  if (!has_meaning) colours = 0;
  if (kind_.has_colours) add_colour(values + before, colours);
  if (kind_.has_colours && kind_.has_normals && colours != 0) order_.add(values + 3, colours);
  // If there are values without a meaning in between, the texture coordinates are those after the normal.
  const double* const texcoord = values + before + colours;
  if (kind_.has_texcoords) mesh.texcoords.pool.emplace_back(texcoord[0], texcoord[1], 0.0);
  return has_meaning;
}

void OffBuilder::add_colour(const double* values, std::size_t count) {
  IndexedMesh& mesh = file_.mesh;
  const bool is_absent = count == 0 || std::isnan(values[0]);
  if (count == 4 && !is_absent) mesh.colour_components = 4;
  if (is_absent)
    mesh.vertex_colours.emplace_back(no_colour, no_colour, no_colour, 1.0);
  else
    mesh.vertex_colours.emplace_back(values[0], values[1], values[2], count == 4 ? values[3] : no_colour);
}

bool OffBuilder::end_face(std::uint64_t line, const double* colour, std::size_t count, bool are_whole) {
  FaceColours& colours = file_.mesh.face_colours;
  const std::size_t face = file_.mesh.face_count();
  faces_.end_face(line);
  const bool has_meaning = count <= 4 && count != 2;
  if (!has_meaning) count = 0;
  if (count == 0 && colours.values.empty()) return has_meaning;
  colours.values.resize(face + 1, glm::dvec4(0.0));
  colours.count.resize(face + 1, 0);
  const bool are_bytes =
      count >= 3 && (are_whole || std::any_of(colour, colour + count, [](double number) { return number > 1; }));
  colours.are_bytes = colours.are_bytes || are_bytes;
  for (std::size_t i = 0; i < count; ++i)
    colours.values[face][static_cast<int>(i)] = are_bytes ? colour[i] / byte_scale : colour[i];
  colours.count[face] = static_cast<std::uint8_t>(count);
  return has_meaning;
}

// Shares the numbers of normal and colour out anew.
void OffBuilder::put_colours_first() {
  IndexedMesh& mesh = file_.mesh;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    glm::dvec3& normal = mesh.normals.pool[v];
    glm::dvec4& colour = mesh.vertex_colours[v];
    if (std::isnan(colour.x)) continue;
    const glm::dvec3 first = normal;
    const bool has_alpha = !std::isnan(colour.w);
    normal = has_alpha ? glm::dvec3(colour.y, colour.z, colour.w) : glm::dvec3(colour);
    colour = glm::dvec4(first, has_alpha ? colour.x : no_colour);
  }
  reporter_.warn("content_mismatch", FilePlace::at_line(mesh.vertex_lines.line(0)), [] {
    return Text{
        "The numbers of a vertex are read as place, colour, normal: in the order of the format, place, normal, colour, "
        "normals would not have the length 1, or colours would be out of range.",
        "頂点の数を座標、色、法線の順に読みました。形式どおりの座標、法線、色の順では、法線の長さが 1 でないか、"
        "色が範囲を外れるためです。"};
  });
}

// If any vertex colour value exceeds 1, all range over 0..255.
void OffBuilder::scale_byte_colours() {
  std::vector<glm::dvec4>& colours = file_.mesh.vertex_colours;
  const auto is_large = [](const glm::dvec4& c) { return c.x > 1 || c.y > 1 || c.z > 1 || c.w > 1; };
  file_.byte_colours = std::any_of(colours.begin(), colours.end(), is_large);
  for (glm::dvec4& colour : colours) {
    if (file_.byte_colours) colour /= byte_scale;
    if (std::isnan(colour.w)) colour.w = 1.0;
  }
}

MeshFile OffBuilder::finish() {
  IndexedMesh& mesh = file_.mesh;
  faces_.finish(reporter_);
  if (order_.is_colours_first()) put_colours_first();
  if (kind_.has_normals) mesh.normals.index = mesh.corners;
  if (!mesh.texcoords.pool.empty()) {
    mesh.texcoords.index = mesh.corners;
    mesh.texcoords.components = 2;
  }
  scale_byte_colours();
  return finished(file_, reporter_);
}

}  // namespace ryosen
