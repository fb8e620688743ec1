// The values that a person prefers, as the table of preferences sets them (preferences.h); and the display's scale.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "app/editor/input/input_presets.h"
#include "ryosen/base/message.h"

namespace ryosen {

struct Preferences {
  static constexpr int usual_font_px = 15;

  Language language = Language::english;
  double ui_scale = 1;               // of all of the window, times that of the display
  double display_scale = 1;          // set by the window
  int font_size_px = usual_font_px;  // at scale 1
  int samples = 1;                   // a side of each pixel of the view
  double crease_deg = 30;            // edges that bend by more stay sharp where the surface is smooth
  OrbitAbout orbit_about = OrbitAbout::point;
  std::size_t input_preset = 0;       // of input_presets()
  std::vector<KeyBinding> bindings;   // the user's own keys
  std::vector<std::string> recent{};  // files that were open before, the latest first; kept by the window

  // How many pixels of the view lines, points, handles, labels and the reach of the pointer count as one.
  double size_scale() const { return display_scale * ui_scale; }
  // The same of what is written there, which grows with the letters that somebody prefers.
  double label_scale() const { return size_scale() * std::max(1.0, double(font_size_px) / usual_font_px); }
};

// Sizes of the caption in the upper left corner of the view, at label scale 1.
inline constexpr double caption_row_px = 19, caption_margin_px = 12;
// Height at the top of the view that a usual caption of two rows takes, in pixels.
inline double caption_px(const Preferences& preferences) {
  return (caption_margin_px + 2 * caption_row_px) * preferences.label_scale();
}

}  // namespace ryosen
