// The parts of ObjBuilder that need the whole file, and library lines.
#include <algorithm>
#include <cmath>

#include "ryosen/io/byte_colours.h"
#include "ryosen/io/material_libraries.h"
#include "ryosen/io/obj_builder.h"

namespace ryosen {
namespace {

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

}  // namespace

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

void ObjBuilder::report_whole_file() {
  warn_of_missing_elements(reporter_, mesh_.positions.size(), mesh_.face_count());
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
  report_whole_file();
  if (mesh_.texcoords.components == 0) mesh_.texcoords.components = 3;
  scale_bytes(file_, some_lack_alpha_);
  file_.left_out = reporter_.left_out();
  file_.messages = reporter_.take();
  return std::move(file_);
}

}  // namespace ryosen
