// Reader and writer for OFF, Geomview's Object File Format, with its variants COFF, NOFF, STOFF and combinations.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/io/format.h"

namespace ryosen {

// The per-vertex data declared by the first word of an OFF file.
struct OffKind {
  bool has_texcoords = false;        // ST
  bool has_colours = false;          // C
  bool has_normals = false;          // N
  bool is_three_dimensional = true;  // neither 4 nor n

  // None if the word is not one of the format.
  static std::optional<OffKind> from_word(std::string_view word);
};

// The digits that stand right behind the word of the format, as in OFF8 6 12; empty where there are none.
std::string_view off_count_behind(std::string_view word);

// Reads an OFF file, text or binary. The counts of its head are claims that must fit the size of the file. A number
// that cannot be read, a line with too few of them and an early end are errors, but where reading by words comes out
// (see read_off_words); faces that cannot be used go to the quarantine, lines beyond the claimed counts are left out:
// each with a warning. Values per vertex are put in the pools of the corners, one entry per vertex. The colour of a
// face counts from 0 to 255 if all its numbers are written as whole ones or one is above one, else from 0 to 1. `path`
// is not used. Cost: O(bytes).
Result<MeshFile> read_off(std::string_view bytes, const std::filesystem::path& path);

// Whether it starts with the keyword of the format.
Likeness looks_like_off(std::string_view head, std::uint64_t size);

// Serialises to text OFF: the polygons, quarantined ones in their place, colours, and texture coordinates and normals
// if equal at all corners of each vertex. Colours are integers 0..255 if the file had such, else reals with a decimal
// point.
std::string write_off(const MeshFile& file);

}  // namespace ryosen
