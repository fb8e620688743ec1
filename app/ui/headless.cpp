#include "app/ui/headless.h"

#include <algorithm>

#include "app/editor/session/session.h"
#include "app/ui/gui.h"
#include "app/ui/window_input.h"
#include "render/canvas.h"

namespace ryosen {

struct Headless::Window {
  Gui gui{1};
  std::unique_ptr<Canvas> canvas;
  std::shared_ptr<WindowInput> input;
};

Headless::Headless(const Options& options, std::unique_ptr<Context> context)
    : options_(options), context_(std::move(context)) {}

Headless::~Headless() = default;

MemoryNeed Headless::need(const Options& options, std::uint64_t triangles) {
  // Bytes, measured at up to 4000 x 4000 pixels and 4 million triangles: colour and depth of what is rendered, what is
  // read back and packed of the picture, what triangles take besides the mesh, and the panels with their fonts.
  constexpr std::uint64_t per_rendered = 9, per_pixel = 9, per_triangle = 130, of_panels = std::uint64_t{32} << 20;
  const std::uint64_t pixels = std::uint64_t(options.size.width) * std::uint64_t(options.size.height);
  const std::uint64_t rendered = pixels * std::uint64_t(options.supersample) * std::uint64_t(options.supersample);
  const std::uint64_t bytes = rendered * per_rendered + pixels * per_pixel +
                              triangles * (per_triangle + options.bytes_per_triangle) +
                              (options.panels ? of_panels : 0);
  return context_need + MemoryNeed{bytes, bytes, bytes};
}

Result<std::unique_ptr<Headless>> Headless::make(const Options& options, std::uint64_t triangles) {
  if (auto lack = lack_of_memory({"This picture", "この画像"}, need(options, triangles))) return std::move(*lack);
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

void Headless::place_view(Session& session) {
  session.place_view(options_.size, {0, 0});
  session.frontend.input.reset();
  if (window_) {
    window_->gui.place_view(session, options_.size);
    window_->input = std::make_shared<WindowInput>(window_->gui, session, [this, &session] { lay_out(session); });
    window_->input->resize(options_.size);
    session.frontend.input = window_->input;
    lay_out(session);
  }
  session.framing.frame_all();
}

void Headless::lay_out(Session& session) {
  constexpr int to_settle = 3, most = 100;  // frames that a panel may need, and that one may ask for
  if (window_->gui.is_laying_out()) return;
  for (int i = 0; i < to_settle || (i < most && window_->gui.wants_frames()); ++i) {
    if (window_->gui.prepare(session)) window_->canvas->set_fonts(window_->gui.fonts());
    window_->gui.frame(session, options_.size, 0.02);
  }
}

Image Headless::view_drawn_again() {
  Renderer& renderer = viewport_->renderer();
  renderer.draw(PixelRect::all(renderer.size()));
  return renderer.read_pixels();
}

Image Headless::beside_each_other() {
  Image whole(options_.size, options_.transparent ? Rgba{0, 0, 0, 0} : Rgba{0, 0, 0, 255});
  for (const auto& [view, left, top] : viewport_->placed()) {
    const Image part = view->read_pixels();
    for (int y = 0; y < part.size.height; ++y) std::copy_n(&part.at(0, y), part.size.width, &whole.at(left, top + y));
  }
  return whole;
}

Image Headless::picture(Session& session) {
  if (!window_) {
    session.place_view(options_.size, {0, 0});
    viewport_->follow(session);
    viewport_->draw();
    return viewport_->compared() ? beside_each_other() : viewport_->renderer().read_pixels();
  }
  lay_out(session);
  viewport_->follow(session);
  window_->canvas->compose(viewport_->placed(), window_->gui.draw_data());
  return window_->canvas->read_pixels();
}

}  // namespace ryosen
