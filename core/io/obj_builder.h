// Makes the mesh from the lines of an OBJ file, one call per line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/base/result.h"
#include "core/io/face_list.h"
#include "core/io/mesh_file.h"
#include "core/io/reporter.h"
#include "core/io/text_lines.h"

namespace ryosen {

// The calls take what follows the keyword of the line that `lines` has read last; they read its numbers anew, check
// them and keep the first failure. After a failure nothing more needs to be called but finish().
class ObjBuilder {
 public:
  enum class NameKind { object, group, material, smoothing };

  // Both must outlive the builder.
  ObjBuilder(const TextLines& lines, const std::filesystem::path& model);

  void comment(std::string_view line);
  void vertex(std::string_view values);
  void texcoord(std::string_view values);
  void normal(std::string_view values);
  void face(std::string_view corners);
  void element(bool is_points, std::string_view corners);
  void name(NameKind kind, std::string_view text);
  void material_library(std::string_view text);
  void unknown(std::string_view keyword);

  bool has_failed() const { return failure_.has_value(); }
  Result<MeshFile> finish();

 private:
  struct Corner {
    std::int64_t vertex = 0, texcoord = 0, normal = 0;
    bool has_texcoord = false, has_normal = false;
  };
  // Finds the number of a name by its text.
  struct NameTable {
    FaceNames* target = nullptr;
    std::unordered_map<std::string, std::uint32_t> numbers;
    std::uint32_t current = no_index;
  };
  struct UnknownKeyword {
    std::string text;
    std::uint64_t line = 0;
    std::uint64_t count = 0;
  };

  void fail(std::string_view code, Text text, const char* at);
  void fail_number(std::string_view word);
  bool read_reals(std::string_view text, double* values, std::size_t wanted, std::size_t most, std::size_t& count);
  bool read_value(std::string_view word, double& value);
  bool read_corner(std::string_view word, Corner& corner);
  void keep_extras(std::size_t vertex, const double* values, std::size_t count);
  void warn_extra_values(std::size_t count);
  std::uint32_t resolve_value(std::int64_t index, std::size_t pool, bool is_normal);
  void push_value(std::vector<std::uint32_t>& indices, bool has, std::int64_t index, std::size_t pool, bool is_normal);
  void end_names();
  bool has_room(std::size_t bytes);
  static Text stray_value_text(bool is_normal, std::int64_t index);

  void drop_stray_values(CornerValues& values, bool is_normal);
  void check_elements();
  void report_unknown();
  void report_whole_file();

  const TextLines& lines_;
  const std::filesystem::path& model_;
  MeshFile file_;
  IndexedMesh& mesh_;
  FaceList faces_;
  Reporter reporter_;
  std::optional<Failure> failure_;
  NameTable names_[4];
  std::vector<UnknownKeyword> unknown_;
  std::uint64_t other_unknown_ = 0;  // lines whose keyword is not in unknown_, which has a limit
  std::unordered_set<std::string> libraries_;
  bool in_head_ = true;
  bool has_known_line_ = false;
};

}  // namespace ryosen
