// Collects the faces of a file and quarantines the unusable ones once all vertices are known.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "ryosen/indexed/indexed.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

// Appends to the corners, face_offsets and face_lines of a mesh, which must outlive it. Vertex numbers may be anything
// until finish(). A format without lines passes line 0 for all faces, and face_lines stays empty. Memory: 4 bytes per
// corner, and 16 more for one that is negative or beyond 32 bits.
class FaceList {
 public:
  explicit FaceList(IndexedMesh& mesh) : mesh_(mesh) {}

  void add_corner(std::int64_t vertex) {
    if (vertex >= 0 && vertex < static_cast<std::int64_t>(no_index)) {
      mesh_.corners.push_back(static_cast<std::uint32_t>(vertex));
    } else {
      note_wide(mesh_.corners.size(), vertex);
      mesh_.corners.push_back(no_index);
    }
  }
  // For callers that write corners and face_offsets themselves: the actual number of a corner stored as no_index. Call
  // in ascending order of place.
  void note_wide(std::size_t place, std::int64_t vertex) { wide_.emplace_back(place, vertex); }

  // Ends the face; its corners are those added since the last call.
  void end_face(std::uint64_t line) {
    mesh_.face_offsets.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    if (line != 0) mesh_.face_lines.push_back(line < no_index ? static_cast<std::uint32_t>(line) : no_index);
  }

  // Appends the faces of another list, whose first line follows `lines_before` lines. Their vertex numbers refer to
  // this mesh. O(corners of the other).
  void append(const FaceList& next, std::uint64_t lines_before);

  // Whether one more line of `bytes` bytes could overflow the 32-bit numbering.
  bool is_full(std::size_t bytes) const { return mesh_.corners.size() + bytes >= no_index; }

  // Moves every face with fewer than three corners, an index out of range or a repeated corner into the quarantine,
  // with its texture coordinates and normals, and reports each. Repeated corners due to bridges are allowed. Needs the
  // final positions. Cost: O(corners).
  void finish(Reporter& reporter);

 private:
  enum class Flaw : std::uint8_t { none, too_few_corners, index_out_of_range, repeated_corner, bridged };

  struct FlawedFace {
    std::uint32_t face;
    Flaw flaw;
  };

  // Finds the flawed faces in begin .. end-1. `stamps` holds, per vertex, the last face that visited it.
  void find_flaws(std::uint32_t begin, std::uint32_t end, std::vector<FlawedFace>& flawed) const;
  Flaw flaw(std::size_t face, std::vector<std::uint32_t>& stamps) const;
  bool repeats_corner(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& stamps) const;
  QuarantinedFace set_aside(std::size_t face, Flaw flaw) const;
  void close_gaps(const std::vector<QuarantinedFace>& removed);

  IndexedMesh& mesh_;
  std::vector<std::pair<std::size_t, std::int64_t>> wide_;  // place in corners and the number, ascending
};

}  // namespace ryosen
