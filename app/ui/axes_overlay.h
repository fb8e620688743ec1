// The axes in the corner of the view, as the renderer draws them.
#pragma once

#include "render/overlay.h"
#include "render/palette.h"

namespace ryosen {

class Pointing;
struct Preferences;
struct ViewState;

// Nothing where they are not shown.
Overlay axes_overlay(const ViewState& view, const Pointing& pointing, const Preferences& preferences, Theme theme);

}  // namespace ryosen
