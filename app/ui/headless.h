// Pictures of a session without a window: the view alone, or the whole editor with its panels.
#pragma once

#include <memory>

#include "app/ui/viewport.h"
#include "render/context/context.h"

namespace ryosen {

class Headless {
 public:
  struct Options {
    Backend backend = Backend::automatic;
    Size size{1280, 720};  // of the picture
    bool panels = false;
    bool transparent = false;  // no background; without effect under panels
    int supersample = 1;
  };

  // Makes a context and leaves it current; the object is used and destroyed on the same thread. Fails with
  // ExitCode::no_backend.
  static Result<std::unique_ptr<Headless>> make(const Options& options);
  ~Headless();

  // Gives the session the place in the picture that the view has, and fits the mesh into it. Pixels of pick, click and
  // hover are those of the picture from then on.
  void place_view(Session& session) const;
  Image picture(Session& session);
  // What is seen where, in pixels of the view, as of the last picture.
  IdImage read_ids() { return viewport_->view().read_ids(); }
  // Makes the next picture take everything of its session anew.
  void forget() { viewport_->forget(); }
  std::string_view backend() const { return context_->name(); }

 private:
  struct Window;  // the editor around the view

  Headless(const Options& options, std::unique_ptr<Context> context);

  Options options_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Viewport> viewport_;
  std::unique_ptr<Window> window_;
};

}  // namespace ryosen
