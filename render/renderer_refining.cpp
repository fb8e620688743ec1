// How a view is refined: tile by tile, in parts that cost no more than a frame may take.
#include <algorithm>

#include "render/renderer.h"

namespace ryosen {

double Renderer::effort_of(const PixelRect& rect) const {
  // What a software renderer takes on one core, in nanoseconds: for a sample with and without a surface, a triangle, a
  // line, point or ghost, and a sample of these.
  constexpr double empty_sample = 18, surface_sample = 60, triangle = 250, element = 300, element_sample = 10;
  constexpr double samples_each = Refinement::samples * Refinement::samples;  // pixel
  const std::size_t triangles = places_.triangles_inside(mesh_.clusters(), rect);
  const double samples = samples_each * rect.width() * rect.height();
  double effort = samples * (triangles > 0 ? surface_sample : empty_sample) + triangle * static_cast<double>(triangles);
  const Frame whole = frame(PixelRect::all(size_), 1);
  for (std::size_t i = 0; i < layer_count; ++i) {
    if (!is_shown_[i]) continue;
    const OverlayBuffer::Share share = overlays_[i].share_inside(whole, rect);
    effort += element * share.elements + element_sample * samples_each * share.pixels;
  }
  return effort;
}

void Renderer::refine() {
  constexpr int least_px = 8;  // below, what reaches into a part costs more than what lies in it
  while (auto part = refinement_.take()) {
    double effort = effort_of(part->rect);
    while (most_refining_ > 0 && effort > most_refining_ &&
           std::max(part->rect.width(), part->rect.height()) >= 2 * least_px) {
      refinement_.halve(*part);
      part = refinement_.take();
      effort = effort_of(part->rect);
    }
    if (refining_effort_ > 0 && refining_effort_ + effort > most_refining_) return refinement_.put_back(*part);
    refine(*part);
    refining_effort_ += effort;
  }
}

void Renderer::prepare_refining() {
  if (size_.width == 0 || size_.height == 0) return;
  const PixelRect all = PixelRect::all(size_);
  const PixelRect one{all.x0, all.y0, all.x0 + 1, all.y0 + 1};
  refine({one, one});
  dirty_.add(one);
}

void Renderer::refine(const Refinement::Part& part) {
  constexpr int scale = Refinement::samples, tile_px = Refinement::tile_px;
  const PixelRect rect = part.rect;
  fine_.resize({tile_px * scale, tile_px * scale});
  Frame f = frame(rect, scale);
  const DrawTarget target(fine_, f.size, {part.tile.x0 * scale, part.tile.y0 * scale});
  f.lower_left = target.lower_left();
  draw_all(f, target, places_.inside(mesh_.clusters(), rect));
  Framebuffer& picture = supersample_ > 1 ? resolved_ : rendered_;
  passes_.resolve.draw(fine_, scale, picture, rect, f.lower_left / scale);
  passes_.labels.draw(picture, rect);
  redrawn_.add(rect);
}

}  // namespace ryosen
