// Reading of the data section of a PLY file: its readers, and where they put its values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/io/ply_header.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

// The vertex numbers of the strips of triangles, as some files have them in place of faces, if a table is one of strips
// (element tristrips with a list of whole numbers), else null.
const Property* strip_corners(const PropertyTable& table);

// The destination of a scalar property's values.
struct PlyTarget {
  double* first = nullptr;  // null: to Property::data
  std::size_t stride = 0;   // between rows, in doubles
  double divisor = 1.0;

  void put(std::size_t row, double value) const { first[row * stride] = value / divisor; }
};

// Distributes the values, text or binary, to the mesh and the property tables.
class PlyBuilder {
 public:
  explicit PlyBuilder(PlyHeader header);

  std::vector<PropertyTable>& tables() { return file_.properties.tables; }
  // Allocates the rows of a table, whose count must fit the file, and returns the destinations of its properties.
  // `place` is that of its first row.
  std::vector<PlyTarget> begin_table(std::size_t table, FilePlace place);

  IndexedMesh& mesh() { return file_.mesh; }
  FaceList& faces() { return faces_; }
  Reporter& reporter() { return reporter_; }
  void warn_non_finite(FilePlace place);
  // Warns of a 64-bit integer that is rounded to double.
  void warn_rounded(FilePlace place);
  // Notes the place of the next strip: its line, in binary files its byte.
  void note_strip(std::uint64_t place) { strip_places_.push_back(place); }

  // Quarantines the unusable faces and returns the file; fails if it looks like the other byte order.
  Result<MeshFile> finish();

 private:
  PlyTarget target_of(const Property& property);
  // Appends the triangles of all strips to the faces, behind those of the element face, and gives the strips up: they
  // would say the same again. -1 ends a strip (in unsigned types the largest number, if no vertex has it); every second
  // triangle is turned over; a triangle that has a vertex twice only joins two strips and is no face. A strip of one or
  // two vertices is reported. Fails if corners do not fit 32 bits. O(numbers).
  std::optional<Failure> take_strips();
  void take_corner_texcoords();
  void widen_odd_colours();
  void warn_of_kept_lists();
  void inform_of_missing_z(const PropertyTable& table, FilePlace place);
  bool has_other_byte_order() const;
  // The first face, or strip of triangles; nowhere if there is none.
  FilePlace place_of_faces() const;

  MeshFile file_;
  std::vector<PlyAttribute> attributes_;  // that comments describe
  FaceList faces_;
  Reporter reporter_;
  std::vector<FilePlace> places_;            // of the first row of each table
  std::vector<std::uint64_t> strip_places_;  // a line or byte for each strip
};

// Pass all values of `bytes` (the whole file) to the builder, as described by the header; return the failure, if any.
std::optional<Failure> read_ply_text(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);
std::optional<Failure> read_ply_binary(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);

// Passes the numbers of an ascii file to the builder as they come, whatever lines they stand on. Returns whether the
// file has exactly as many as its header announces, and every face three or more corners that all exist; where it has
// not, the builder must not be used any more.
bool read_ply_words(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);

// The failure for a count too large for the file's size.
Failure ply_count_too_large(const PlyHeader& header, std::size_t table);
// The failure for a file that ends after `there` rows of a table.
Failure ply_early_end(const PropertyTable& table, std::size_t there, FilePlace place);
// Whether a count is implausible: the file has room for fewer than a quarter of the rows.
bool is_absurd(std::size_t rows, std::size_t least_bytes_each, std::size_t bytes_left);

// Where reading stopped.
struct PlainRows {
  std::size_t rows = 0, bytes = 0;
};

// Reads up to `most` rows of a table from the start of `text`, which begins behind row `first` - 1 and line `lines`, as
// long as each is one line of nothing but finite decimal numbers that the mesh takes, or of one list: a triangle. What
// is read is as if it had been read row by row; of a row that is not like that, and of tables with other properties,
// nothing is.
PlainRows read_plain_rows(std::string_view text, PropertyTable& table, std::span<const PlyTarget> targets,
                          std::size_t first, std::size_t most, std::uint64_t lines, PlyBuilder& builder);

}  // namespace ryosen
