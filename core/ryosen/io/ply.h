// Reader and writer for PLY, the Stanford polygon file format: ascii, and binary in either byte order.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ryosen/io/format.h"

namespace ryosen {

// Reads a PLY file. Positions, normals, texture coordinates and colours per vertex, the faces, their colours and the
// texture coordinates of their corners become the mesh, further properties of vertices, faces and edges its attributes
// (ply_attributes.h); all other lists and elements are kept in MeshFile::properties, with the layout of the file and
// unknown header lines. Reals of ascii files are read as doubles
// whatever the declared type; 64-bit integers in the mesh become doubles, with a warning if rounded. Triangle strips
// become faces (see PlyBuilder::take_strips). The lines of the header end as its first one: LF, CR LF, CR or LF CR.
// Counts in the header are checked against the size of the file. Unreadable numbers, negative lengths and an early end
// are errors, with line or byte; so is binary data in the other byte order, if every face shows it. Unusable faces are
// quarantined. Where the file has exactly as many numbers as its header announces, rows may be spread over lines, with
// a warning, and vertices without z lie in the plane z = 0. `path` is not used. Cost: O(bytes), one pass, two where
// rows are spread.
Result<MeshFile> read_ply(std::string_view bytes, const std::filesystem::path& path);

// Whether it starts with the keyword of the format.
Likeness looks_like_ply(std::string_view head, std::uint64_t size);

// Serialises to PLY in this encoding (automatic: little endian), with the elements and properties of the file's layout,
// in its order. Attributes are properties of their names and types, those of corners lists; what a property cannot say
// of one stands in a comment. A type that cannot hold a value is widened, together for all components of a position,
// normal, texture coordinate or colour; a float of a text has the shortest digits of one. Colours are uchar if all of
// them mean bytes (byte_meant), or if they were (rounded then), else real 0..1.
std::string write_ply(const MeshFile& file, Encoding encoding);

}  // namespace ryosen
