#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "ryosen/io/byte_colours.h"
#include "ryosen/io/obj.h"
#include "ryosen/io/text_lines.h"
#include "ryosen/io/text_out.h"

namespace ryosen {
namespace {

// A text at the end of a line. A final backslash would continue the line, so a space is appended.
std::string line_end_text(std::string_view text) {
  std::string out = on_one_line(trimmed(text));
  if (!out.empty() && out.back() == '\\') out += ' ';
  return out;
}

// Writes the lines that change one kind of name (o, g, usemtl, s). Names first occur in table order, if necessary in a
// line that the next one overrides, so that reading restores the same table.
class NameWriter {
 public:
  NameWriter(TextOut& out, std::string_view keyword, std::string_view none, const FaceNames& names)
      : out_(out), keyword_(keyword), none_(none), names_(names) {}

  std::uint32_t of_face(std::size_t face) const { return face < names_.index.size() ? names_.index[face] : no_index; }
  void change_to(std::uint32_t index) {
    if (index >= names_.names.size()) index = no_index;
    if (index == current_) return;
    current_ = index;
    if (index == no_index)
      out_ << keyword_ << none_ << '\n';
    else if (index < written_)
      write(index);
    else
      write_up_to(index + std::size_t{1});
  }
  void finish() { write_up_to(names_.names.size()); }

 private:
  void write(std::size_t index) { out_ << keyword_ << ' ' << line_end_text(names_.names[index]) << '\n'; }
  void write_up_to(std::size_t end) {
    for (; written_ < end; ++written_) write(written_);
  }

  TextOut& out_;
  std::string_view keyword_, none_;
  const FaceNames& names_;
  std::size_t written_ = 0;  // names below this have been written
  std::uint32_t current_ = no_index;
};

// Whether the file had its colours as bytes in this format, and they still are and are read as such.
bool writes_bytes(const MeshFile& file) {
  const std::vector<glm::dvec4>& colours = file.mesh.vertex_colours;
  const int components = file.mesh.colour_components;
  if (!file.byte_colours || !file.format || file.format->id != "obj" || components < 3) return false;
  bool is_large = false;
  for (const glm::dvec4& colour : colours)
    for (int i = 0; i < components && !std::isnan(colour.x); ++i) {
      const double byte = as_byte(colour[i]);
      if (!(byte >= 0 && byte <= byte_scale && std::trunc(byte) == byte)) return false;
      is_large = is_large || (byte > 1 && (components == 3 || i == 3));
    }
  return is_large;
}

class ObjWriter {
 public:
  explicit ObjWriter(const MeshFile& file)
      : file_(file),
        mesh_(file.mesh),
        are_bytes_(writes_bytes(file)),
        out_(64 * mesh_.positions.size() + 16 * mesh_.corners.size()),
        objects_(out_, "o", "", mesh_.objects),
        groups_(out_, "g", "", mesh_.groups),
        materials_(out_, "usemtl", "", mesh_.materials),
        smoothing_(out_, "s", " off", mesh_.smoothing) {}

  std::string write() {
    head();
    vertices();
    pool("vt", mesh_.texcoords);
    pool("vn", mesh_.normals);
    faces_and_elements();
    for (NameWriter* names : all_names()) names->finish();
    if (out_.is_empty()) out_ << "# no vertices\n";  // an empty file would be refused
    return out_.take();
  }

 private:
  std::array<NameWriter*, 4> all_names() { return {&objects_, &groups_, &materials_, &smoothing_}; }

  void head() {
    for (const std::string& comment : file_.head_comments) {
      if (!comment.starts_with('#')) out_ << "# ";
      out_ << on_one_line(comment) << '\n';
    }
    for (const std::string& library : file_.material_libraries) out_ << "mtllib " << line_end_text(library) << '\n';
  }

  void vertices() {
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const glm::dvec3& p = mesh_.positions[v];
      out_ << "v " << p.x << ' ' << p.y << ' ' << p.z;
      if (v < mesh_.vertex_colours.size() && !std::isnan(mesh_.vertex_colours[v].x)) {
        const glm::dvec4& colour = mesh_.vertex_colours[v];
        for (int i = 0; i < 3; ++i) out_ << ' ' << (are_bytes_ ? as_byte(colour[i]) : colour[i]);
        if (mesh_.colour_components == 4) out_ << ' ' << (are_bytes_ ? as_byte(colour.w) : colour.w);
      } else if (v < mesh_.vertex_weights.size() && !std::isnan(mesh_.vertex_weights[v])) {
        out_ << ' ' << mesh_.vertex_weights[v];
      }
      out_ << '\n';
    }
  }

  void pool(std::string_view keyword, const CornerValues& values) {
    for (const glm::dvec3& value : values.pool) {
      out_ << keyword;
      for (int i = 0; i < values.components; ++i) out_ << ' ' << value[i];
      out_ << '\n';
    }
  }

  // Writes an OBJ index. Out-of-range numbers stay out of range: 0 for -1, a relative index before the first vertex
  // below that, and the largest number (overflow) unchanged.
  void vertex_index(std::int64_t vertex) {
    if (vertex >= 0) {
      out_ << (vertex == INT64_MAX ? vertex : vertex + 1);
    } else if (vertex == -1) {
      out_ << '0';
    } else {
      const auto count = static_cast<std::int64_t>(mesh_.positions.size());
      out_ << std::max(vertex, obj_least_vertex) - count;
    }
  }

  void corner(std::int64_t vertex, std::uint32_t texcoord, std::uint32_t normal) {
    out_ << ' ';
    vertex_index(vertex);
    if (texcoord == no_index && normal == no_index) return;
    out_ << '/';
    if (texcoord != no_index) out_ << std::uint64_t{texcoord} + 1;
    if (normal != no_index) out_ << '/' << std::uint64_t{normal} + 1;
  }

  // A line with the corners from begin to end of these lists, of which all but the vertices may end early.
  template <class Vertices>
  void line(char keyword, const Vertices& vertices, std::size_t begin, std::size_t end,
            std::span<const std::uint32_t> texcoords, std::span<const std::uint32_t> normals) {
    out_ << keyword;
    for (std::size_t i = begin; i < end; ++i)
      corner(vertices[i], i < texcoords.size() ? texcoords[i] : no_index, i < normals.size() ? normals[i] : no_index);
    out_ << '\n';
  }

  void face(std::size_t number) {
    line('f', mesh_.corners, mesh_.face_offsets[number], mesh_.face_offsets[number + 1], mesh_.texcoords.index,
         mesh_.normals.index);
  }

  void quarantined_face(const QuarantinedFace& face) {
    line('f', face.corners, 0, face.corners.size(), face.texcoords, face.normals);
  }

  void element(const LineElement& item) {
    const std::uint32_t names[] = {item.object, item.group, item.material, item.smoothing};
    for (std::size_t i = 0; i < 4; ++i) all_names()[i]->change_to(names[i]);
    const ElementList& elements = file_.elements;
    line(item.is_points ? 'p' : 'l', elements.vertices, item.first, item.first + item.count, elements.texcoords, {});
  }

  void faces_and_elements() {
    const std::vector<LineElement>& items = file_.elements.items;
    auto item = items.begin();
    auto aside = mesh_.quarantine.begin();
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      for (; item != items.end() && item->before_face <= f; ++item) element(*item);
      for (NameWriter* names : all_names()) names->change_to(names->of_face(f));
      if (aside != mesh_.quarantine.end() && aside->face == f)
        quarantined_face(*aside++);
      else
        face(f);
    }
    for (; item != items.end(); ++item) element(*item);
    wires();
  }

  // Wires belong to no object or group.
  void wires() {
    if (file_.wires.empty()) return;
    for (NameWriter* names : all_names()) names->change_to(no_index);
    for (const auto& [a, b] : file_.wires) line('l', std::array{a, b}, 0, 2, {}, {});
  }

  const MeshFile& file_;
  const IndexedMesh& mesh_;
  const bool are_bytes_;  // colours
  TextOut out_;
  NameWriter objects_, groups_, materials_, smoothing_;
};

}  // namespace

std::string write_obj(const MeshFile& file) { return ObjWriter(file).write(); }

}  // namespace ryosen
