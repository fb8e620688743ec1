// Builds the mesh from the lines of an OBJ file, one call per line.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ryosen/base/enum_table.h"
#include "ryosen/base/result.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {

// Each call takes the text after the keyword of the line that `lines` read last, parses and checks its numbers, and
// keeps the first fault. After an unreadable value, further lines are only checked for more of them. Once is_done(),
// only finish() needs to be called.
class ObjBuilder {
 public:
  enum class NameKind { object, group, material, smoothing };

  // Both must outlive the builder. A builder for a later piece of a file gives up on lines that depend on earlier ones
  // (negative indices, elements, libraries), and on any that needs a message.
  ObjBuilder(const TextLines& lines, const std::filesystem::path& model, bool is_later_piece = false);

  void comment(std::string_view line);
  void vertex(std::string_view values);
  void texcoord(std::string_view values);
  void normal(std::string_view values);
  void face(std::string_view corners);
  void element(bool is_points, std::string_view corners);
  void name(NameKind kind, std::string_view text);
  void material_library(std::string_view text);
  void unknown(std::string_view keyword);

  bool is_done() const { return faults_.is_stopped() || has_given_up_; }
  Result<MeshFile> finish();

  // Whether the builder of a later piece has processed all of its lines.
  bool is_joinable() const { return !is_done() && reporter_.is_empty(); }
  // An earlier line had a fault: contents are no longer stored.
  bool has_fault() const { return faults_.any(); }
  // Moves in the contents of the builders of the next pieces, which must not be used afterwards. `lines_before` is the
  // number of lines before them; returns it including theirs. O(size of the pieces).
  std::uint64_t append(std::span<ObjBuilder* const> run, std::uint64_t lines_before, unsigned threads);
  // The following calls refer to these lines.
  void continue_with(const TextLines& lines) { lines_ = &lines; }
  // Reserves memory for the contents of all pieces.
  void reserve_for(std::span<ObjBuilder* const> pieces);

 private:
  struct Corner {
    std::int64_t vertex = 0, texcoord = 0, normal = 0;
    bool has_texcoord = false, has_normal = false;
  };
  // Interns names.
  struct NameTable {
    FaceNames* target = nullptr;
    std::unordered_map<std::string, std::uint32_t> numbers;
    std::uint32_t current = no_index;
    // In a later piece: whether one of its lines has set the current name, and the number of its faces before that.
    bool is_set = false;
    std::size_t faces_before = 0;
  };
  struct UnknownKeyword {
    std::string text;
    std::uint64_t line = 0;
    std::uint64_t count = 0;
  };

  template <class MakeText>
  bool fail(Code code, const char* at, MakeText text);
  bool read_reals(std::string_view text, double* values, std::size_t wanted, std::size_t most, std::size_t& count);
  bool read_value(std::string_view word, double& value);
  bool read_corner(std::string_view word, Corner& corner);
  void warn_extra_values(std::size_t count);
  std::uint32_t resolve_value(std::int64_t index, std::size_t pool, bool is_normal);
  void push_value(std::vector<std::uint32_t>& indices, bool has, std::int64_t index, std::size_t pool, bool is_normal);
  void end_names();
  void warn_of_taken_lines();
  bool has_room(std::size_t bytes);
  void append_points(ObjBuilder& next, std::uint64_t lines_before);
  void append_faces(ObjBuilder& next, std::uint64_t lines_before);
  void append_values(const CornerValues& next, std::size_t next_corners, CornerValues& values);
  void append_names(const NameTable& next, std::size_t next_faces, NameTable& table);
  static std::uint32_t number_of(const std::string& name, NameTable& table);
  static Text stray_value_text(bool is_normal, std::int64_t index);

  void drop_stray_values(CornerValues& values, bool is_normal);
  void check_elements();
  void report_unknown();

  const TextLines* lines_;
  const std::filesystem::path& model_;
  MeshFile file_;
  IndexedMesh& mesh_;
  FaceList faces_;
  Reporter reporter_;
  Faults faults_;
  std::array<NameTable, enum_count<NameKind>> names_;
  std::vector<UnknownKeyword> unknown_;
  std::uint64_t other_unknown_ = 0;  // lines whose keyword is not in unknown_, which is limited
  std::unordered_set<std::string> libraries_;
  bool in_head_ = true;
  bool has_known_line_ = false;
  bool some_lack_alpha_ = false;  // of the colours
  const bool is_later_piece_;
  bool has_given_up_ = false;
};

}  // namespace ryosen
