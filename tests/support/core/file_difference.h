// Compares what two files gave, bit by bit.
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "ryosen/io/byte_colours.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen::test {

// Not-a-number is one value: no text says which of its many bit patterns is meant.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

template <class Vector>
bool same_bits(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if constexpr (std::is_same_v<Vector, double>) {
      if (!same_bits(a[i], b[i])) return false;
    } else {
      for (int k = 0; k < Vector::length(); ++k) {
        if (!same_bits(a[i][k], b[i][k])) return false;
      }
    }
  }
  return true;
}

inline bool same_values(const CornerValues& a, const CornerValues& b) {
  return same_bits(a.pool, b.pool) && a.index == b.index && a.components == b.components;
}

inline bool same_names(const FaceNames& a, const FaceNames& b) { return a.names == b.names && a.index == b.index; }

inline bool same_quarantine(const std::vector<QuarantinedFace>& a, const std::vector<QuarantinedFace>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].face != b[i].face || a[i].code != b[i].code || a[i].corners != b[i].corners ||
        a[i].texcoords != b[i].texcoords || a[i].normals != b[i].normals || a[i].values != b[i].values) {
      return false;
    }
  }
  return true;
}

inline bool same_edges(const std::vector<ListedEdge>& a, const std::vector<ListedEdge>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ListedEdge& x, const ListedEdge& y) {
    return x.from == y.from && x.to == y.to && x.row == y.row;
  });
}

inline bool same_elements(const ElementList& a, const ElementList& b) {
  if (a.items.size() != b.items.size() || a.vertices != b.vertices || a.texcoords != b.texcoords) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    const LineElement &x = a.items[i], &y = b.items[i];
    if (x.is_points != y.is_points || x.before_face != y.before_face || x.first != y.first || x.count != y.count ||
        x.object != y.object || x.group != y.group || x.material != y.material || x.smoothing != y.smoothing) {
      return false;
    }
  }
  return true;
}

inline bool same_properties(const PropertyTables& a, const PropertyTables& b) {
  if (a.obj_info != b.obj_info || a.unknown_lines != b.unknown_lines || a.tables.size() != b.tables.size())
    return false;
  for (std::size_t t = 0; t < a.tables.size(); ++t) {
    const PropertyTable &x = a.tables[t], &y = b.tables[t];
    if (x.name != y.name || x.rows != y.rows || x.properties.size() != y.properties.size()) return false;
    for (std::size_t p = 0; p < x.properties.size(); ++p) {
      const Property &u = x.properties[p], &v = y.properties[p];
      if (u.name != v.name || u.is_list != v.is_list || u.role != v.role || u.data != v.data || u.ends != v.ends) {
        return false;
      }
    }
  }
  return true;
}

// The values of all corners in place of the pool that they come from, which not every format keeps.
inline CornerValues by_corner(const CornerValues& values) {
  CornerValues out;
  out.components = values.components;
  if (values.index.empty()) return out;
  for (const std::uint32_t index : values.index)
    out.pool.push_back(index < values.pool.size() ? values.pool[index] : glm::dvec3(-12345.0));
  return out;
}

// Takes the smoothing group "off" for none, which OBJ has no other word for once there was one.
inline void without_off(MeshFile& file) {
  FaceNames& smoothing = file.mesh.smoothing;
  const auto off = std::find(smoothing.names.begin(), smoothing.names.end(), "off");
  if (off == smoothing.names.end()) return;
  const auto number = static_cast<std::uint32_t>(off - smoothing.names.begin());
  const auto leave_out = [number](std::uint32_t& index) {
    if (index == number)
      index = no_index;
    else if (index != no_index && index > number)
      --index;
  };
  for (std::uint32_t& index : smoothing.index) leave_out(index);
  for (LineElement& item : file.elements.items) leave_out(item.smoothing);
  smoothing.names.erase(off);
  if (smoothing.names.empty()) smoothing.index.clear();
}

// The file as far as other formats hold it that lose nothing of the mesh.
inline MeshFile without_form(MeshFile file) {
  file.head_comments.clear();
  file.byte_colours = false;
  file.properties = {};
  file.mesh.attributes.clear();
  file.mesh.edges.clear();
  without_off(file);
  for (CornerValues* values : {&file.mesh.texcoords, &file.mesh.normals}) {
    *values = by_corner(*values);
    if (values->pool.empty()) values->components = 3;
  }
  auto& colours = file.mesh.vertex_colours;
  const auto is_none = [](const glm::dvec4& colour) { return std::isnan(colour.x); };
  for (glm::dvec4& colour : colours)
    if (is_none(colour)) colour = glm::dvec4(no_colour);
  if (std::all_of(colours.begin(), colours.end(), is_none)) colours.clear();
  if (colours.empty()) file.mesh.colour_components = 3;
  // Columns in which no element has a value are as good as none.
  auto& weights = file.mesh.vertex_weights;
  if (std::all_of(weights.begin(), weights.end(), [](double weight) { return std::isnan(weight); })) weights.clear();
  for (FaceNames* names : {&file.mesh.materials, &file.mesh.groups, &file.mesh.objects, &file.mesh.smoothing})
    if (std::all_of(names->index.begin(), names->index.end(), [](std::uint32_t i) { return i == no_index; }))
      names->index.clear();
  for (QuarantinedFace& face : file.mesh.quarantine) face.texcoords.clear(), face.normals.clear(), face.values.clear();
  return file;
}

// What a PLY file says of a value: the float of which it is the shortest decimal, if there is one.
inline double in_ply(double value) {
  if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) return value;
  const volatile float single = static_cast<float>(value);
  char text[32];
  const char* const end = std::to_chars(text, text + sizeof text, single).ptr;
  double printed = 0;
  std::from_chars(text, end, printed);
  return printed == value ? double{single} : value;
}

// The byte that a colour of PLY means, where it means one.
inline double colour_in_ply(double value) {
  const auto byte = byte_meant(value);
  return byte ? *byte / 255.0 : in_ply(value);
}

// The file as PLY says it: floats and their shortest decimals mean the same, and so do bytes and what they are printed
// as.
inline MeshFile as_in_ply(MeshFile file) {
  const auto each = [](auto& vectors, const auto& change) {
    for (auto& vector : vectors)
      for (int i = 0; i < vector.length(); ++i) vector[i] = change(vector[i]);
  };
  each(file.mesh.positions, in_ply);
  each(file.mesh.normals.pool, in_ply);
  each(file.mesh.texcoords.pool, in_ply);
  each(file.mesh.vertex_colours, colour_in_ply);
  each(file.mesh.face_colours.values, colour_in_ply);
  return file;
}

// What differs between two files besides their line numbers and messages, empty if nothing does.
inline std::string difference(const MeshFile& a, const MeshFile& b) {
  const IndexedMesh &x = a.mesh, &y = b.mesh;
  std::string out;
  const auto compare = [&](bool same, const char* what) {
    if (!same) out += std::string(out.empty() ? "" : ", ") + what;
  };
  compare(same_bits(x.positions, y.positions), "positions");
  compare(x.corners == y.corners && x.face_offsets == y.face_offsets, "faces");
  compare(same_quarantine(x.quarantine, y.quarantine), "quarantine");
  compare(same_values(x.texcoords, y.texcoords), "texcoords");
  compare(same_values(x.normals, y.normals), "normals");
  compare(same_bits(x.vertex_colours, y.vertex_colours) && x.colour_components == y.colour_components, "colours");
  compare(same_bits(x.vertex_weights, y.vertex_weights), "weights");
  compare(same_bits(x.face_colours.values, y.face_colours.values) && x.face_colours.count == y.face_colours.count,
          "face colours");
  compare(same_names(x.materials, y.materials), "materials");
  compare(same_names(x.groups, y.groups), "groups");
  compare(same_names(x.objects, y.objects), "objects");
  compare(same_names(x.smoothing, y.smoothing), "smoothing");
  compare(x.attributes == y.attributes, "attributes");
  compare(same_edges(x.edges, y.edges), "edges");
  compare(same_elements(a.elements, b.elements), "elements");
  compare(same_properties(a.properties, b.properties), "properties");
  compare(a.head_comments == b.head_comments, "comments");
  compare(a.material_libraries == b.material_libraries, "libraries");
  return out;
}

}  // namespace ryosen::test
