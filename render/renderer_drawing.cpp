// How a view draws what has changed: rectangle by rectangle, each by all passes; and how it is refined: tile by tile,
// in parts that cost no more than a frame may take.
#include <algorithm>

#include "render/renderer.h"

namespace ryosen {

bool Renderer::is_too_much(const PixelRect& rect, std::size_t most_triangles) const {
  constexpr int least = 16;  // pixels; below, halving gains nothing
  return most_triangles != 0 && std::max(rect.width(), rect.height()) >= 2 * least &&
         places_.triangles_inside(mesh_.clusters(), rect) / thinning_ > most_triangles;
}

PixelRect Renderer::take_waiting() {
  while (is_too_much(waiting_.back(), most_triangles_)) {
    PixelRect &rest = waiting_.back(), part = rest;
    const bool is_wide = rest.width() > rest.height();
    if (is_wide)
      part.x1 = rest.x0 = (rest.x0 + rest.x1) / 2;
    else
      part.y1 = rest.y0 = (rest.y0 + rest.y1) / 2;
    waiting_.push_back(part);
  }
  const PixelRect next = waiting_.back();
  waiting_.pop_back();
  return next;
}

PixelRect Renderer::draw() {
  follow_camera();
  follow_ground();
  waiting_.insert(waiting_.end(), dirty_.rects().begin(), dirty_.rects().end());
  dirty_.clear();
  redrawn_.clear();
  triangles_drawn_ = triangles_hidden_ = 0;
  refining_effort_ = 0;
  while (!waiting_.empty() && (most_triangles_ == 0 || triangles_drawn_ < most_triangles_)) {
    const PixelRect rect = take_waiting();
    if (most_triangles_ != 0 && triangles_drawn_ != 0 &&
        triangles_drawn_ + places_.triangles_inside(mesh_.clusters(), rect) / thinning_ > most_triangles_) {
      waiting_.push_back(rect);
      break;
    }
    redrawn_.add(rect);
    draw(rect);
  }
  if (redrawn_.empty() && refines_ && !is_refined()) refine();
  return redrawn_.bounds();
}

void Renderer::draw_all(const Frame& frame, const DrawTarget& target, std::span<const std::uint32_t> clusters) {
  target.bind(frame.rect);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_scene(frame, target, clusters);
  for (std::size_t i = 0; i < layer_count; ++i)
    if (is_shown_[i])
      passes_.overlay.draw(frame, overlays_[i],
                           static_cast<Layer>(i) <= Layer::hover ? OverlayPass::Of::mesh : OverlayPass::Of::view);
}

void Renderer::draw_scene(const Frame& frame, const DrawTarget& target, std::span<const std::uint32_t> clusters) {
  const bool is_xray = frame.settings.xray == Xray::on;
  if (!is_xray) {
    draw_surface(frame, target, clusters);
    passes_.cut.draw(frame, mesh_, clusters);
  }
  if (!transparent_) passes_.background.draw(frame);
  if (frame.settings.ground == GroundGrid::on) passes_.grid.draw(frame, ground_);
  if (is_xray) passes_.xray.draw(frame, mesh_, clusters, tints_);
}

void Renderer::draw_surface(const Frame& frame, const DrawTarget& target, std::span<const std::uint32_t> clusters) {
  // To look costs about as much as to draw so many triangles, and some for each pixel.
  constexpr std::size_t worth_looking = 100000, worth_pixels = 4, most_looks = 4;
  const std::size_t pixels = std::size_t(frame.rect.width()) * std::size_t(frame.rect.height());
  const std::size_t least = std::max(worth_looking, pixels / worth_pixels) * thinning_ / MeshBuffers::cluster_size;
  const std::size_t part = std::max(least / 2, clusters.size() / most_looks);
  std::vector<std::uint32_t> left(clusters.begin(), clusters.end());
  while (left.size() > std::max(least, part)) {
    passes_.surface.draw(frame, mesh_, std::span(left).first(part), tints_);
    left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(part));
    occlusion_.read(target, frame.rect);
    const int scale = static_cast<int>(frame.pixel_scale);
    triangles_hidden_ +=
        places_.remove_hidden(mesh_.clusters(), occlusion_, frame.clip_from_buffer, scale, left) / thinning_;
    target.bind(frame.rect);
  }
  passes_.surface.draw(frame, mesh_, left, tints_);
}

void Renderer::draw(const PixelRect& asked) {
  PixelRect rect = intersection(asked, PixelRect::all(size_));
  follow_ground();
  if (planes_stale_) {
    place_planes();
    rect = PixelRect::all(size_);
  }
  if (rect.empty()) return;
  const std::vector<std::uint32_t> clusters = places_.inside(mesh_.clusters(), rect);
  std::size_t triangles = 0;
  for (const std::uint32_t cluster : clusters) triangles += mesh_.clusters()[cluster].count;
  triangles_drawn_ += triangles / thinning_;
  draw_all(frame(rect, supersample_), DrawTarget(rendered_), clusters);
  if (supersample_ > 1) passes_.resolve.draw(rendered_, supersample_, resolved_, rect);
  passes_.labels.draw(picture(), rect);
  refinement_.spoil(rect);
  dirty_.remove_inside(rect);
}

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
