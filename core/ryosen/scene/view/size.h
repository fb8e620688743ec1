// Sizes and rectangles in pixels, counted from the upper left corner.
#pragma once

#include <algorithm>

namespace ryosen {

struct Size {
  int width = 0;
  int height = 0;
  friend bool operator==(Size, Size) = default;
};

// The pixels with x0 <= x < x1 and y0 <= y < y1; empty when x0 >= x1 or y0 >= y1.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  static PixelRect all(Size size) { return {0, 0, size.width, size.height}; }
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

inline PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// The smallest rectangle that holds both; an empty one adds nothing.
inline PixelRect united(const PixelRect& a, const PixelRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

inline bool overlap(const PixelRect& a, const PixelRect& b) { return !intersection(a, b).empty(); }

}  // namespace ryosen
