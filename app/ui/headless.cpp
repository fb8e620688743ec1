#include "app/ui/headless.h"

namespace ryosen {

struct Headless::Window {};

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
  made->viewport_->set_transparent(options.transparent);
  return made;
}

void Headless::place_view(Session& session) const {
  session.view = options_.size;
  session.view_origin = {0, 0};
  session.frame_all();
}

Image Headless::picture(Session& session) {
  viewport_->follow(session);
  viewport_->draw();
  return viewport_->view().read_pixels();
}

}  // namespace ryosen
