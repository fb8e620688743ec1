// The columns beside the view: where they lie in the window, their panels with headers, and a border to drag. In a
// narrow window tabs, of which one opens its panel over the view. Session::place_view divides the rest, which is the
// views'.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "app/editor/preferences/layout.h"
#include "app/ui/panels.h"
#include "app/ui/whole_lines.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

struct Areas {
  PixelRect view, left, right;  // a column without panels is empty
  bool has_tabs = false;        // the window is too narrow for columns: each is a strip of tabs

  const PixelRect& column(PanelPlace side) const { return side == PanelPlace::left ? left : right; }
};

// How large things are: at a scale, 1 for about 96 pixels per inch, and letters at scale 1.
struct UiSize {
  UiSize(float of_all = 1, int of_letters_px = 15) : scale(of_all), font_px(of_letters_px) {}
  // Of what text stands in: columns, tabs and what lies over the view. Larger letters need more room.
  float of_columns() const;
  float scale;
  int font_px;
  bool operator==(const UiSize&) const = default;
};

// The view keeps some room, and at least a pixel.
Areas areas_of(const Layout& layout, Size window, const UiSize& size);

// A panel of the window, with its row.
struct OwnPanel {
  PanelRow row;
  std::unique_ptr<Panel> panel;
  std::unique_ptr<ScopedPanel> added;  // null for those of the list
  bool was_over = false;               // drawn over the view in the last frame
  float begins_px = 0;                 // from there on it covers the view, where it leaves that to be seen
};

class SideColumns {
 public:
  void draw(PanelContext& context, const Areas& areas, std::vector<OwnPanel>& panels);
  // How much of the view's width the panel that a tab has opened covers, at its left and at its right.
  glm::dvec2 covered_px(const PixelRect& view) const;
  // What is seen of those that scroll, in the last frame.
  std::span<const SeenPart> scrolled() const { return scrolled_; }
  // Whether that panel lies over a pixel.
  bool covers(glm::dvec2 pixel) const;

 private:
  void draw_column(PanelContext& context, PanelPlace side, const Areas& areas, std::vector<OwnPanel>& panels);
  // A panel of a column and where it lies there, scrolled or not.
  struct Lying {
    OwnPanel* own;
    float begin, end;
  };
  void draw_over(PanelContext& context, OwnPanel& own, float begin, float& height_px, const PanelRow* below);
  float draw_panels(PanelContext& context, PanelPlace side, float height, std::vector<OwnPanel>& panels);
  void show_wanted(PanelContext& context, float begin, float height, float kept_px);
  void draw_flyout(PanelContext& context, const Areas& areas, std::vector<OwnPanel>& panels);

  std::vector<SeenPart> scrolled_;
  float held_px_[2] = {};                       // how high the panel is that stays in view
  bool is_tight_[2] = {};                       // the left and the right column, as they were in the last frame
  ImVec2 flyout_at_{0, 0}, flyout_size_{0, 0};  // of the last frame
  float wanted_begin_ = -1, wanted_end_ = -1;   // of the panel that is scrolled to, as it lay in the last frame
};

// The name of the window of a column, or of the strip of its tabs.
const char* column_window(PanelPlace side);

// A strip of tabs, one for each panel of the column; those that have no room are in a menu behind the last tab.
void draw_tabs(PanelContext& context, PanelPlace side, const PixelRect& area);

}  // namespace ryosen
