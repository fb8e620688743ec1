// A face is put on corners of which its sides may exist already.
#pragma once

#include <span>

#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

// A copy of v with room for new edges, preferring v, or none.
Vertex roomy_copy(const Mesh& mesh, Vertex v);

// The face on these corners, as make_face allows it: on free sides where there are any, on new edges elsewhere. Its
// points are to be made manifold then. Cost: the fans at its corners.
Face attach_face(Edit& edit, Sheets& sheets, std::span<const Vertex> corners);

}  // namespace ryosen
