#include "render/dirty_rects.h"

#include <algorithm>
#include <cstdint>

namespace ryosen {
namespace {

std::int64_t area(const PixelRect& rect) { return std::int64_t{rect.width()} * rect.height(); }

// The extra pixels drawn if both are merged, minus the saved draw call, which costs as much as a few thousand pixels.
std::int64_t waste(const PixelRect& a, const PixelRect& b) {
  constexpr std::int64_t cost_of_a_draw = 4000;
  return area(united(a, b)) - area(a) - area(b) - cost_of_a_draw;
}

}  // namespace

void DirtyRects::add(PixelRect rect) {
  constexpr std::size_t most = 6;
  if (rect.empty()) return;
  for (std::size_t i = 0; i < rects_.size();) {
    if (overlap(rects_[i], rect) || waste(rects_[i], rect) <= 0) {
      rect = united(rects_[i], rect);
      rects_[i] = rects_.back();
      rects_.pop_back();
      i = 0;
    } else {
      ++i;
    }
  }
  if (rects_.size() < most) {
    rects_.push_back(rect);
    return;
  }
  const auto nearest = std::min_element(rects_.begin(), rects_.end(), [&](const PixelRect& a, const PixelRect& b) {
    return waste(a, rect) < waste(b, rect);
  });
  const PixelRect merged = united(*nearest, rect);
  *nearest = rects_.back();
  rects_.pop_back();
  add(merged);
}

void DirtyRects::remove_inside(const PixelRect& rect) {
  std::erase_if(rects_, [&](const PixelRect& r) { return intersection(r, rect) == r; });
}

PixelRect DirtyRects::bounds() const {
  PixelRect all;
  for (const PixelRect& rect : rects_) all = united(all, rect);
  return all;
}

}  // namespace ryosen
