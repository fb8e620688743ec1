// The codes of messages: stable identifiers that scripts and tests may rely on, while sentences may change. To add one,
// write its id here and its row in codes.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

namespace ryosen {

// The severities with which a code occurs.
enum class CodeSeverity : std::uint8_t { error, warning, error_or_warning, info };

struct CodeRow {
  std::string_view id;
  CodeSeverity severity;
  std::string_view en, ja;  // a general sentence; the single message is more specific
  // About a file that the mesh does not depend on: such a warning does not set the exit code of `check`.
  bool is_about_other_file = false;
};

namespace codes {

// Grouped by topic, alphabetical within a group.
inline constexpr std::string_view ids[] = {
    // The command line and the lines of scripts.
    "bad_arguments",
    "bad_value",
    "element_unknown",
    "flag_missing",
    "flag_repeated",
    "flag_takes_no_value",
    "flags_exclude",
    "line_malformed",
    "name_ambiguous",
    "operand_missing",
    "operand_too_many",
    "output_missing",
    "unknown_command",
    "unknown_flag",
    "unknown_highlight",
    "unknown_operator",
    "unknown_tool",
    "usage",
    "value_missing",

    // Running the program.
    "cancelled",
    "command_failed",
    "image_sizes_differ",
    "internal_error",
    "mesh_refused",
    "no_display",
    "no_render_backend",
    "out_of_memory",
    "pictures_differ",
    "png_malformed",
    "refused",
    "shader_refused",

    // Input files and folders.
    "folder_empty",
    "folder_unreadable",
    "input_is_folder",
    "input_missing",
    "input_not_a_file",
    "input_unreadable",

    // File formats.
    "binary_content",
    "compressed_file",
    "compressed_twice",
    "content_mismatch",
    "empty_file",
    "gzip_cut",
    "gzip_damaged",
    "gzip_extra_data",
    "gzip_too_large",
    "not_obj",
    "not_off",
    "not_ply",
    "not_stl",
    "nul_byte",
    "unknown_format",
    "unsupported_dimension",
    "unsupported_format",
    "unsupported_version",
    "utf16",
    "wrong_byte_order",
    "zeros",

    // Headers and counts.
    "count_behind_word",
    "count_too_large",
    "missing_element",
    "missing_format",
    "missing_name",
    "missing_property",
    "negative_count",
    "property_without_element",
    "repeated_element",
    "too_many_elements",
    "unknown_encoding",
    "unknown_type",

    // Numbers, lines and elements of a file.
    "element_index_out_of_range",
    "extra_data",
    "extra_values",
    "face_too_few_corners",
    "facet_many_corners",
    "index_out_of_range",
    "material_library_missing",
    "material_library_no_file",
    "material_library_outside",
    "material_library_unknown",
    "material_library_unnamed",
    "missing_endsolid",
    "missing_number",
    "no_faces",
    "no_vertices",
    "nonfinite_number",
    "normal_index_out_of_range",
    "number_out_of_type",
    "points_without_z",
    "read_by_words",
    "repeated_corner",
    "rounded_number",
    "short_face",
    "texture_index_out_of_range",
    "tristrips_kept",
    "unexpected_end",
    "unknown_keyword",
    "unreadable_index",
    "unreadable_number",
    "welded",
    "zero_based",

    // What an output format cannot represent; the message gives the count.
    "keeps_vertices",
    "loses_comments",
    "loses_elements",
    "loses_exact_colours",
    "loses_extra_elements",
    "loses_face_colours",
    "loses_groups",
    "loses_head",
    "loses_isolated_vertices",
    "loses_libraries",
    "loses_large_numbers",
    "loses_materials",
    "loses_missing_colours",
    "loses_normals",
    "loses_objects",
    "loses_polygons",
    "loses_precision",
    "loses_properties",
    "loses_quarantined",
    "loses_rings",
    "loses_rules",
    "loses_small_numbers",
    "loses_smoothing",
    "loses_texcoords",
    "loses_third_texcoord",
    "loses_topology",
    "loses_unread_lines",
    "loses_unread_rest",
    "loses_unread_values",
    "loses_vertex_colours",
    "loses_weights",
    "loses_wires",

    // Outputs.
    "input_would_be_replaced",
    "name_hides_format",
    "output_is_folder",
    "output_not_durable",
    "output_not_writable",
    "output_would_be_replaced",
};

}  // namespace codes

// In the order of codes::ids.
std::span<const CodeRow> code_table();

// The code of a message. Constructed from a literal; an unknown code does not compile.
class Code {
 public:
  consteval Code(const char* id) : index_(find(id)) {}

  const CodeRow& row() const { return code_table()[index_]; }
  constexpr operator std::string_view() const { return codes::ids[index_]; }
  // Comparison with literals, and in tests with parsed text.
  friend constexpr bool operator==(Code a, Code b) { return a.index_ == b.index_; }
  friend constexpr bool operator==(Code a, std::string_view b) { return codes::ids[a.index_] == b; }
  friend constexpr bool operator==(Code a, const char* b) { return codes::ids[a.index_] == b; }

 private:
  static consteval std::size_t find(std::string_view id) {
    for (std::size_t i = 0; i < std::size(codes::ids); ++i)
      if (codes::ids[i] == id) return i;
    throw "a code that ryosen/base/codes.h does not have";
  }

  std::size_t index_;
};

}  // namespace ryosen
