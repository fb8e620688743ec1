// Dirty rectangles: the parts of a picture that have to be redrawn.
#pragma once

#include <span>
#include <vector>

#include "ryosen/scene/view/size.h"

namespace ryosen {

// A few disjoint rectangles. Nearby ones are merged, distant ones kept separate, to minimise overdraw and draw calls.
class DirtyRects {
 public:
  void add(PixelRect rect);
  // Removes the rectangles that lie entirely inside this one.
  void remove_inside(const PixelRect& rect);
  void clear() { rects_.clear(); }

  bool empty() const { return rects_.empty(); }
  std::span<const PixelRect> rects() const { return rects_; }
  PixelRect bounds() const;

 private:
  std::vector<PixelRect> rects_;
};

}  // namespace ryosen
