// Tables of typed values that a file has besides its mesh: elements and properties of PLY. They are renumbered with
// their vertices and faces through edits and written back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/handle.h"
#include "ryosen/mesh/attribute_text.h"

namespace ryosen {

// The value that represents 1 in a colour of this type.
double colour_scale(Scalar type);

// The encoding of numbers; automatic leaves the choice to the format.
enum class Encoding : std::uint8_t { automatic, ascii, binary_little, binary_big };

// Where the values of a property are stored; the component is given by Property::component.
enum class PropertyRole : std::uint8_t {
  position,         // IndexedMesh::positions
  normal,           // IndexedMesh::normals, one entry of the pool per vertex
  texcoord,         // IndexedMesh::texcoords, one entry of the pool per vertex
  vertex_colour,    // IndexedMesh::vertex_colours
  corners,          // the faces
  corner_texcoord,  // IndexedMesh::texcoords, two numbers per corner
  face_colour,      // IndexedMesh::face_colours
  attribute,        // IndexedMesh::attributes; for further edges (TableKind::edges) in the property
  vertex_number,    // in the property; vertex numbers, renumbered with the vertices
  row,              // in the property: the place of the row in the file; never written
  extra,            // in the property
};

// Head of a property: all but its values.
struct PropertyHead {
  std::string name;
  Scalar type = Scalar::float32;
  bool is_list = false;
  Scalar count_type = Scalar::uint8;  // of a list
  PropertyRole role = PropertyRole::extra;
  std::uint8_t component = 0;

  bool is_kept() const {
    return role == PropertyRole::vertex_number || role == PropertyRole::row || role == PropertyRole::extra;
  }
};

struct Property : PropertyHead {
  // Where it is kept, and of attributes of TableKind::edges: the values in native byte order, row by row. The values of
  // row i of a list end before index ends[i].
  std::vector<std::byte> data;
  std::vector<std::uint32_t> ends;

  // The first value of a row, and their number.
  std::size_t first_value(std::size_t row) const { return !is_list ? row : row == 0 ? 0 : ends[row - 1]; }
  std::size_t value_count(std::size_t row) const { return is_list ? ends[row] - first_value(row) : 1; }
  std::int64_t integer(std::size_t value) const;  // only for integer types
  double real(std::size_t value) const;
  void append(std::int64_t value);
  void append(double value);
};

// edges: those of the file that are no edges of the mesh, which are in IndexedMesh::edges.
enum class TableKind : std::uint8_t { vertices, faces, edges, other };

struct PropertyTable {
  std::string name;
  TableKind kind = TableKind::other;
  std::size_t rows = 0;  // for vertices and faces: as many as in the mesh
  std::vector<Property> properties;

  // Whether its rows are neither vertices nor faces.
  bool is_further() const { return kind == TableKind::edges || kind == TableKind::other; }
};

// Lines of a PLY header that begin with a word it does not know, and where they stand.
struct UnknownLines {
  std::string text;              // one or several, each with its line end
  std::uint32_t tables = 0;      // how many tables are announced before them
  std::uint32_t properties = 0;  // and how many properties of the last of these

  bool operator==(const UnknownLines&) const = default;
};

struct PropertyTables {
  std::vector<PropertyTable> tables;        // in the order of the file
  std::vector<std::string> obj_info;        // header lines of PLY, without the word
  std::vector<UnknownLines> unknown_lines;  // in the order of the file
  bool has_decimal_reals = false;           // reals were read from text as doubles, whatever the declared type

  // Whether they are the complete layout of a PLY file, not just extra data of another format.
  bool has_layout() const;
};

// Renumbers the tables: the new number for each old one, no_index if removed. New elements get zeros and empty lists. A
// row that references a removed vertex is removed; in a list of vertex numbers it becomes -1. A number past the old end
// stays equally far past the new one. O(values).
PropertyTables renumbered(const PropertyTables& tables, std::span<const std::uint32_t> vertex_number,
                          std::span<const std::uint32_t> face_number, std::size_t old_vertices,
                          std::size_t new_vertices, std::size_t new_faces);

// The vertex numbers in properties (such as ends of edges), in table order.
std::vector<std::int64_t> vertices_named(const PropertyTables& tables);

// A table with these rows of another one; no_index gives zeros and empty lists. O(values).
PropertyTable rows_of(const PropertyTable& table, std::span<const std::uint32_t> source);

// The tables for a new list of faces: each new face copies the row of an old one. O(values).
PropertyTables with_faces_of(const PropertyTables& tables, std::span<const std::uint32_t> old_face);

}  // namespace ryosen
