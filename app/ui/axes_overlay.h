// The axes in the corner of the view, as the renderer draws them.
#pragma once

#include "render/overlay.h"
#include "render/palette.h"

namespace ryosen {

class Session;

// Nothing where they are not shown.
Overlay axes_overlay(const Session& session, Theme theme);

}  // namespace ryosen
