// Headless rendering of a session: the view only, or the whole editor with its panels.
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
    bool transparent = false;  // no background; no effect with panels
    int supersample = 1;
    std::uint64_t bytes_per_triangle = 0;  // that the switches of the view take (SwitchValue)
  };

  // What a picture of so many triangles takes besides the mesh.
  static MemoryNeed need(const Options& options, std::uint64_t triangles);

  // Creates a context and leaves it current; use and destroy the object on the same thread. Fails with
  // ExitCode::no_backend, and with ExitCode::out_of_memory where the limits leave less than the picture needs.
  static Result<std::unique_ptr<Headless>> make(const Options& options, std::uint64_t triangles = 0);
  ~Headless();

  // Sets the session's view to its area in the picture and fits the mesh into it. Pixels of pick, click and hover then
  // refer to the picture, and with panels its events go to these too, as in a window. The session must outlive this, or
  // be placed elsewhere.
  void place_view(Session& session);
  Image picture(Session& session);
  // The id image of the last picture, in pixels of the view.
  IdImage read_ids() { return viewport_->renderer().read_ids(); }
  // The view of the last picture, all of it drawn once more: no pixel differs.
  Image view_drawn_again();
  // Makes the next picture rebuild everything from its session.
  void forget() { viewport_->forget(); }
  std::string_view backend() const { return context_->name(); }

 private:
  struct Window;  // the editor around the view

  Headless(const Options& options, std::unique_ptr<Context> context);
  Image beside_each_other();  // those of both views, where a mesh stands beside
  // As many frames of the panels as they need.
  void lay_out(Session& session);

  Options options_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Viewport> viewport_;
  std::unique_ptr<Window> window_;
};

}  // namespace ryosen
