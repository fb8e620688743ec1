// Which part of a window is the views', and which the columns'. Session::place_view divides the former.
#pragma once

#include "app/editor/preferences/layout.h"
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

// The widest that a column of a window may be made by hand, at scale 1.
int widest_column_px(const Layout& layout, PanelPlace side, Size window, float column_scale);

}  // namespace ryosen
