// Builds the mesh from the vertices and faces of an OFF file, text or binary, and reads those forms of it that are not
// laid out line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ryosen/base/result.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/io/off.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

// The order of normal and colour behind the place of an OFF vertex. The format says the normal first. Some programs
// write the colour first; the numbers tell, since normals have the length 1 (to 0.01) and colours lie in 0..255.
class OffOrder {
 public:
  // The numbers of a vertex behind its place: the three of a normal and `colours` of a colour, 3 or 4.
  void add(const double* numbers, std::size_t colours) {
    has_vertex_ = true;
    normals_first_ = normals_first_ && is_normal(numbers) && is_colour(numbers + 3, colours);
    colours_first_ = colours_first_ && is_colour(numbers, colours) && is_normal(numbers + colours);
  }
  // Whether only this order makes sense of all vertices.
  bool is_colours_first() const { return has_vertex_ && colours_first_ && !normals_first_; }

 private:
  static bool is_normal(const double* n) {
    constexpr double least = 0.99 * 0.99, most = 1.01 * 1.01;
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    return square >= least && square <= most;
  }
  static bool is_colour(const double* numbers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      if (!(numbers[i] >= 0 && numbers[i] <= 255)) return false;
    return true;
  }

  bool has_vertex_ = false, normals_first_ = true, colours_first_ = true;
};

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

// Reads the data of a binary file after the BINARY line, from `start` on. The byte order, and whether each face is
// followed by a colour count as in the format's specification, are not stored in the file: the interpretation that is
// consistent and leaves the fewest bytes over is used.
Result<MeshFile> read_off_binary(std::string_view bytes, std::uint64_t start, OffKind kind);

// Reads the text form as nothing but words: the three counts (the first may stand right behind the word OFF), the
// numbers of every vertex, then for every face how many corners it has and these. Where a colour ends words cannot
// tell: those of vertices have all four or all three numbers, faces have none. None unless everything comes out exactly
// at the end of the file, every face has three or more corners that all exist, and the file is not laid out with a line
// for each vertex and face, so that damage is not taken for such a file.
//
// `line` is where reading by lines failed, for the warning (read_by_words). O(bytes); nothing is kept before all is
// right.
std::optional<MeshFile> read_off_words(std::string_view bytes, std::uint64_t line);

}  // namespace ryosen
