// The columns for writing a PLY file: those of the file's layout, plus those that its mesh needs in addition.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ryosen/io/mesh_file.h"

namespace ryosen {

struct PlyColumn : PropertyHead {
  double scale = 1.0;  // for colours: the written value of 1
  bool is_of_layout = false;
  const Property* kept = nullptr;  // the source of its values, if not in the mesh
  const AttributeColumn* attribute = nullptr;
  std::size_t words_before = 0;  // of other attributes of a corner, in QuarantinedFace::values
};

// A row of the element edge: an edge of the mesh, or a row that the table of the file has kept.
struct PlyEdgeRow {
  bool is_kept = false;
  std::uint32_t index = 0;
};

struct PlyTable {
  std::string_view name;
  TableKind kind = TableKind::other;
  std::size_t rows = 0;
  std::vector<PlyColumn> columns;
  std::vector<PlyEdgeRow> edges;  // of TableKind::edges, by row
};

class PlyColumns {
 public:
  // Chooses the types: those of the layout if they hold every value of a position, normal, texture coordinate or
  // colour; else the narrowest real type that does, for all its components. Colours without a layout are uchar if each
  // component means a byte (byte_meant); those of a layout with uchar stay it, rounded. The file must outlive it.
  // O(values).
  PlyColumns(const MeshFile& file, Encoding encoding);

  const std::vector<PlyTable>& tables() const { return tables_; }
  // The value to write for a row of a scalar column from the mesh; as the mesh has it, colours from 0 to 1.
  double value(const PlyColumn& column, std::size_t row) const;
  double mesh_value(const PlyColumn& column, std::size_t row) const;
  // The corners of a face with file numbering, quarantined faces too.
  template <class Visit>
  void for_each_corner(std::size_t face, Visit visit) const {
    if (const QuarantinedFace* const aside = quarantined(face)) {
      for (const std::int64_t corner : aside->corners) visit(corner);
    } else {
      for (const std::uint32_t corner : file_.mesh.face(face)) visit(std::int64_t{corner});
    }
  }
  std::size_t corner_count(std::size_t face) const;
  // The value of an attribute at a corner of a face, by its place there.
  const std::uint32_t* corner_value(const PlyColumn& column, std::size_t face, std::size_t corner) const;
  // Whether the columns have this attribute of the mesh.
  bool has(const AttributeColumn& column) const;
  // The texture coordinates of a face's corners: empty, or one per corner.
  const std::vector<glm::dvec3>& corner_texcoords(std::size_t face) const;

 private:
  const QuarantinedFace* quarantined(std::size_t face) const;
  void add_layout();
  void add_missing();
  // The attribute of the mesh that a property was read as, or null.
  const AttributeColumn* attribute_of(TableKind kind, const Property& property) const;
  void set_attribute(PlyColumn& column, const AttributeColumn& attribute) const;
  PlyTable* table_of(TableKind kind);
  void add_attributes();
  void add_edge_rows(PlyTable& table, const PropertyTable* kept) const;
  bool has_data(PropertyRole role, std::uint8_t component) const;
  void add_reals(PlyTable& table, PropertyRole role, std::initializer_list<std::string_view> names);
  void widen(const PlyTable& table, PlyColumn& column);
  // Keeps the layout's types for a role, or widens all its components to one type.
  void widen_together(PlyTable& table, PropertyRole role);
  void widen_ends(PlyColumn& column) const;
  void widen_corners(PlyColumn& column);
  bool holds(Scalar type, const PlyColumn& column, std::size_t rows) const;
  bool holds_value(Scalar type, const PlyColumn& column, double value) const;

  const MeshFile& file_;
  std::vector<PlyTable> tables_;
  std::optional<std::vector<std::uint32_t>> normals_, texcoords_;
  std::vector<std::uint32_t> aside_;  // per face the index in the quarantine; empty if there is none
  bool has_corner_texcoords_ = false;
  int face_colour_components_ = 0;  // 0: PLY cannot hold the face colours
  bool has_decimals_ = false;       // the file as read is ascii
  bool writes_decimals_ = false;    // and so is the one to write
  mutable std::vector<glm::dvec3> scratch_;
};

// The number of components for writing the face colours to PLY: 3 or 4, or 0 if it cannot hold them.
int ply_face_colour_components(const FaceColours& colours);

// The number of vertices and faces whose colours are rounded to the uchar that the file had. O(colours).
std::uint64_t ply_rounded_colours(const MeshFile& file);

// The number of attributes that have no place in PLY beside what the file has there: those of edges where its element
// edge is something else, and those whose names it has for something else. O(values) where there are attributes.
std::uint64_t ply_unwritten_attributes(const MeshFile& file);

}  // namespace ryosen
