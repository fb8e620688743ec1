// The plane that a session cuts its mesh at.
#pragma once

#include "ryosen/scene/view/clip_plane.h"

namespace ryosen {

class Mesh;
struct ViewState;

// Cuts in the middle of the mesh, or no more. O(vertices), as the next one is.
void cut_across(const Mesh& mesh, ViewState& view, ClipWay way);
// Moves the plane, which there must be, so that this share of the extent of the mesh across it is kept.
void move_cut(const Mesh& mesh, ViewState& view, double share);

}  // namespace ryosen
