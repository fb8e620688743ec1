#include "app/ui/headless.h"

#include "app/ui/gui.h"
#include "render/canvas.h"

namespace ryosen {

struct Headless::Window {
  Gui gui{1};
  std::unique_ptr<Canvas> canvas;
};

Headless::Headless(const Options& options, std::unique_ptr<Context> context)
    : options_(options), context_(std::move(context)) {}

Headless::~Headless() = default;

Result<std::unique_ptr<Headless>> Headless::make(const Options& options) {
  Result<std::unique_ptr<Context>> context = make_headless_context(options.backend);
  if (!context) return context.failure();
  std::unique_ptr<Headless> made(new Headless(options, std::move(context).value()));
  Result<std::unique_ptr<Viewport>> viewport = Viewport::make();
  if (!viewport) return viewport.failure();
  made->viewport_ = std::move(viewport).value();
  made->viewport_->set_supersample(options.supersample);
  made->viewport_->set_transparent(options.transparent && !options.panels);
  if (!options.panels) return made;
  Result<std::unique_ptr<Canvas>> canvas = Canvas::make();
  if (!canvas) return canvas.failure();
  made->window_ = std::make_unique<Window>();
  made->window_->canvas = std::move(canvas).value();
  made->window_->canvas->resize(options.size);
  return made;
}

void Headless::place_view(Session& session) const {
  session.view = options_.size;
  session.view_origin = {0, 0};
  if (window_) window_->gui.place_view(session, options_.size);
  session.frame_all();
}

Image Headless::picture(Session& session) {
  if (!window_) {
    viewport_->follow(session);
    viewport_->draw();
    return viewport_->view().read_pixels();
  }
  if (window_->gui.prepare(session)) window_->canvas->set_fonts(window_->gui.fonts());
  for (int i = 0; i < 3; ++i) window_->gui.frame(session, options_.size, 1);
  viewport_->follow(session);
  const PixelRect area = window_->gui.view_area(options_.size);
  window_->canvas->compose(viewport_->view(), area.x0, area.y0, window_->gui.draw_data());
  return window_->canvas->read_pixels();
}

}  // namespace ryosen
