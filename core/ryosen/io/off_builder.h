// Builds the mesh from the vertices and faces of an OFF file, text or binary.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ryosen/io/face_list.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/io/off.h"
#include "ryosen/io/off_order.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

class OffBuilder {
 public:
  explicit OffBuilder(OffKind kind) : kind_(kind), faces_(file_.mesh) {}

  // Number of values before and after the colour of a vertex.
  std::size_t numbers_before_colour() const { return kind_.has_normals ? 6 : 3; }
  std::size_t numbers_after_colour() const { return kind_.has_texcoords ? 2 : 0; }

  // Adds a vertex from its `count` values in file order, at least those before and after the colour. Returns false if
  // values without a meaning were ignored.
  bool add_vertex(const double* values, std::size_t count, std::uint64_t line = 0);
  void add_corner(std::int64_t vertex) { faces_.add_corner(vertex); }
  // Ends the face with `count` colour values; false if that count has no meaning. Colours written as integers, or with
  // a value above 1, range over 0..255.
  bool end_face(std::uint64_t line, const double* colour, std::size_t count, bool are_whole);

  void reserve(std::size_t vertices, std::size_t faces);
  // Whether `more` would overflow the 32-bit numbering of vertices, faces or corners.
  bool is_full(std::size_t more) const { return faces_.is_full(more); }

  Reporter& reporter() { return reporter_; }
  MeshFile& file() { return file_; }
  // Quarantines the unusable faces and returns the file.
  MeshFile finish();

 private:
  void add_colour(const double* values, std::size_t count);
  void put_colours_first();
  void scale_byte_colours();

  OffKind kind_;
  MeshFile file_;
  FaceList faces_;
  Reporter reporter_;
  OffOrder order_;
};

}  // namespace ryosen
