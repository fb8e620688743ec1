#include "ryosen/indexed/to_indexed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/indexed/bridged_corners.h"
#include "ryosen/indexed/list_attributes.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// Live points indexed by position.
class PointsByPlace {
 public:
  explicit PointsByPlace(const Mesh& mesh) : mesh_(mesh) {
    for (const Vertex v : live_vertices(mesh))
      if (point(mesh, v) == v && is_place(mesh.position(v))) points_.push_back(v);
    std::sort(points_.begin(), points_.end(), [&](Vertex a, Vertex b) {
      return is_before(mesh_.position(a), mesh_.position(b)) || (mesh_.position(a) == mesh_.position(b) && a < b);
    });
  }

  // The lowest point at a position, or none.
  Vertex at(const glm::dvec3& place) const {
    if (!is_place(place)) return Vertex();
    const auto found = std::lower_bound(points_.begin(), points_.end(), place,
                                        [&](Vertex v, const glm::dvec3& p) { return is_before(mesh_.position(v), p); });
    return found != points_.end() && mesh_.position(*found) == place ? *found : Vertex();
  }

 private:
  static bool is_place(const glm::dvec3& p) { return !std::isnan(p.x) && !std::isnan(p.y) && !std::isnan(p.z); }
  static bool is_before(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }

  const Mesh& mesh_;
  std::vector<Vertex> points_;
};

void number_vertices(const Mesh& mesh, const std::vector<Vertex>& kept, CompactMesh& out) {
  out.vertex_number.assign(mesh.vertex_slots(), no_index);
  out.mesh.positions.reserve(mesh.live().vertices + kept.size());
  out.kept_vertices = kept.size();
  auto next_kept = kept.begin();
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    const bool is_kept = next_kept != kept.end() && *next_kept == v;
    if (is_kept) ++next_kept;
    if (!is_kept && (!mesh.is_alive(v) || out.vertex_number[i] != no_index)) continue;  // point is numbered
    const auto number = static_cast<std::uint32_t>(out.mesh.positions.size());
    if (is_kept)
      out.vertex_number[i] = number;
    else
      for_each_copy(mesh, v, [&](Vertex copy) { out.vertex_number[copy.index] = number; });
    out.mesh.positions.push_back(mesh.position(v));
  }
}

// Builds the CornerValues of one corner attribute; stays empty if the mesh has no such column.
class CornerColumn {
 public:
  CornerColumn(const Mesh& mesh, std::string_view index_name, std::string_view pool_name, int components,
               CornerValues& values)
      : values_(values) {
    values.components = components;
    if (const AttributeColumn* const pool = find_column(mesh, pool_name))
      values.pool = attribute_values<glm::dvec3>(*pool);
    const AttributeColumn* const index = find_column(mesh, index_name);
    if (!index) return;
    data_ = index->data.data();
    values.index.reserve(std::size_t{2} * mesh.live().edges);
  }
  void add(Halfedge corner) {
    if (data_) add_value(data_[corner.index]);
  }
  // A further occurrence, at index `place` of the file's list, of the corner at `place_of_corner`: it keeps its own
  // value from the file if the value of the corner is unchanged.
  void add(Halfedge corner, const std::vector<std::uint32_t>& in_file, std::size_t place, std::size_t place_of_corner) {
    if (!data_) return;
    const std::uint32_t value = data_[corner.index];
    const bool is_unchanged = !in_file.empty() && in_file[place_of_corner] == value;
    add_value(is_unchanged ? in_file[place] : value);
  }
  // Drops the index if no corner has a value.
  void finish() {
    if (!any_) values_.index.clear();
  }

 private:
  void add_value(std::uint32_t value) {
    values_.index.push_back(value);
    any_ |= value != no_index;
  }

  CornerValues& values_;
  const std::uint32_t* data_ = nullptr;
  bool any_ = false;
};

class FaceWriter {
 public:
  FaceWriter(const Mesh& mesh, const FileTables& tables, CompactMesh& out)
      : mesh_(mesh),
        tables_(tables),
        out_(out),
        texcoords_(mesh, attribute_names::texcoord, attribute_names::texcoord_pool, tables.texcoord_components,
                   out.mesh.texcoords),
        normals_(mesh, attribute_names::normal, attribute_names::normal_pool, tables.normal_components,
                 out.mesh.normals),
        wants_corners_(has_free_attributes(mesh, ElementKind::corner)) {}

  void write() {
    IndexedMesh& m = out_.mesh;
    out_.face_number.assign(mesh_.face_slots(), no_index);
    m.corners.reserve(std::size_t{2} * mesh_.live().edges);
    m.face_offsets.reserve(std::size_t{mesh_.live().faces} + tables_.quarantine.size() + 1);
    auto aside = tables_.quarantine.begin();
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      const bool is_aside = aside != tables_.quarantine.end() && aside->face == i;
      if (is_aside) ++aside;
      if (!is_aside && !mesh_.is_alive(Face(i))) continue;
      out_.face_number[i] = static_cast<std::uint32_t>(m.face_count());
      if (!is_aside) write_corners(Face(i));
      m.face_offsets.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
    texcoords_.finish();
    normals_.finish();
  }

  // The corners of the mesh by place in the list, where the mesh has further attributes of corners.
  const std::vector<std::uint32_t>& corners() const { return corners_; }
  const std::vector<RepeatedCorner>& repeated() const { return repeated_; }

 private:
  void write_corners(Face f) {
    if (visits_a_corner_twice(mesh_, f)) {
      out_.mesh.bridged.push_back(out_.face_number[f.index]);
      write_bridged(f);
      return;
    }
    for (Halfedge h : halfedges_around(mesh_, f)) add(h);
  }

  void add_corner(Halfedge h) {
    out_.mesh.corners.push_back(out_.vertex_number[mesh_.from(h).index]);
    if (wants_corners_) corners_.push_back(h.index);
  }

  void add(Halfedge h) {
    add_corner(h);
    texcoords_.add(h);
    normals_.add(h);
  }

  void write_bridged(Face f) {
    const auto in_file = std::lower_bound(tables_.bridged.begin(), tables_.bridged.end(), f.index,
                                          [](const BridgedFace& b, std::uint32_t face) { return b.face < face; });
    if (in_file != tables_.bridged.end() && in_file->face == f.index) {
      if (const auto corners = corners_as_in_file(mesh_, f, in_file->corners)) {
        for (std::size_t i = 0; i < corners->size(); ++i) {
          const auto& [corner, place] = (*corners)[i];
          add_corner(corner);
          if (i != place) repeated_.push_back({out_.mesh.corners.size() - 1, &*in_file, i, place});
          texcoords_.add(corner, in_file->texcoords, i, place);
          normals_.add(corner, in_file->normals, i, place);
        }
        return;
      }
    }
    for (Halfedge h : corners_with_bridges(mesh_, f)) add(h);
  }

  const Mesh& mesh_;
  const FileTables& tables_;
  CompactMesh& out_;
  CornerColumn texcoords_, normals_;
  std::vector<std::uint32_t> corners_;
  std::vector<RepeatedCorner> repeated_;
  const bool wants_corners_;
};

void write_quarantine(const Mesh& mesh, const FileTables& tables, CompactMesh& out) {
  const std::int64_t end = mesh.file_vertices();
  const auto new_end = static_cast<std::int64_t>(out.mesh.positions.size());
  const auto new_number = [&](std::int64_t corner) -> std::int64_t {
    if (corner < 0) return corner;
    return corner < end ? out.vertex_number[static_cast<std::size_t>(corner)] : past_new_end(corner, end, new_end);
  };
  out.mesh.quarantine = tables.quarantine;
  for (QuarantinedFace& face : out.mesh.quarantine) {
    face.face = out.face_number[face.face];
    face.line = 0;
    for (std::int64_t& corner : face.corners) corner = new_number(corner);
  }
  renew_quarantined_values(out.mesh.quarantine, tables.quarantined_attributes, out.mesh.attributes);
}

// Reorders one value per slot to the numbers of the list; slots from values.size() on get `fill`.
template <class Value>
std::vector<Value> renumbered(const std::vector<Value>& values, const std::vector<std::uint32_t>& number,
                              std::size_t count, const Value& fill) {
  std::vector<Value> result(count, fill);
  // Descending, so that among the copies of a point its representative wins.
  for (std::size_t i = std::min(values.size(), number.size()); i-- > 0;)
    if (number[i] != no_index) result[number[i]] = values[i];
  return result;
}

void write_vertex_values(const Mesh& mesh, const FileTables& tables, CompactMesh& out) {
  const std::size_t count = out.mesh.positions.size();
  if (const AttributeColumn* const colours = find_column(mesh, attribute_names::colour))
    out.mesh.vertex_colours =
        renumbered(attribute_values<glm::dvec4>(*colours), out.vertex_number, count, glm::dvec4(0.0));
  out.mesh.colour_components = tables.colour_components;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (const AttributeColumn* const weights = find_column(mesh, attribute_names::weight))
    out.mesh.vertex_weights = renumbered(attribute_values<double>(*weights), out.vertex_number, count, none);
}

void write_face_names(const Mesh& mesh, std::string_view name, const std::vector<std::string>& names,
                      const CompactMesh& out, FaceNames& result) {
  result.names = names;
  if (const AttributeColumn* const column = find_column(mesh, name))
    result.index = renumbered(column->data, out.face_number, out.mesh.face_count(), no_index);
}

void write_face_values(const Mesh& mesh, const FileTables& tables, CompactMesh& out) {
  IndexedMesh& m = out.mesh;
  write_face_names(mesh, attribute_names::material, tables.materials, out, m.materials);
  write_face_names(mesh, attribute_names::group, tables.groups, out, m.groups);
  write_face_names(mesh, attribute_names::object, tables.objects, out, m.objects);
  write_face_names(mesh, attribute_names::smoothing, tables.smoothing, out, m.smoothing);
  const AttributeColumn* const colours = find_column(mesh, attribute_names::face_colour);
  const AttributeColumn* const components = find_column(mesh, attribute_names::face_colour_components);
  if (!colours || !components) return;
  const std::size_t count = m.face_count();
  m.face_colours.are_bytes = tables.face_colours_are_bytes;
  m.face_colours.values = renumbered(attribute_values<glm::dvec4>(*colours), out.face_number, count, glm::dvec4(0.0));
  const std::vector<std::uint8_t> of_slots(components->data.begin(), components->data.end());
  m.face_colours.count = renumbered(of_slots, out.face_number, count, std::uint8_t{0});
}

std::vector<BridgedFace> bridged_faces(const IndexedMesh& source) {
  std::vector<BridgedFace> faces;
  for (std::uint32_t f : source.bridged) {
    const std::uint32_t begin = source.face_offsets[f], end = source.face_offsets[f + 1];
    const auto part = [&](const std::vector<std::uint32_t>& values) {
      if (values.empty()) return std::vector<std::uint32_t>();
      return std::vector<std::uint32_t>(values.begin() + begin, values.begin() + end);
    };
    std::vector<std::uint32_t> places(end - begin);
    std::iota(places.begin(), places.end(), begin);
    std::vector<AttributeColumn> values;
    for (const AttributeColumn& column : source.attributes)
      if (column.element == ElementKind::corner) values.push_back(with_rows(column, places));
    faces.push_back(
        {f, part(source.corners), part(source.texcoords.index), part(source.normals.index), std::move(values)});
  }
  return faces;
}

}  // namespace

LostVertices find_lost(const Mesh& mesh, const FileTables& tables, std::span<const Vertex> used_beside) {
  std::vector<Vertex> gone;
  const auto add = [&](std::int64_t number) {
    if (number < 0 || number >= std::int64_t{mesh.file_vertices()}) return;
    const Vertex v(static_cast<std::uint32_t>(number));
    if (!mesh.is_alive(v)) gone.push_back(v);
  };
  for (const QuarantinedFace& face : tables.quarantine) std::for_each(face.corners.begin(), face.corners.end(), add);
  for (const Vertex v : used_beside) add(v.index);
  sort_unique(gone);
  LostVertices lost;
  if (gone.empty()) return lost;
  const PointsByPlace points(mesh);
  for (const Vertex v : gone) {
    const Vertex there = points.at(mesh.position(v));
    // A file vertex with a higher number does not replace it: it keeps its own row of values.
    if (!there.is_none() && (there < v || there.index >= mesh.file_vertices()))
      lost.replacements.emplace_back(v, there);
    else
      lost.kept.push_back(v);
  }
  return lost;
}

FileTables file_tables(const IndexedMesh& source) {
  return {
      source.quarantine,           bridged_faces(source),     source.face_lines,        source.materials.names,
      source.groups.names,         source.objects.names,      source.smoothing.names,   quarantined_attributes(source),
      source.texcoords.components, source.normals.components, source.colour_components, source.face_colours.are_bytes};
}

FileTables take_file_tables(IndexedMesh& source) {
  std::vector<QuarantinedFace> quarantine = std::exchange(source.quarantine, {});
  FileTables tables = file_tables(source);
  tables.quarantine = std::move(quarantine);
  return tables;
}

CompactMesh to_indexed(const Mesh& mesh, const FileTables& tables, std::span<const Vertex> used_beside) {
  CompactMesh out;
  const LostVertices lost = find_lost(mesh, tables, used_beside);
  number_vertices(mesh, lost.kept, out);
  FaceWriter faces(mesh, tables, out);
  faces.write();
  write_vertex_values(mesh, tables, out);
  write_face_values(mesh, tables, out);
  list_attributes(mesh, faces.corners(), out);
  restore_repeated(faces.repeated(), out);
  // Only now: replaced vertices must not contribute attribute values.
  for (const auto& [gone, there] : lost.replacements) out.vertex_number[gone.index] = out.vertex_number[there.index];
  write_quarantine(mesh, tables, out);
  return out;
}

}  // namespace ryosen
