// Reader and writer for the indexed triangle list of the source texts: the numbers of vertices and faces, a line of
// coordinates per vertex, a line with three vertices (from 1) per face.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ryosen/io/format.h"

namespace ryosen {

// Reads such a list. The counts are checked against the size of the file. A line with too few or too many numbers, or
// an unreadable one, is an error, as is a list that evidently counts vertices from 0. Unusable faces are quarantined
// and lines beyond the counts ignored, each with a warning. `path` is not used. Cost: O(bytes), one pass.
Result<MeshFile> read_txt(std::string_view bytes, const std::filesystem::path& path);

// Two integers, then a line of three numbers.
Likeness looks_like_txt(std::string_view head, std::uint64_t size);

// Serialises to such a list. Faces with more than three corners are triangulated; quarantined ones that TxtQuarantine
// rejects are omitted.
std::string write_txt(const MeshFile& file);

// Which quarantined faces such a list can hold: those with three corners of any value. But if several reference vertex
// -1 and no face references the last one, the result would look like a list that counts from 0.
class TxtQuarantine {
 public:
  explicit TxtQuarantine(const IndexedMesh& mesh);  // O(corners) if any face is quarantined

  bool holds(const QuarantinedFace& face) const;

 private:
  bool looks_zero_based_ = false;
};

}  // namespace ryosen
