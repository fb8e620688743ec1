// Distributes the values of a PLY file, text or binary, to the mesh and the property tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ryosen/io/face_list.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/io/ply_header.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

// The destination of a scalar property's values.
struct PlyTarget {
  double* first = nullptr;  // null: to Property::data
  std::size_t stride = 0;   // between rows, in doubles
  double divisor = 1.0;

  void put(std::size_t row, double value) const { first[row * stride] = value / divisor; }
};

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
  void take_corner_texcoords();
  void widen_odd_colours();
  void warn_of_kept_lists();
  void inform_of_missing_z(const PropertyTable& table, FilePlace place);
  bool has_other_byte_order() const;
  // The first face, or strip of triangles; nowhere if there is none.
  FilePlace place_of_faces() const;

  MeshFile file_;
  FaceList faces_;
  Reporter reporter_;
  std::vector<FilePlace> places_;            // of the first row of each table
  std::vector<std::uint64_t> strip_places_;  // a line or byte for each strip
};

}  // namespace ryosen
