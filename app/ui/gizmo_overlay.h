// How the handles of the selection are drawn, and what guides the eye while it is moved, turned or scaled.
#pragma once

#include "render/overlay.h"
#include "render/palette.h"

namespace ryosen {

class Gesturing;
class Pointing;
struct ViewState;

// The handles, with the one under the pointer marked; or while a gesture lasts the axis or plane that it is bound to,
// the reach of its falloff, and what it snaps to.
Overlay gizmo_overlay(const ViewState& view, const Pointing& pointing, const Gesturing& gesturing, Theme theme);

}  // namespace ryosen
