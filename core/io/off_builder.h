// Makes the mesh from the vertices and faces of an OFF file, however they are coded.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/io/face_list.h"
#include "core/io/mesh_file.h"
#include "core/io/off.h"
#include "core/io/reporter.h"

namespace ryosen {

class OffBuilder {
 public:
  explicit OffBuilder(OffKind kind) : kind_(kind), faces_(file_.mesh) {}

  // Numbers that every vertex has before its colour and after it.
  std::size_t numbers_before_colour() const { return kind_.has_normals ? 6 : 3; }
  std::size_t numbers_after_colour() const { return kind_.has_texcoords ? 2 : 0; }

  // Takes the numbers of a vertex in the order of the file, `count` of them. Numbers without a meaning are left out,
  // which the result tells; there must be enough for what stands before and after the colour.
  bool add_vertex(const double* values, std::size_t count, std::uint64_t line = 0);
  void add_corner(std::int64_t vertex) { faces_.add_corner(vertex); }
  // Ends the face; count is how many colour numbers follow it, false if that many have no meaning. Colours of whole
  // numbers, as written, count from 0 to 255, as do those with a number above one.
  bool end_face(std::uint64_t line, const double* colour, std::size_t count, bool are_whole);

  void reserve(std::size_t vertices, std::size_t faces);
  // The 32-bit numbers that can count vertices, faces and corners.
  bool is_full(std::size_t more) const { return faces_.is_full(more); }

  Reporter& reporter() { return reporter_; }
  MeshFile& file() { return file_; }
  // Sets the unusable faces aside and hands the file over.
  MeshFile finish();

 private:
  void add_colour(const double* values, std::size_t count);
  void scale_byte_colours();

  OffKind kind_;
  MeshFile file_;
  FaceList faces_;
  Reporter reporter_;
};

}  // namespace ryosen
