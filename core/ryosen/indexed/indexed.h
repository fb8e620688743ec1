// An indexed face set as files store it: points and, per face, the numbers of its corners. Readers produce it,
// from_indexed converts it to a Mesh, to_indexed converts back for writing.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/compact_list.h"
#include "ryosen/base/handle.h"
#include "ryosen/base/message.h"
#include "ryosen/indexed/line_runs.h"

namespace ryosen {

// A face that cannot take part in the connectivity. It keeps its number, so the numbering of the file stays. A
// malformed file may have one for every byte or two, so it is small: 40 bytes, and one allocation per non-empty list.
struct QuarantinedFace {
  std::uint32_t face = 0;              // its number in the file, from 0
  std::uint32_t line = 0;              // from 1; 0 when the format has no lines
  Code code = "face_too_few_corners";  // the cause: this, index_out_of_range or repeated_corner
  CompactList<std::int64_t> corners;   // vertex numbers from 0; out of range values (negative, too large) are kept
  CompactList<std::uint32_t> texcoords, normals;  // as in CornerValues::index; empty when the face has none

  // The message for the user, made from the code and the corners.
  Text cause() const;
  // Whether all its corners are valid numbers below `vertices`, whatever the cause.
  bool has_corners_within(std::size_t vertices) const;
};

// Maps a vertex number past the old end to the same distance past the new end, saturating.
constexpr std::int64_t past_new_end(std::int64_t number, std::int64_t old_end, std::int64_t new_end) {
  const std::int64_t past = number - old_end;
  return past > std::numeric_limits<std::int64_t>::max() - new_end ? std::numeric_limits<std::int64_t>::max()
                                                                   : past + new_end;
}

// Values given per corner through a pool, as OBJ does for texture coordinates and normals.
struct CornerValues {
  std::vector<glm::dvec3> pool;
  std::vector<std::uint32_t> index;  // one per corner, no_index where the corner has none; empty when unused
  int components = 3;                // how many of the three components the file gives
};

// Per face an index into a table of names (material, group, object, smoothing group).
struct FaceNames {
  std::vector<std::string> names;
  std::vector<std::uint32_t> index;  // one per face (quarantined ones too), no_index for none; empty when unused
};

// The colour component of an element for which the file gives no colour.
inline constexpr double no_colour = std::numeric_limits<double>::quiet_NaN();

// Colours per face, as in OFF: red, green, blue and optionally alpha in 0..1, or an index into a colour map.
struct FaceColours {
  std::vector<glm::dvec4> values;   // one per face (quarantined ones too); empty when unused
  std::vector<std::uint8_t> count;  // number of components of the face: 0, 1, 3 or 4
  bool are_bytes = false;           // the file gave some as 0..255
};

struct IndexedMesh {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> corners;          // vertex numbers, face after face
  std::vector<std::uint32_t> face_offsets{0};  // faces + 1 entries; a quarantined face has an empty range
  std::vector<QuarantinedFace> quarantine;     // ascending by face
  // Faces with rings, whose corner lists repeat vertices because they traverse bridges in both directions
  // (mesh/bridges.h). Ascending.
  std::vector<std::uint32_t> bridged;
  std::vector<std::uint32_t> face_lines;  // line of each face, from 1; empty when the format has no lines
  LineRuns vertex_lines;                  // of each vertex; empty if the format has no lines for them

  CornerValues texcoords;
  CornerValues normals;
  // Red, green, blue, alpha in 0..1, one per vertex; red is NaN if a vertex has none. Empty when unused.
  std::vector<glm::dvec4> vertex_colours;
  int colour_components = 3;           // 4 when the file gives alpha
  std::vector<double> vertex_weights;  // the w of OBJ, NaN if a vertex has none; empty when unused
  FaceColours face_colours;
  FaceNames materials, groups, objects, smoothing;

  std::size_t face_count() const { return face_offsets.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t f) const {
    return {corners.data() + face_offsets[f], face_offsets[f + 1] - face_offsets[f]};
  }
};

// The pool index for each vertex, if all corners of each vertex have the same value; none if some differ, if corners
// lack a value, or if no vertex has one. An isolated vertex gets the entry with its own number if the pool has one
// entry per vertex, as readers of per-vertex values produce. O(corners).
std::optional<std::vector<std::uint32_t>> per_vertex(const IndexedMesh& mesh, const CornerValues& values);

// The value of a pool; zeros for no_index.
inline glm::dvec3 value_of(const CornerValues& values, std::uint32_t index) {
  return index < values.pool.size() ? values.pool[index] : glm::dvec3(0.0);
}

}  // namespace ryosen
