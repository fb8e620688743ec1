// The parts of ObjBuilder behind its lines: joining of the builders of pieces, and what needs the whole file; and
// library lines.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/io/byte_colours.h"
#include "ryosen/io/obj_builder.h"

namespace ryosen {
namespace {

struct MaterialLibraries {
  std::vector<std::string> missing;
  std::vector<std::string> no_files;  // there, but folders, pipes or devices
  std::vector<std::string> unknown;   // in a folder that may not be looked into
  std::vector<std::string> outside;   // absolute, or outside the model's folder: not checked
};

// Longer names cannot be file names; splitting them would only cost time.
constexpr std::size_t longest_name = 4096;

enum class Library { found, missing, no_file, unknown, outside };

Library look_for(std::string name, const std::filesystem::path& folder) {
  if (name.size() > longest_name) return Library::missing;
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
  const bool has_drive = name.size() >= 2 && name[1] == ':';
  if (path.is_absolute() || has_drive || path.begin() == path.end() || *path.begin() == "..") return Library::outside;
  std::error_code error;
  switch (std::filesystem::status(folder / path, error).type()) {
    case std::filesystem::file_type::regular:
      return Library::found;
    case std::filesystem::file_type::not_found:
      return Library::missing;
    case std::filesystem::file_type::none:
      return Library::unknown;
    default:
      return Library::no_file;
  }
}

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> names(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool keeps_space = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == ' ';
    if (keeps_space) {
      names.back() += ' ';
      ++i;
    } else if (text[i] != ' ' && text[i] != '\t') {
      names.back() += text[i];
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (names.back().empty()) names.pop_back();
  return names;
}

// `text` follows mtllib: one name with spaces, or several names separated by spaces (a backslash escapes a space or is
// a path separator). `folder` is the model's; empty means the current folder.
MaterialLibraries look_for_libraries(std::string_view text, const std::filesystem::path& folder) {
  constexpr std::size_t most_names = 16;
  MaterialLibraries out;
  if (look_for(std::string(text), folder) == Library::found) return out;
  std::vector<std::string> names = split(text);
  if (names.size() > most_names) names.resize(most_names);
  for (std::string& name : names) {
    switch (look_for(name, folder)) {
      case Library::found:
        break;
      case Library::missing:
        out.missing.push_back(std::move(name));
        break;
      case Library::no_file:
        out.no_files.push_back(std::move(name));
        break;
      case Library::unknown:
        out.unknown.push_back(std::move(name));
        break;
      case Library::outside:
        out.outside.push_back(std::move(name));
        break;
    }
  }
  return out;
}

// Limit on distinct library lines looked up on disk.
constexpr std::size_t most_libraries = 100;

// Clears indices that are all none.
void drop_if_all_none(std::vector<std::uint32_t>& indices) {
  if (std::all_of(indices.begin(), indices.end(), [](std::uint32_t index) { return index == no_index; }))
    indices = std::vector<std::uint32_t>();
}

// Colours are bytes where all their numbers are, and one is above 1: of those with alpha an alpha, since one of at most
// 1 is a share. An alpha of 1 beside colours without alpha is that of such a colour.
void scale_bytes(MeshFile& file, bool some_lack_alpha) {
  std::vector<glm::dvec4>& colours = file.mesh.vertex_colours;
  const int components = file.mesh.colour_components;
  const auto is_number = [&](const glm::dvec4& colour, int i) {
    return !std::isnan(colour.x) && i < components && !(i == 3 && some_lack_alpha && colour.w == 1);
  };
  bool is_large = false;
  for (const glm::dvec4& colour : colours)
    for (int i = 0; i < 4; ++i) {
      if (!is_number(colour, i)) continue;
      if (!(colour[i] >= 0 && colour[i] <= byte_scale && std::trunc(colour[i]) == colour[i])) return;
      is_large = is_large || (colour[i] > 1 && (components == 3 || i == 3));
    }
  if (!is_large) return;
  file.byte_colours = true;
  for (glm::dvec4& colour : colours)
    for (int i = 0; i < 4; ++i)
      if (is_number(colour, i)) colour[i] /= byte_scale;
}

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

void ObjBuilder::material_library(std::string_view text) {
  has_given_up_ = is_later_piece_;
  if (is_done() || faults_.any()) return;
  in_head_ = false;
  has_known_line_ = true;
  const std::string_view name = trimmed(text);
  const FilePlace place = FilePlace::at_line(lines_->first_line());
  if (name.empty()) {
    reporter_.leave_out(&LeftOut::lines);
    reporter_.warn("material_library_unnamed", place, [] {
      return Text{"The line mtllib names no file.", "mtllib の行にファイル名がありません。"};
    });
    return;
  }
  warn_of_taken_lines();
  if (!libraries_.insert(std::string(name)).second) return;
  file_.material_libraries.emplace_back(name);
  if (model_.empty() || libraries_.size() > most_libraries) return;
  const MaterialLibraries libraries = look_for_libraries(name, model_.parent_path());
  const auto warn = [&](const std::vector<std::string>& names, Code code, const Text& what) {
    for (const std::string& one : names)
      reporter_.warn(code, place, [&] {
        return Text{"The material library " + shown(one) + what.en, "マテリアルファイル " + shown(one) + what.ja};
      });
  };
  warn(libraries.missing, "material_library_missing",
       {" is not there; the names of its materials are kept.", " が見つかりません(マテリアル名は保持します)。"});
  warn(libraries.no_files, "material_library_no_file",
       {" is a folder, a pipe or a device, not a file; the names of its materials are kept.",
        " はファイルではありません(フォルダ、パイプ、デバイスなど)。マテリアル名は保持します。"});
  warn(libraries.unknown, "material_library_unknown",
       {" cannot be looked for, because its folder may not be read; the names of its materials are kept.",
        " は、フォルダを読めないため探せません(マテリアル名は保持します)。"});
  warn(libraries.outside, "material_library_outside",
       {" lies outside the model's folder and is not opened.", " はモデルのフォルダの外にあるため開きません。"});
}

Text ObjBuilder::stray_value_text(bool is_normal, std::int64_t index) {
  const std::string number = std::to_string(index);
  if (is_normal) {
    return {"Normal " + number + " does not exist; the face is kept and its corner has no normal.",
            "法線 " + number + " は存在しません。面は残し、その頂点の法線は外します。"};
  }
  return {"Texture coordinate " + number + " does not exist; the face is kept and its corner has none.",
          "テクスチャ座標 " + number + " は存在しません。面は残し、その頂点の座標は外します。"};
}

// Drops the indices past the end of the pool. Call it before faces are quarantined.
void ObjBuilder::drop_stray_values(CornerValues& values, bool is_normal) {
  const std::size_t pool = values.pool.size();
  const auto is_stray = [&](std::uint32_t index) { return index != no_index && index >= pool; };
  if (std::none_of(values.index.begin(), values.index.end(), is_stray)) return;
  const Code code = is_normal ? Code("normal_index_out_of_range") : Code("texture_index_out_of_range");
  for (std::size_t face = 0; face < mesh_.face_count(); ++face) {
    for (std::size_t i = mesh_.face_offsets[face]; i < mesh_.face_offsets[face + 1]; ++i) {
      if (!is_stray(values.index[i])) continue;
      const std::int64_t index = std::int64_t{values.index[i]} + 1;
      reporter_.leave_out(&LeftOut::values);
      reporter_.warn(code, FilePlace::at_line(mesh_.face_lines[face]),
                     [&] { return stray_value_text(is_normal, index); });
      values.index[i] = no_index;
    }
  }
}

void ObjBuilder::check_elements() {
  ElementList& elements = file_.elements;
  const auto vertex_count = static_cast<std::int64_t>(mesh_.positions.size());
  for (const LineElement& item : elements.items) {
    const auto begin = elements.vertices.begin() + item.first;
    const auto stray = std::find_if(begin, begin + item.count,
                                    [&](std::int64_t vertex) { return vertex < 0 || vertex >= vertex_count; });
    if (stray != begin + item.count) {
      reporter_.warn("element_index_out_of_range", FilePlace::at_line(item.line), [&] {
        const std::string number = std::to_string(*stray);
        return Text{"A line or point element names vertex " + number + " (counted from 0), which does not exist.",
                    "線または点の要素が、存在しない頂点 " + number + "(0 から数えて)を参照しています。"};
      });
    }
    if (elements.texcoords.empty()) continue;
    for (std::size_t i = item.first; i < item.first + item.count; ++i) {
      std::uint32_t& index = elements.texcoords[i];
      if (index == no_index || index < mesh_.texcoords.pool.size()) continue;
      const std::int64_t number = std::int64_t{index} + 1;
      reporter_.leave_out(&LeftOut::values);
      reporter_.warn("texture_index_out_of_range", FilePlace::at_line(item.line),
                     [&] { return stray_value_text(false, number); });
      index = no_index;
    }
  }
}

void ObjBuilder::report_unknown() {
  for (const UnknownKeyword& keyword : unknown_) {
    const std::string count = std::to_string(keyword.count);
    const bool one = keyword.count == 1;
    reporter_.leave_out(&LeftOut::lines, keyword.count);
    reporter_.warn("unknown_keyword", FilePlace::at_line(keyword.line), [&] {
      return Text{(one ? "One line that begins" : count + " lines that begin") + std::string(" with ") + keyword.text +
                      (one ? " is" : " are") + " not understood and left out.",
                  keyword.text + " で始まる行(" + count + " 行)は解釈できないため読み飛ばしました。"};
    });
  }
  reporter_.leave_out(&LeftOut::lines, other_unknown_);
  if (other_unknown_ == 0) return;
  reporter_.warn("unknown_keyword", {}, [&] {
    const std::string count = std::to_string(other_unknown_);
    return Text{count + " lines with other unknown words at their beginning are left out.",
                "ほかにも、未知の語で始まる " + count + " 行を読み飛ばしました。"};
  });
}

Result<MeshFile> ObjBuilder::finish() {
  if (faults_.any()) return faults_.take();
  if (!has_known_line_ && !unknown_.empty()) {
    return malformed("not_obj",
                     {"No line of the file is one of OBJ; the first begins with " + unknown_.front().text + ".",
                      "OBJ の行が 1 つもありません。最初の行は " + unknown_.front().text + " で始まります。"},
                     FilePlace::at_line(unknown_.front().line));
  }
  if (!has_known_line_ && file_.head_comments.empty()) return empty_file();
  drop_stray_values(mesh_.texcoords, false);
  drop_stray_values(mesh_.normals, true);
  check_elements();
  faces_.finish(reporter_);
  drop_if_all_none(mesh_.texcoords.index);
  drop_if_all_none(mesh_.normals.index);
  drop_if_all_none(file_.elements.texcoords);
  report_unknown();
  if (mesh_.texcoords.components == 0) mesh_.texcoords.components = 3;
  scale_bytes(file_, some_lack_alpha_);
  return finished(file_, reporter_);
}

}  // namespace ryosen
