#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "ryosen/geometry/single_precision.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/losses.h"
#include "ryosen/io/stl.h"
#include "ryosen/io/text_lines.h"
#include "ryosen/io/text_out.h"
#include "ryosen/io/triangulated.h"
#include "ryosen/mesh/attribute.h"

namespace ryosen {
namespace {

// Unit length, or zero if undefined.
glm::dvec3 facet_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return length > 0 && std::isfinite(length) ? normal / length : glm::dvec3(0.0);
}

// The faces that an STL file can hold: those of the mesh, and quarantined ones whose corners exist and whose number is
// allowed by `is_free`.
template <class Visit>
void for_each_facet(const IndexedMesh& mesh, bool is_free, Visit visit) {
  std::vector<std::uint32_t> corners;
  for_each_face(mesh, visit, [&](const QuarantinedFace& face) {
    if (!face.has_corners_within(mesh.positions.size()) || (face.corners.size() != 3 && !is_free)) return;
    corners.assign(face.corners.begin(), face.corners.end());
    visit(face.face, std::span<const std::uint32_t>(corners));
  });
}

class StlTextWriter {
 public:
  explicit StlTextWriter(const MeshFile& file) : mesh_(file.mesh), is_free_(file.has_free_facets) {}

  std::string write() {
    for_each_facet(mesh_, is_free_, [&](std::size_t face, std::span<const std::uint32_t> corners) {
      begin_solid_of(face);
      facet(corners);
    });
    while (next_solid_ < mesh_.groups.names.size()) begin_solid(mesh_.groups.names[next_solid_++]);
    if (!is_open_) begin_solid("");
    end_solid();
    return out_.take();
  }

 private:
  // Solids follow the groups in face order; a group without faces is written before the next one.
  void begin_solid_of(std::size_t face) {
    const FaceNames& groups = mesh_.groups;
    const std::uint32_t group = face < groups.index.size() ? groups.index[face] : no_index;
    if (is_open_ && group == current_) return;
    current_ = group;
    while (group != no_index && next_solid_ < group) begin_solid(groups.names[next_solid_++]);
    begin_solid(group < groups.names.size() ? groups.names[group] : std::string_view());
    if (group == next_solid_) ++next_solid_;
  }

  void begin_solid(std::string_view name) {
    end_solid();
    name_ = on_one_line(trimmed(name));
    is_open_ = true;
    out_ << "solid";
    if (!name_.empty()) out_ << ' ' << name_;
    out_ << '\n';
  }
  void end_solid() {
    if (!is_open_) return;
    out_ << "endsolid";
    if (!name_.empty()) out_ << ' ' << name_;
    out_ << '\n';
    is_open_ = false;
  }

  void numbers(const glm::dvec3& p) { out_ << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n'; }

  void facet(std::span<const std::uint32_t> corners) {
    const auto place = [&](std::size_t i) { return mesh_.positions[corners[i]]; };
    out_ << "facet normal";
    numbers(corners.size() < 3 ? glm::dvec3(0.0) : facet_normal(place(0), place(1), place(2)));
    out_ << " outer loop\n";
    for (std::size_t i = 0; i < corners.size(); ++i) {
      out_ << "  vertex";
      numbers(place(i));
    }
    out_ << " endloop\nendfacet\n";
  }

  const IndexedMesh& mesh_;
  bool is_free_;
  TextOut out_;
  std::string name_;
  bool is_open_ = false;
  std::size_t next_solid_ = 0;  // groups below this have been written
  std::uint32_t current_ = no_index;
};

template <class Number>
void put_little(TextOut& out, Number number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof bytes);
  out << std::string_view(bytes, sizeof bytes);
}

const AttributeColumn* find_attributes(const MeshFile& file) {
  for (const AttributeColumn& column : file.mesh.attributes)
    if (column.name == facet_attribute && column.type == value_type<std::uint16_t>) return &column;
  return nullptr;
}

std::string write_binary(const MeshFile& file) {
  const IndexedMesh& mesh = file.mesh;
  std::uint32_t count = 0;
  for_each_facet(mesh, false, [&](std::size_t, std::span<const std::uint32_t>) { ++count; });
  TextOut out(stl_head_bytes + 4 + std::size_t{stl_facet_bytes} * count);
  out << stl_head(file);
  put_little(out, count);
  const AttributeColumn* const attributes = find_attributes(file);
  const auto put = [&](const glm::dvec3& p) {
    for (int i = 0; i < 3; ++i) put_little(out, static_cast<float>(p[i]));
  };
  for_each_facet(mesh, false, [&](std::size_t face, std::span<const std::uint32_t> corners) {
    // The normal is that of the places as they are written, so that a file read and written again is the same.
    const auto place = [&](std::size_t i) { return to_single(mesh.positions[corners[i]]); };
    const glm::dvec3 a = place(0), b = place(1), c = place(2);
    for (const glm::dvec3& p : {facet_normal(a, b, c), a, b, c}) put(p);
    put_little(out, attributes ? attribute_value<std::uint16_t>(*attributes, static_cast<std::uint32_t>(face))
                               : std::uint16_t{0});
  });
  return out.take();
}

bool is_blank_head(std::string_view head) {
  return head.find_first_not_of(std::string_view("\0 ", 2)) == std::string_view::npos;
}

}  // namespace

std::string stl_head(const MeshFile& file) {
  if (!file.stl_head.empty() && (is_blank_head(file.stl_head) || may_head_stl(file.stl_head))) return file.stl_head;
  std::string head(stl_plain_head);
  if (!file.head_comments.empty() && may_head_stl(file.head_comments[0])) head = file.head_comments[0];
  head.resize(stl_head_bytes, '\0');
  return head;
}

bool has_wordless_head(const MeshFile& file) {
  if (!file.head_comments.empty() || is_blank_head(file.stl_head)) return false;
  std::string_view text = file.stl_head;
  text = text.substr(0, text.find_last_not_of(std::string_view("\0 ", 2)) + 1);
  return text != stl_plain_head;
}

bool may_head_stl(std::string_view comment) {
  if (comment.size() > stl_head_bytes) return false;
  std::string empty(comment);
  empty.resize(stl_head_bytes + 4, '\0');
  const Result<const Format*> format = recognise(empty, {});
  return format.ok() && format.value()->read == read_stl;
}

std::string write_stl(const MeshFile& file, Encoding encoding) {
  const bool is_text = encoding == Encoding::ascii;
  if (!(is_text && file.has_free_facets) && has_polygons(file.mesh)) return write_stl(triangulated(file), encoding);
  return is_text ? StlTextWriter(file).write() : write_binary(file);
}

}  // namespace ryosen
