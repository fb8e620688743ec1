// Strips of triangles, as some PLY files have them in place of faces.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "ryosen/base/result.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen {

// The vertex numbers of the strips if a table is one of strips (element tristrips with a list of whole numbers), else
// null.
const Property* strip_corners(const PropertyTable& table);

// Appends the triangles of all strips to the faces, behind those of the element face, and gives the strips up: they
// would say the same again. -1 ends a strip (in unsigned types the largest number, if no vertex has it); every second
// triangle is turned over; a triangle that has a vertex twice only joins two strips and is no face. A strip of one or
// two vertices is reported. `places`: the line of each row, in binary files its byte. Fails if corners do not fit 32
// bits. O(numbers).
std::optional<Failure> take_strips(MeshFile& file, FaceList& faces, std::span<const std::uint64_t> places,
                                   Reporter& reporter);

}  // namespace ryosen
