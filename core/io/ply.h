// Reader and writer for PLY, the Stanford polygon file format: ascii, and binary in either byte order.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/io/format.h"

namespace ryosen {

// Reads a PLY file. Positions, normals, texture coordinates and colours per vertex, the faces, their colours and the
// texture coordinates of their corners become the mesh; every other property and element is kept in
// MeshFile::properties as it is, with the layout of the file and the lines of its header that PLY does not know. Reals
// of ascii files are read exactly, whatever type is announced; whole numbers of 64 bits that become the mesh's are
// doubles there, with a warning where that rounds them. A count of the header is a claim that must fit the size of the
// file. Numbers that cannot be read, negative lengths and an early end are errors, with their line or byte; so is
// binary data of the other byte order, where it shows by every face. Faces that cannot be used go to the quarantine.
// Triangle strips are kept, not taken apart. `path` is not used. Cost: O(bytes), one pass.
Result<MeshFile> read_ply(std::string_view bytes, const std::filesystem::path& path);

// Whether it starts with the keyword of the format.
Likeness looks_like_ply(std::string_view head, std::uint64_t size);

// Serialises to PLY in this encoding (automatic: little endian), with the elements and properties of the file's layout,
// in its order. A type that cannot hold a value is widened, together for all components of a position, normal, texture
// coordinate or colour. Colours are uchar 0..255 if that is exact for all of them, else real 0..1.
std::string write_ply(const MeshFile& file, Encoding encoding);

}  // namespace ryosen
