// An indexed face set as files store it: points and, per face, the numbers of its corners. Readers produce it,
// from_indexed converts it to a Mesh, to_indexed converts back for writing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ryosen/base/handle.h"
#include "ryosen/base/message.h"
#include "ryosen/mesh/columns.h"

namespace ryosen {

// An array of trivially copyable values that costs one pointer while empty; for structs that a file may hold by the
// million. Contiguous like a vector, but resized only by assigning it as a whole. One allocation if not empty, none
// otherwise. Copies are deep; a moved-from list is empty.
template <class Value>
class CompactList {
  static_assert(std::is_trivially_copyable_v<Value> && alignof(Value) <= sizeof(std::size_t));

 public:
  using value_type = Value;
  using iterator = Value*;
  using const_iterator = const Value*;

  CompactList() = default;
  CompactList(std::initializer_list<Value> values) { assign(values.begin(), values.end()); }
  CompactList(const std::vector<Value>& values) { assign(values.begin(), values.end()); }
  CompactList(const CompactList& other) { assign(other.begin(), other.end()); }
  CompactList(CompactList&& other) noexcept = default;
  CompactList& operator=(const CompactList& other) {
    if (this != &other) assign(other.begin(), other.end());
    return *this;
  }
  CompactList& operator=(CompactList&& other) noexcept = default;
  ~CompactList() = default;

  // The range must not lie in this list.
  template <class Iterator>
  void assign(Iterator first, Iterator last) {
    const auto count = static_cast<std::size_t>(std::distance(first, last));
    block_.reset();
    if (count == 0) return;
    block_ = std::make_unique<std::byte[]>(sizeof count + count * sizeof(Value));
    std::memcpy(block_.get(), &count, sizeof count);
    std::copy(first, last, begin());
  }
  void clear() { block_.reset(); }

  bool empty() const { return !block_; }
  std::size_t size() const {
    std::size_t count = 0;
    if (block_) std::memcpy(&count, block_.get(), sizeof count);
    return count;
  }
  Value* data() { return block_ ? reinterpret_cast<Value*>(block_.get() + sizeof(std::size_t)) : nullptr; }
  const Value* data() const {
    return block_ ? reinterpret_cast<const Value*>(block_.get() + sizeof(std::size_t)) : nullptr;
  }
  Value* begin() { return data(); }
  Value* end() { return data() + size(); }
  const Value* begin() const { return data(); }
  const Value* end() const { return data() + size(); }
  Value& operator[](std::size_t i) { return data()[i]; }
  const Value& operator[](std::size_t i) const { return data()[i]; }

  friend bool operator==(const CompactList& a, const CompactList& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::unique_ptr<std::byte[]> block_;  // the count, then the values
};

// The line number of each element of a file, run-length encoded (consecutive lines form a run): a few bytes for most
// files.
class LineRuns {
 public:
  // Appends the line of the next element, from 1.
  void add(std::uint64_t line) { add(line, 1); }
  // Appends the lines of as many elements, one after the other.
  void add(std::uint64_t line, std::size_t elements) {
    if (elements == 0) return;
    begin_run({count_, line});
    count_ += static_cast<std::uint32_t>(elements);
  }
  // Appends the elements of a part of the file that starts after `lines_before` lines. O(runs).
  void append(const LineRuns& next, std::uint64_t lines_before) {
    for (const Run& run : next.runs_) begin_run({count_ + run.first, lines_before + run.line});
    count_ += next.count_;
  }
  friend bool operator==(const LineRuns&, const LineRuns&) = default;
  // The line of an element, 0 if none was added. O(log runs).
  std::uint64_t line(std::uint32_t element) const {
    if (element >= count_) return 0;
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), element,
                                        [](std::uint32_t e, const Run& r) { return e < r.first; });
    return line_in(*(after - 1), element);
  }

 private:
  struct Run {
    std::uint32_t first;
    std::uint64_t line;
    friend bool operator==(const Run&, const Run&) = default;
  };
  // Starts a run unless it continues the last one.
  void begin_run(const Run& run) {
    if (runs_.empty() || line_in(runs_.back(), run.first) != run.line) runs_.push_back(run);
  }
  static std::uint64_t line_in(const Run& run, std::uint32_t element) { return run.line + (element - run.first); }

  std::vector<Run> runs_;
  std::uint32_t count_ = 0;
};

// A face that cannot take part in the connectivity. It keeps its number, so the numbering of the file stays. A
// malformed file may have one for every byte or two, so it is small: 48 bytes, and one allocation per non-empty list.
struct QuarantinedFace {
  std::uint32_t face = 0;              // its number in the file, from 0
  std::uint32_t line = 0;              // from 1; 0 when the format has no lines
  Code code = "face_too_few_corners";  // the cause: this, index_out_of_range or repeated_corner
  CompactList<std::int64_t> corners;   // vertex numbers from 0; out of range values (negative, too large) are kept
  CompactList<std::uint32_t> texcoords, normals;  // as in CornerValues::index; empty when the face has none
  // Words of the corner attributes of the list, one attribute after the other; empty when it has none.
  CompactList<std::uint32_t> values;

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

// An edge by the numbers of its ends, in the order in which the file has them.
struct ListedEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t row = no_index;  // its place among all edges of the file; no_index: behind them
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
  // Further attributes, named as in the mesh: of vertices and faces (quarantined ones too) by number, of corners by
  // place in `corners`, of edges by place in `edges`.
  std::vector<AttributeColumn> attributes;
  std::vector<ListedEdge>
      edges;  // edges of faces, or wires, that the file lists or that have values; each at most once

  std::size_t face_count() const { return face_offsets.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t f) const {
    return {corners.data() + face_offsets[f], face_offsets[f + 1] - face_offsets[f]};
  }
};

// Calls visit(face, corners) for each face in order, visit_aside(face) for those that are quarantined.
template <class Visit, class VisitAside>
void for_each_face(const IndexedMesh& mesh, Visit visit, VisitAside visit_aside) {
  auto aside = mesh.quarantine.begin();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (aside != mesh.quarantine.end() && aside->face == f)
      visit_aside(*aside++);
    else
      visit(f, mesh.face(f));
  }
}

// Each edge of the faces once, the smaller end first, in ascending order; bridges are none. O(n log n) in the corners.
std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_of_faces(const IndexedMesh& mesh);

// The pool index for each vertex, if all corners of each vertex have the same value; none if some differ, if corners
// lack a value, or if no vertex has one. An isolated vertex gets the entry with its own number if the pool has one
// entry per vertex, as readers of per-vertex values produce. O(corners).
std::optional<std::vector<std::uint32_t>> per_vertex(const IndexedMesh& mesh, const CornerValues& values);

// The value of a pool; zeros for no_index.
inline glm::dvec3 value_of(const CornerValues& values, std::uint32_t index) {
  return index < values.pool.size() ? values.pool[index] : glm::dvec3(0.0);
}

}  // namespace ryosen
