// Reader and writer for OFF, Geomview's Object File Format, with its variants COFF, NOFF, STOFF and combinations.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "ryosen/io/format.h"

namespace ryosen {

// The per-vertex data declared by the first word of an OFF file, whose letters may have any order: the numbers of a
// vertex are its place, normal, colour and texture coordinate.
struct OffKind {
  bool has_texcoords = false;        // ST
  bool has_colours = false;          // C
  bool has_normals = false;          // N
  bool is_three_dimensional = true;  // neither 4 nor n

  // None if the word is not one of the format.
  static std::optional<OffKind> from_word(std::string_view word);
};

// The digits directly after the keyword of the format, as in OFF8 6 12; empty if there are none.
std::string_view off_count_behind(std::string_view word);

// Reads an OFF file, text or binary. The counts in its header are checked against the size of the file. Unreadable
// numbers, lines with too few numbers and an early end are errors, unless reading by words succeeds (see
// read_off_words); unusable faces are quarantined, lines beyond the counts are ignored, colours that stand before
// normals are recognised (see OffOrder): each with a warning. Per-vertex values go to the corner pools, one entry per
// vertex. A face colour ranges over 0..255 if all its numbers are written as integers or one exceeds 1, else over 0..1.
// `path` is not used. Cost: O(bytes).
Result<MeshFile> read_off(std::string_view bytes, const std::filesystem::path& path);

// Whether it starts with the keyword of the format.
Likeness looks_like_off(std::string_view head, std::uint64_t size);

// Serialises to text OFF: the polygons, quarantined ones in their place, colours, and texture coordinates and normals
// if equal at all corners of each vertex. Colours are integers 0..255 if the file had such, else reals with a decimal
// point.
std::string write_off(const MeshFile& file);

}  // namespace ryosen
