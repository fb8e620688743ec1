// Tables of typed values that a file has besides its mesh: elements and properties of PLY, facet attributes of binary
// STL. They are renumbered with their vertices and faces through edits and written back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/handle.h"

namespace ryosen {

enum class NumberType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

// Size in bytes: 1, 2, 4 or 8.
std::size_t size_of(NumberType type);
bool is_real(NumberType type);
// The value that represents 1 in a colour of this type.
double colour_scale(NumberType type);
// Parses a type name of a PLY header, in either spelling (float, float32); false for any other word.
bool find_number_type(std::string_view word, NumberType& type);
std::string_view name_of(NumberType type);

// Calls visit with a zero of the C++ type corresponding to `type`.
template <class Visit>
auto with_number_type(NumberType type, Visit visit) {
  switch (type) {
    case NumberType::i8:
      return visit(std::int8_t());
    case NumberType::u8:
      return visit(std::uint8_t());
    case NumberType::i16:
      return visit(std::int16_t());
    case NumberType::u16:
      return visit(std::uint16_t());
    case NumberType::i32:
      return visit(std::int32_t());
    case NumberType::u32:
      return visit(std::uint32_t());
    case NumberType::i64:
      return visit(std::int64_t());
    case NumberType::u64:
      return visit(std::uint64_t());
    case NumberType::f32:
      return visit(float());
    default:
      return visit(double());
  }
}

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
  vertex_number,    // in the property; vertex numbers, renumbered with the vertices
  extra,            // in the property
};

// Head of a property: all but its values.
struct PropertyHead {
  std::string name;
  NumberType type = NumberType::f32;
  bool is_list = false;
  NumberType count_type = NumberType::u8;  // of a list
  PropertyRole role = PropertyRole::extra;
  std::uint8_t component = 0;

  bool is_kept() const { return role == PropertyRole::vertex_number || role == PropertyRole::extra; }
};

struct Property : PropertyHead {
  // For the last two roles: the values in native byte order, row by row. The values of row i of a list end before index
  // ends[i].
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

enum class TableKind : std::uint8_t { vertices, faces, other };

struct PropertyTable {
  std::string name;
  TableKind kind = TableKind::other;
  std::size_t rows = 0;  // for vertices and faces: as many as in the mesh
  std::vector<Property> properties;
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

// The tables for a new list of faces: each new face copies the row of an old one. O(values).
PropertyTables with_faces_of(const PropertyTables& tables, std::span<const std::uint32_t> old_face);

}  // namespace ryosen
