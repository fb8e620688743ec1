// The columns beside the view: panels, and a border to drag. In a narrow window tabs, of which one opens its panel over
// the view.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "app/ui/areas.h"
#include "app/ui/panel_frame.h"

namespace ryosen {

class SideColumns {
 public:
  void draw(PanelContext& context, const Areas& areas, std::vector<OwnPanel>& panels);
  // Whether the panel that a tab has opened lies over a pixel.
  bool covers(glm::dvec2 pixel) const;

 private:
  void draw_column(PanelContext& context, PanelPlace side, const Areas& areas, std::vector<OwnPanel>& panels);
  void draw_flyout(PanelContext& context, const Areas& areas, std::vector<OwnPanel>& panels);

  bool is_tight_[2] = {};                       // the left and the right column, as they were in the last frame
  ImVec2 flyout_at_{0, 0}, flyout_size_{0, 0};  // of the last frame
};

// A strip of tabs, one for each panel of the column.
void draw_tabs(PanelContext& context, PanelPlace side, const PixelRect& area);

}  // namespace ryosen
