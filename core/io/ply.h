// PLY, the polygon file format of Stanford: ascii, binary of either byte order.
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

// Whether it begins with the word of the format.
Likeness looks_like_ply(std::string_view head, std::uint64_t size);

// Colours are uchar from 0 to 255 where that gives all of them exactly, else real from 0 to 1.
// The bytes of a PLY file in this encoding (little endian when automatic), with the elements and
// properties of the layout that the file came with, in its order. A type that cannot hold a value any more gives way to
// a wider one, which all components of a position, normal, texture coordinate or colour then have.
std::string write_ply(const MeshFile& file, Encoding encoding);

}  // namespace ryosen
