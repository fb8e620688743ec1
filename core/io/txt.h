// The indexed triangle list of the source texts: the numbers of vertices and faces, a line of coordinates for each
// vertex, a line with three vertices counted from 1 for each face.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/io/format.h"

namespace ryosen {

// Reads such a list. The counts are claims that must fit the size of the file. A line with too few or too many numbers,
// or with one that cannot be read, is an error: nothing tells what it means. So is a list that plainly counts its
// vertices from 0. Faces that cannot be used go to the quarantine; lines beyond the counts are left out: each with a
// warning. `path` is not used. Cost: O(bytes), one pass.
Result<MeshFile> read_txt(std::string_view bytes, const std::filesystem::path& path);

// Two whole numbers, then a line of three numbers.
Likeness looks_like_txt(std::string_view head, std::uint64_t size);

// The bytes of such a list. Faces of more than three corners are cut into triangles, those in quarantine that
// TxtQuarantine does not hold are left out.
std::string write_txt(const MeshFile& file);

// Which faces in quarantine such a list can hold: those of three corners, whatever these are. But where several name the
// vertex before the first one and no face the last, they cannot be told from a list that counts from 0.
class TxtQuarantine {
 public:
  explicit TxtQuarantine(const IndexedMesh& mesh);  // O(corners) where a face is in quarantine

  bool holds(const QuarantinedFace& face) const;

 private:
  bool looks_zero_based_ = false;
};

}  // namespace ryosen
