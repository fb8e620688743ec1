#include "ryosen/io/triangulated.h"

#include <algorithm>

#include "ryosen/geometry/triangulate.h"
#include "ryosen/mesh/attribute.h"

namespace ryosen {
namespace {

class Triangulator {
 public:
  explicit Triangulator(const IndexedMesh& mesh) : mesh_(mesh) {}

  void run() {
    out_.corners.reserve(mesh_.corners.size() + mesh_.corners.size() / 2);
    out_.face_offsets.reserve(mesh_.face_offsets.size());
    const auto take = [&](std::size_t f, std::span<const std::uint32_t> corners) {
      if (corners.size() != 3) return cut(f);
      for (std::uint32_t i = mesh_.face_offsets[f]; i < mesh_.face_offsets[f + 1]; ++i) add_corner(i);
      end_face(f);
    };
    for_each_face(mesh_, take, [&](const QuarantinedFace& aside) {
      out_.quarantine.push_back(aside);
      out_.quarantine.back().face = static_cast<std::uint32_t>(out_.face_count());
      end_face(aside.face);
    });
    take_the_rest();
  }

  IndexedMesh& mesh() { return out_; }
  const std::vector<std::uint32_t>& source_faces() const { return source_; }

 private:
  void add_corner(std::uint32_t place) {
    places_.push_back(place);
    out_.corners.push_back(mesh_.corners[place]);
    if (!mesh_.texcoords.index.empty()) out_.texcoords.index.push_back(mesh_.texcoords.index[place]);
    if (!mesh_.normals.index.empty()) out_.normals.index.push_back(mesh_.normals.index[place]);
  }

  void end_face(std::size_t source) {
    out_.face_offsets.push_back(static_cast<std::uint32_t>(out_.corners.size()));
    source_.push_back(static_cast<std::uint32_t>(source));
  }

  void cut(std::size_t face) {
    polygon_.clear();
    for (const std::uint32_t corner : mesh_.face(face)) polygon_.push_back(mesh_.positions[corner]);
    triangulate(polygon_, triangles_);
    for (const CornerTriangle& triangle : triangles_) {
      for (const std::uint32_t corner : triangle) add_corner(mesh_.face_offsets[face] + corner);
      end_face(face);
    }
  }

  template <class Value>
  std::vector<Value> by_source(const std::vector<Value>& values) const {
    std::vector<Value> out;
    if (values.empty()) return out;
    out.reserve(source_.size());
    for (const std::uint32_t face : source_) out.push_back(values[face]);
    return out;
  }
  FaceNames by_source(const FaceNames& names) const { return {names.names, by_source(names.index)}; }

  void take_the_rest() {
    out_.positions = mesh_.positions;
    out_.vertex_lines = mesh_.vertex_lines;
    out_.face_lines = by_source(mesh_.face_lines);
    out_.texcoords.pool = mesh_.texcoords.pool;
    out_.texcoords.components = mesh_.texcoords.components;
    out_.normals.pool = mesh_.normals.pool;
    out_.normals.components = mesh_.normals.components;
    out_.vertex_colours = mesh_.vertex_colours;
    out_.colour_components = mesh_.colour_components;
    out_.vertex_weights = mesh_.vertex_weights;
    out_.face_colours = {by_source(mesh_.face_colours.values), by_source(mesh_.face_colours.count),
                         mesh_.face_colours.are_bytes};
    out_.materials = by_source(mesh_.materials);
    out_.groups = by_source(mesh_.groups);
    out_.objects = by_source(mesh_.objects);
    out_.smoothing = by_source(mesh_.smoothing);
    out_.edges = mesh_.edges;
    for (const AttributeColumn& column : mesh_.attributes) {
      const bool is_of_face = column.element == ElementKind::face, is_of_corner = column.element == ElementKind::corner;
      out_.attributes.push_back(is_of_face     ? with_rows(column, source_)
                                : is_of_corner ? with_rows(column, places_)
                                               : column);
    }
  }

  const IndexedMesh& mesh_;
  IndexedMesh out_;
  std::vector<std::uint32_t> source_, places_;  // the old face of each new one, and the place of each corner
  std::vector<glm::dvec3> polygon_;
  std::vector<CornerTriangle> triangles_;
};

}  // namespace

bool has_polygons(const IndexedMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (mesh.face(f).size() > 3) return true;
  return false;
}

MeshFile triangulated(const MeshFile& file) {
  Triangulator triangulator(file.mesh);
  triangulator.run();
  const std::vector<std::uint32_t>& source = triangulator.source_faces();
  MeshFile out;
  out.mesh = std::move(triangulator.mesh());
  out.format = file.format;
  out.head_comments = file.head_comments;
  out.material_libraries = file.material_libraries;
  out.elements = file.elements;
  for (LineElement& item : out.elements.items) {
    const auto after = std::lower_bound(source.begin(), source.end(), item.before_face);
    item.before_face = static_cast<std::uint32_t>(after - source.begin());
  }
  out.properties = with_faces_of(file.properties, source);
  out.encoding = file.encoding;
  out.wires = file.wires;
  out.kept_vertices = file.kept_vertices;
  out.left_out = file.left_out;
  out.stl_head = file.stl_head;
  out.byte_colours = file.byte_colours;
  out.messages = file.messages;
  return out;
}

}  // namespace ryosen
