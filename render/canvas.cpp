#include "render/canvas.h"

namespace ryosen {
namespace {

constexpr PixelFormat window_formats[] = {PixelFormat::rgba8};

}  // namespace

Result<std::unique_ptr<Canvas>> Canvas::make() {
  std::optional<Failure> failure;
  std::unique_ptr<Canvas> made(new Canvas(failure));
  if (failure) return std::move(*failure);
  return made;
}

Canvas::Canvas(std::optional<Failure>& failure) : ui_(failure), target_("window", window_formats, false) {
  resize({1, 1});
}

void Canvas::resize(Size size) {
  target_.resize({std::max(size.width, 1), std::max(size.height, 1)});
  damage_.forget();
}

void Canvas::set_fonts(ImFontAtlas& atlas) {
  ui_.set_fonts(atlas);
  damage_.forget();
}

std::int64_t Canvas::compose(std::span<const Placed> views, const ImDrawData& ui) {
  const PixelRect all = PixelRect::all(target_.size());
  std::vector<PixelRect> places;
  for (const Placed& one : views)
    places.push_back({one.x, one.y, one.x + one.view->size().width, one.y + one.view->size().height});
  if (places != placed_) damage_.forget();
  placed_ = std::move(places);
  DirtyRects dirty;
  for (const auto& [view, x, y] : views) {
    view->draw();
    for (const PixelRect& rect : view->redrawn())
      dirty.add(intersection({rect.x0 + x, rect.y0 + y, rect.x1 + x, rect.y1 + y}, all));
  }
  for (const PixelRect& rect : damage_.update(ui, target_.size())) dirty.add(rect);
  std::int64_t pixels = 0;
  for (const PixelRect& rect : dirty.rects()) {
    draw(rect, views, ui);
    pixels += std::int64_t{rect.width()} * rect.height();
  }
  return pixels;
}

void Canvas::draw_over(const ImDrawData& ui) {
  const PixelRect all = PixelRect::all(target_.size());
  target_.bind(all);
  ui_.draw(ui, target_, all);
  damage_.forget();
}

void Canvas::draw(const PixelRect& rect, std::span<const Placed> views, const ImDrawData& ui) {
  target_.bind(rect);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const int height = target_.size().height;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Renderer& view = *views[i].view;
    const PixelRect& place = placed_[i];
    glBindFramebuffer(GL_READ_FRAMEBUFFER, view.picture().id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBlitFramebuffer(0, 0, view.size().width, view.size().height, place.x0, height - place.y1, place.x1,
                      height - place.y0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  ui_.draw(ui, target_, rect);
}

void Canvas::present(GLuint framebuffer) const {
  const Size size = target_.size();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.id());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image Canvas::read_pixels() const {
  Image image(target_.size());
  target_.read(0, PixelRect::all(target_.size()), image.pixels.data());
  return image;
}

}  // namespace ryosen
