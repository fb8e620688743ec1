#include "render/refinement.h"

#include <algorithm>

namespace ryosen {

void Refinement::begin(Size size) {
  size_ = size;
  columns_ = (size.width + tile_px - 1) / tile_px;
  const int rows = (size.height + tile_px - 1) / tile_px;
  is_coarse_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows), true);
  parts_.clear();
}

PixelRect Refinement::place(std::size_t tile) const {
  const int x = static_cast<int>(tile) % columns_ * tile_px, y = static_cast<int>(tile) / columns_ * tile_px;
  return {x, y, std::min(x + tile_px, size_.width), std::min(y + tile_px, size_.height)};
}

void Refinement::spoil(const PixelRect& rect) {
  const PixelRect inside = intersection(rect, PixelRect::all(size_));
  if (inside.empty()) return;
  for (int y = inside.y0 / tile_px; y <= (inside.y1 - 1) / tile_px; ++y)
    for (int x = inside.x0 / tile_px; x <= (inside.x1 - 1) / tile_px; ++x) {
      const int tile = y * columns_ + x;
      is_coarse_[static_cast<std::size_t>(tile)] = true;
    }
  if (!parts_.empty() && overlap(parts_.back().tile, rect)) parts_.clear();
}

std::optional<std::size_t> Refinement::next_tile() const {
  const auto found = std::find(is_coarse_.begin(), is_coarse_.end(), true);
  if (found == is_coarse_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - is_coarse_.begin());
}

std::optional<Refinement::Part> Refinement::take() {
  if (parts_.empty()) {
    const auto tile = next_tile();
    if (!tile) return std::nullopt;
    is_coarse_[*tile] = false;
    return Part{place(*tile), place(*tile)};
  }
  const Part part = parts_.back();
  parts_.pop_back();
  return part;
}

void Refinement::halve(const Part& part) {
  Part first = part, second = part;
  if (part.rect.width() > part.rect.height())
    first.rect.x1 = second.rect.x0 = (part.rect.x0 + part.rect.x1) / 2;
  else
    first.rect.y1 = second.rect.y0 = (part.rect.y0 + part.rect.y1) / 2;
  parts_.push_back(second);
  parts_.push_back(first);
}

}  // namespace ryosen
