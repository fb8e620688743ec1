// Curves on two logarithmic axes, with a list of their names and slopes; and a picture of such plots alone.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/ui/style.h"
#include "render/context/context.h"
#include "render/image.h"
#include "ryosen/base/result.h"

namespace ryosen {

struct LogCurve {
  std::string name;
  std::string slope;               // what stands behind the name; may be empty
  std::vector<glm::dvec2> points;  // those with both numbers above 0 are drawn
};

struct LogPlot {
  std::string title;
  std::string along, up;  // what the axes are
  std::string of_slopes;  // the heading of the column of slopes
  std::vector<LogCurve> curves;
};

// The room that a plot takes that is so wide: where that is little the list stands below the axes.
ImVec2 size_of_plot(const LogPlot& plot, float width_px);
// Draws it with the current font. Each curve has a colour and a shape of its points of its own.
void draw_log_plot(ImDrawList& list, ImVec2 corner, float width_px, const LogPlot& plot, Theme theme);

// A picture of so many plots side by side, row by row, as high as they need, by the program's own renderer, without a
// display. Fails with ExitCode::no_backend.
Result<Image> picture_of_plots(std::span<const LogPlot> plots, int columns, int width_px, Theme theme,
                               Language language, Backend backend = Backend::automatic);

}  // namespace ryosen
