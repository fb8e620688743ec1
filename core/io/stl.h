// STL, ascii and binary: triangles by the coordinates of their corners.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/io/format.h"

namespace ryosen {

// Reads an STL file. Corners at equal coordinates (-0 = 0) become one vertex, numbered in the order of the corners; an
// info message tells how many there were. Whether a file is binary is told by its size, not by its first word. Solids
// become groups when they have a name or there are several; attribute bytes of a binary file are kept as a property of
// the faces unless all are zero, its head as a comment. Normals of facets are not kept; they follow from the corners. A
// facet that lacks bytes at the end of a binary file, or has other than three corners in ascii, is a warning; a count
// out of all proportion to the file, an unreadable number or an early end of an ascii file are errors. `path` is not
// used. Cost: O(bytes), one pass.
Result<MeshFile> read_stl(std::string_view bytes, const std::filesystem::path& path);

// Binary by its size, ascii by its first two words. One that is cut or longer is not sure.
Likeness looks_like_stl(std::string_view head, std::uint64_t size);

// The bytes of an STL file in this encoding (binary when automatic). Faces of more than three corners are cut into
// triangles, unless they were read from facets of so many.
std::string write_stl(const MeshFile& file, Encoding encoding);

// Whether a file of this size, which begins with `head` (at least 84 bytes), is as long as its count of facets says.
bool is_whole_binary_stl(std::string_view head, std::uint64_t size);

// Whether a file that begins so can be ascii: names may hold any other control character, while a binary file has a zero
// in its count, its coordinates or the padding of its head.
bool may_be_ascii_stl(std::string_view head);

// The 80 bytes that a binary file of this begins with: those that it was read with, else its first comment, else the plain
// ones.
std::string stl_head(const MeshFile& file);
// Whether the head that a binary file was read with says something that its comments do not.
bool has_wordless_head(const MeshFile& file);

// Whether a binary file may begin with this comment: it has room for it, and is not taken for something else then.
bool may_head_stl(std::string_view comment);

// What the head of a binary file says that has nothing else to say; read, it is no comment.
inline constexpr std::string_view stl_plain_head = "binary STL";
inline constexpr std::size_t stl_head_bytes = 80, stl_facet_bytes = 50;

}  // namespace ryosen
