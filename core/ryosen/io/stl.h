// Reader and writer for STL, ascii and binary.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "ryosen/io/format.h"

namespace ryosen {

// Reads an STL file. Corners at equal coordinates (-0 = 0) become one vertex, numbered in the order of the corners; an
// info message gives the counts. Binary files are recognised by their size, not by the first word. Solids become groups
// if they have a name or there are several; attribute bytes of a binary file are kept as a face property unless all are
// zero, its header as a comment. Facet normals are not kept; they follow from the corners. A truncated last facet of a
// binary file, or an ascii facet without exactly three corners, is a warning; an implausible count, an unreadable
// number or an early end of an ascii file is an error. `path` is not used. Cost: O(bytes), one pass.
Result<MeshFile> read_stl(std::string_view bytes, const std::filesystem::path& path);

// Binary by its size, ascii by its first two words. Not sure if a binary file is too short or too long.
Likeness looks_like_stl(std::string_view head, std::uint64_t size);

// Serialises to STL in this encoding (automatic: binary). Faces with more than three corners are triangulated, unless
// they were read from such facets.
std::string write_stl(const MeshFile& file, Encoding encoding);

// Whether the size of a file that starts with `head` (at least 84 bytes) matches its facet count.
bool is_whole_binary_stl(std::string_view head, std::uint64_t size);

// Whether a file with this start can be ascii, that is, contains no zero byte. Names may contain any other control
// character, while a binary file has zeros in its count, its coordinates or its header's padding.
bool may_be_ascii_stl(std::string_view head);

// The 80-byte header for writing a binary file: the one read, else the first comment, else the default.
std::string stl_head(const MeshFile& file);
// Whether the header read from a binary file is not reproduced by its comments.
bool has_wordless_head(const MeshFile& file);

// Whether a comment can be the header of a binary file: it fits and is not mistaken for something else.
bool may_head_stl(std::string_view comment);

// The default header of binary files; not read as a comment.
inline constexpr std::string_view stl_plain_head = "binary STL";
inline constexpr std::size_t stl_head_bytes = 80, stl_facet_bytes = 50;

}  // namespace ryosen
