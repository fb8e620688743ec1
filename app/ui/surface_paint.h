// What the surface is painted with: the values of a colour map, else the colours of the file.
#pragma once

#include "render/mesh_buffers.h"

namespace ryosen {

class Document;
class Findings;
struct ViewState;

// Whether the surface has colours beside its own.
bool is_painted(const Document& document, const ViewState& view);
// Sets paint and colours of the source, where there are any. It reads the session for as long as it is used.
void paint_surface(const Document& document, Findings& findings, const ViewState& view, TriangleSource& source);

}  // namespace ryosen
