#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/off.h"
#include "core/io/reporter.h"
#include "core/io/text_out.h"

namespace ryosen {
namespace {

// The place in the pool for each vertex if all corners of a vertex have the same value; none if some differ, if corners
// lack a value, or if no vertex has one. A vertex without a face takes the entry of its own number when the
// pool has one entry per vertex, as readers of values per vertex make it.
std::optional<std::vector<std::uint32_t>> per_vertex(const IndexedMesh& mesh, const CornerValues& values) {
  if (values.pool.empty() || values.index.size() != mesh.corners.size()) return std::nullopt;
  const std::size_t count = mesh.positions.size();
  std::vector<std::uint32_t> out(count, no_index);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const std::uint32_t index = values.index[i];
    if (index >= values.pool.size()) return std::nullopt;
    std::uint32_t& known = out[mesh.corners[i]];
    if (known == no_index) known = index;
    if (known != index && values.pool[known] != values.pool[index]) return std::nullopt;
  }
  for (std::size_t v = 0; v < count; ++v) {
    if (out[v] == no_index && values.pool.size() == count) out[v] = static_cast<std::uint32_t>(v);
  }
  if (std::all_of(out.begin(), out.end(), [](std::uint32_t index) { return index == no_index; })) return std::nullopt;
  return out;
}

glm::dvec3 value_of(const CornerValues& values, std::uint32_t index) {
  return index < values.pool.size() ? values.pool[index] : glm::dvec3(0.0);
}

class OffWriter {
 public:
  explicit OffWriter(const MeshFile& file)
      : file_(file),
        mesh_(file.mesh),
        normals_(per_vertex(mesh_, mesh_.normals)),
        texcoords_(per_vertex(mesh_, mesh_.texcoords)),
        out_(64 * mesh_.positions.size() + 10 * mesh_.corners.size()) {}

  std::string write() {
    head();
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) vertex(v);
    auto aside = mesh_.quarantine.begin();
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      if (aside != mesh_.quarantine.end() && aside->face == f) {
        out_ << aside->corners.size();
        for (const std::int64_t corner : aside->corners) out_ << ' ' << corner;
        ++aside;
      } else {
        const auto corners = mesh_.face(f);
        out_ << corners.size();
        for (const std::uint32_t corner : corners) out_ << ' ' << corner;
      }
      face_colour(f);
      out_ << '\n';
    }
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

  // The number from 0 to 255 that reading divides back into the component, a whole one if there is.
  static double as_byte(double component) {
    constexpr double scale = 255.0, infinity = std::numeric_limits<double>::infinity();
    const double scaled = component * scale;
    for (const double candidate : {std::nearbyint(scaled), scaled, std::nextafter(scaled, infinity)}) {
      if (candidate / scale == component) return candidate;
    }
    return std::nextafter(scaled, -infinity);
  }

  void colour(const glm::dvec4& value) {
    if (std::isnan(value.x)) return;
    const int count = mesh_.colour_components == 4 ? 4 : 3;
    for (int i = 0; i < count; ++i) out_ << ' ' << (file_.byte_colours ? as_byte(value[i]) : value[i]);
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
    for (int i = 0; i < colours.count[face]; ++i) out_ << ' ' << colours.values[face][i];
  }

  const MeshFile& file_;
  const IndexedMesh& mesh_;
  std::optional<std::vector<std::uint32_t>> normals_, texcoords_;
  TextOut out_;
};

}  // namespace

std::string write_off(const MeshFile& file) { return OffWriter(file).write(); }

std::vector<Message> off_losses(const MeshFile& file) {
  const IndexedMesh& mesh = file.mesh;
  struct Loss {
    bool is_there;
    const char* code;
    Text text;
  };
  const bool has_names = !mesh.groups.names.empty() || !mesh.objects.names.empty() || !mesh.materials.names.empty() ||
                         !mesh.smoothing.names.empty() || !file.material_libraries.empty();
  const Loss losses[] = {
      {has_names,
       "loses_names",
       {"OFF cannot hold groups, objects, smoothing groups and materials.",
        "OFF はグループ、オブジェクト、スムージンググループ、マテリアルを保持できません。"}},
      {!mesh.texcoords.pool.empty() && !per_vertex(mesh, mesh.texcoords),
       "loses_texcoords",
       {"OFF cannot hold texture coordinates that differ between the corners of a vertex.",
        "OFF は、同じ頂点でも面ごとに異なるテクスチャ座標を保持できません。"}},
      {!mesh.normals.pool.empty() && !per_vertex(mesh, mesh.normals),
       "loses_normals",
       {"OFF cannot hold normals that differ between the corners of a vertex.",
        "OFF は、同じ頂点でも面ごとに異なる法線を保持できません。"}},
      {!mesh.texcoords.pool.empty() && mesh.texcoords.components == 3,
       "loses_third_texcoord",
       {"OFF cannot hold the third number of texture coordinates.",
        "OFF はテクスチャ座標の 3 番目の数を保持できません。"}},
      {!mesh.vertex_weights.empty(),
       "loses_weights",
       {"OFF cannot hold weights of vertices.", "OFF は頂点の重みを保持できません。"}},
      {!file.elements.items.empty(),
       "loses_elements",
       {"OFF cannot hold lines and points.", "OFF は線と点の要素を保持できません。"}},
  };
  std::vector<Message> out;
  for (const Loss& loss : losses) {
    if (loss.is_there) out.push_back(make_message(Severity::warning, loss.code, loss.text));
  }
  return out;
}

}  // namespace ryosen
