// Puts the values of a PLY file where they belong, however they are coded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/io/face_list.h"
#include "core/io/mesh_file.h"
#include "core/io/ply_header.h"
#include "core/io/reporter.h"

namespace ryosen {

// Where the numbers of a property of one number per row go.
struct PlyTarget {
  double* first = nullptr;  // null: to Property::data
  std::size_t stride = 0;   // from row to row, in doubles
  double divisor = 1.0;

  void put(std::size_t row, double value) const { first[row * stride] = value / divisor; }
};

class PlyBuilder {
 public:
  explicit PlyBuilder(PlyHeader header);

  std::vector<PropertyTable>& tables() { return file_.properties.tables; }
  // Makes room for the rows of a table, which must fit the file, and tells where its properties go. `place` is where
  // its first row stands.
  std::vector<PlyTarget> begin_table(std::size_t table, FilePlace place);

  IndexedMesh& mesh() { return file_.mesh; }
  FaceList& faces() { return faces_; }
  Reporter& reporter() { return reporter_; }
  void warn_non_finite(FilePlace place);
  // Of a whole number of 64 bits that the mesh, which has doubles, holds only rounded.
  void warn_rounded(FilePlace place);

  // Sets the unusable faces aside and hands the file over; refuses what looks like the other byte order.
  Result<MeshFile> finish();

 private:
  PlyTarget target_of(const Property& property);
  void take_corner_texcoords();
  bool has_other_byte_order() const;
  void warn_of_the_whole();

  MeshFile file_;
  FaceList faces_;
  Reporter reporter_;
  std::vector<FilePlace> places_;  // of the first row of each table
};

}  // namespace ryosen
