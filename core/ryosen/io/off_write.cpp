#include <algorithm>
#include <cmath>

#include "ryosen/indexed/indexed.h"
#include "ryosen/io/byte_colours.h"
#include "ryosen/io/off.h"
#include "ryosen/io/off_builder.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/text_out.h"

namespace ryosen {
namespace {

class OffWriter {
 public:
  explicit OffWriter(const MeshFile& file)
      : file_(file),
        mesh_(file.mesh),
        are_bytes_(are_byte_colours(file)),
        normals_(per_vertex(mesh_, mesh_.normals)),
        texcoords_(per_vertex(mesh_, mesh_.texcoords)),
        out_(64 * mesh_.positions.size() + 10 * mesh_.corners.size()) {
    are_bytes_ = are_bytes_ || would_be_taken_for_normals();
  }

  std::string write() {
    head();
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) vertex(v);
    const auto face = [&](std::size_t f, const auto& corners) {
      out_ << corners.size();
      for (const auto corner : corners) out_ << ' ' << corner;
      face_colour(f);
      out_ << '\n';
    };
    for_each_face(mesh_, face, [&](const QuarantinedFace& aside) { face(aside.face, aside.corners); });
    return out_.take();
  }

 private:
  void head() {
    if (texcoords_) out_ << "ST";
    if (!mesh_.vertex_colours.empty()) out_ << 'C';
    if (normals_) out_ << 'N';
    out_ << "OFF\n";
    for (const std::string& comment : file_.head_comments) {
      if (!comment.starts_with('#')) out_ << "# ";
      out_ << on_one_line(comment) << '\n';
    }
    out_ << mesh_.positions.size() << ' ' << mesh_.face_count() << " 0\n";
  }

  void reals(const glm::dvec3& value, int count) {
    for (int i = 0; i < count; ++i) out_ << ' ' << value[i];
  }

  void colour(const glm::dvec4& value) {
    if (std::isnan(value.x)) return;
    const int count = mesh_.colour_components == 4 ? 4 : 3;
    for (int i = 0; i < count; ++i) {
      out_ << ' ';
      if (are_bytes_)
        out_ << as_byte(value[i]);
      else
        out_.put_real(value[i]);
    }
  }

  // Whether reading would take colours for normals. As bytes they are too long for that.
  bool would_be_taken_for_normals() const {
    if (!normals_ || mesh_.vertex_colours.empty()) return false;
    OffOrder order;
    for (std::size_t v = 0; v < mesh_.vertex_colours.size(); ++v) {
      const glm::dvec3 normal = value_of(mesh_.normals, (*normals_)[v]);
      const glm::dvec4& colour = mesh_.vertex_colours[v];
      const double numbers[] = {normal.x, normal.y, normal.z, colour.x, colour.y, colour.z, colour.w};
      if (!std::isnan(colour.x)) order.add(numbers, mesh_.colour_components == 4 ? 4 : 3);
    }
    return order.is_colours_first();
  }

  void vertex(std::size_t v) {
    const glm::dvec3& p = mesh_.positions[v];
    out_ << p.x << ' ' << p.y << ' ' << p.z;
    if (normals_) reals(value_of(mesh_.normals, (*normals_)[v]), 3);
    if (v < mesh_.vertex_colours.size()) colour(mesh_.vertex_colours[v]);
    if (texcoords_) reals(value_of(mesh_.texcoords, (*texcoords_)[v]), 2);
    out_ << '\n';
  }

  void face_colour(std::size_t face) {
    const FaceColours& colours = mesh_.face_colours;
    if (face >= colours.count.size()) return;
    const int count = colours.count[face];
    if (count == 0) return;
    if (count == 1) {
      out_ << ' ' << colours.values[face].x;
      return;
    }
    const ColourForm form = form_of_face_colour(colours, face);
    for (int i = 0; i < count; ++i) {
      const double value = colours.values[face][i];
      out_ << ' ';
      if (form == ColourForm::bytes)
        out_ << static_cast<std::int64_t>(as_byte(value));
      else if (form == ColourForm::large_bytes)
        out_ << as_byte(value);
      else
        out_.put_real(value);
    }
  }

  const MeshFile& file_;
  const IndexedMesh& mesh_;
  bool are_bytes_;
  std::optional<std::vector<std::uint32_t>> normals_, texcoords_;
  TextOut out_;
};

}  // namespace

std::string write_off(const MeshFile& file) { return OffWriter(file).write(); }

}  // namespace ryosen
