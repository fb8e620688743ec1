// Samples of highlights for the legend, as the view draws them.
#pragma once

#include <optional>

#include "render/palette.h"
#include "ryosen/scene/highlights/highlight_table.h"

namespace ryosen {

// What the view draws of a highlight: lines of edges and around faces, points at vertices and in faces, tinted faces.
struct SwatchParts {
  bool has_line = false, has_point = false;
  std::optional<FaceTint> tint;
};
SwatchParts parts_of(const HighlightRow& row);

// The next item of the current ImGui window: as high as a line of text, with the patterns, widths and shapes of the
// view.
void swatch(const HighlightRow& row, Theme theme, float width_px, float scale);

}  // namespace ryosen
