// Colours and spacing of the panels, matched to the palette of the view.
#pragma once

#include <imgui.h>

#include "render/palette.h"

namespace ryosen {

// At scale 1.
inline constexpr float frame_padding_px = 4;

// Panel colours beyond Dear ImGui's own style.
struct UiColours {
  ImVec4 dim, accent, legal, refused, warning, backdrop, panel, line;
};
const UiColours& ui_colours(Theme theme);

// Sets the style of the current ImGui context; lengths are multiplied by `scale`.
void apply_style(Theme theme, float scale);

inline ImVec4 to_imgui(Rgba c) {
  return {static_cast<float>(c[0]) / 255, static_cast<float>(c[1]) / 255, static_cast<float>(c[2]) / 255,
          static_cast<float>(c[3]) / 255};
}
inline ImU32 to_imgui32(Rgba c) { return IM_COL32(c[0], c[1], c[2], c[3]); }

}  // namespace ryosen
