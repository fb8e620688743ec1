// Joining of the builders of the pieces of an OBJ file.
#include <algorithm>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/release.h"
#include "ryosen/io/obj_builder.h"

namespace ryosen {
namespace {

template <class Value>
void append_all(const std::vector<Value>& from, std::vector<Value>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

// Appends an optional column, which is empty when unused; `none` is the default value. `count` and `next_count` are the
// lengths that the columns have when in use.
template <class Value>
void append_optional(const std::vector<Value>& from, std::size_t next_count, const Value& none, std::size_t count,
                     std::vector<Value>& to) {
  if (from.empty() && to.empty()) return;
  if (to.empty()) to.assign(count, none);
  if (from.empty())
    to.resize(count + next_count, none);
  else
    append_all(from, to);
}

}  // namespace

void ObjBuilder::reserve_for(std::span<ObjBuilder* const> pieces) {
  std::size_t positions = 0, corners = 0, faces = 0;
  for (const ObjBuilder* piece : pieces) {
    positions += piece->mesh_.positions.size();
    corners += piece->mesh_.corners.size();
    faces += piece->mesh_.face_count();
  }
  reserve_large(mesh_.positions, positions);
  reserve_large(mesh_.corners, corners);
  reserve_large(mesh_.face_offsets, faces + 1);
  reserve_large(mesh_.face_lines, faces);
}

std::uint64_t ObjBuilder::append(std::span<ObjBuilder* const> run, std::uint64_t lines_before, unsigned threads) {
  std::uint64_t lines_after = lines_before;
  for_each_task(2, threads, [&](unsigned part) {
    std::uint64_t lines = lines_before;
    for (ObjBuilder* next : run) {
      part == 0 ? append_points(*next, lines) : append_faces(*next, lines);
      lines += next->lines_->count();
    }
    if (part == 0) lines_after = lines;
  });
  for (const ObjBuilder* next : run) {
    if (in_head_) append_all(next->file_.head_comments, file_.head_comments);
    in_head_ = in_head_ && next->in_head_;
    has_known_line_ = has_known_line_ || next->has_known_line_;
    some_lack_alpha_ = some_lack_alpha_ || next->some_lack_alpha_;
  }
  return lines_after;
}

void ObjBuilder::append_points(ObjBuilder& next, std::uint64_t lines_before) {
  const std::size_t points = mesh_.positions.size(), next_points = next.mesh_.positions.size();
  append_optional(next.mesh_.vertex_weights, next_points, no_colour, points, mesh_.vertex_weights);
  append_optional(next.mesh_.vertex_colours, next_points, glm::dvec4(no_colour, no_colour, no_colour, 1), points,
                  mesh_.vertex_colours);
  mesh_.colour_components = std::max(mesh_.colour_components, next.mesh_.colour_components);
  append_all(next.mesh_.positions, mesh_.positions);
  mesh_.vertex_lines.append(next.mesh_.vertex_lines, lines_before);
  release(next.mesh_.vertex_weights);
  release(next.mesh_.vertex_colours);
  release(next.mesh_.positions);
}

void ObjBuilder::append_faces(ObjBuilder& next, std::uint64_t lines_before) {
  append_values(next.mesh_.texcoords, next.mesh_.corners.size(), mesh_.texcoords);
  append_values(next.mesh_.normals, next.mesh_.corners.size(), mesh_.normals);
  for (std::size_t i = 0; i < 4; ++i) append_names(next.names_[i], next.mesh_.face_count(), names_[i]);
  faces_.append(next.faces_, lines_before);
  next.mesh_.texcoords = {};
  next.mesh_.normals = {};
  for (NameTable& table : next.names_) *table.target = {};
  release(next.mesh_.corners);
  release(next.mesh_.face_offsets);
  release(next.mesh_.face_lines);
}

void ObjBuilder::append_values(const CornerValues& next, std::size_t next_corners, CornerValues& values) {
  append_optional(next.index, next_corners, no_index, mesh_.corners.size(), values.index);
  append_all(next.pool, values.pool);
  values.components = std::max(values.components, next.components);
}

// Faces of the piece before its first name line have the name current at its start.
void ObjBuilder::append_names(const NameTable& next, std::size_t next_faces, NameTable& table) {
  std::vector<std::uint32_t> numbers;  // of the piece's names in this table
  for (const std::string& name : next.target->names) numbers.push_back(number_of(name, table));
  const auto number = [&](std::uint32_t theirs) { return theirs == no_index ? no_index : numbers[theirs]; };
  const std::size_t inherited = next.is_set ? next.faces_before : next_faces;
  std::vector<std::uint32_t> index(next_faces, no_index);
  std::fill_n(index.begin(), inherited, table.current);
  for (std::size_t face = inherited; face < next.target->index.size(); ++face)
    index[face] = number(next.target->index[face]);
  if (next.is_set) table.current = number(next.current);
  if (table.target->index.empty() && std::all_of(index.begin(), index.end(), [](auto i) { return i == no_index; }))
    return;
  append_optional(index, next_faces, no_index, mesh_.face_count(), table.target->index);
}

}  // namespace ryosen
