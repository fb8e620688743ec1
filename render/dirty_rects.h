// The parts of a picture that have to be drawn anew.
#pragma once

#include <span>
#include <vector>

#include "core/view/size.h"

namespace ryosen {

// A few rectangles that do not overlap. Near ones are merged, far ones are kept apart, so that little is drawn twice
// and little in vain.
class DirtyRects {
 public:
  void add(PixelRect rect);
  // Takes out what is covered by the rectangle as a whole.
  void remove_inside(const PixelRect& rect);
  void clear() { rects_.clear(); }

  bool empty() const { return rects_.empty(); }
  std::span<const PixelRect> rects() const { return rects_; }
  PixelRect bounds() const;

 private:
  std::vector<PixelRect> rects_;
};

}  // namespace ryosen
