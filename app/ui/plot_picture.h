// A picture of plots alone, by the program's own renderer, without a display.
#pragma once

#include <span>

#include "app/ui/log_plot.h"
#include "render/context/context.h"
#include "render/image.h"
#include "ryosen/base/result.h"

namespace ryosen {

// So many plots side by side, row by row, as high as they need. Fails with ExitCode::no_backend.
Result<Image> picture_of_plots(std::span<const LogPlot> plots, int columns, int width_px, Theme theme,
                               Language language, Backend backend = Backend::automatic);

}  // namespace ryosen
