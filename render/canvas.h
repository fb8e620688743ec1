// The image of the whole window: a view with the user interface composited over it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/pass/ui.h"
#include "render/pass/ui_damage.h"
#include "render/renderer.h"

namespace ryosen {

// Keeps the window's image and redraws only what has changed.
class Canvas {
 public:
  static Result<std::unique_ptr<Canvas>> make();

  void resize(Size size);
  // See UiPass::set_fonts.
  void set_fonts(ImFontAtlas& atlas);

  // A view, and the place of its upper left corner.
  struct Placed {
    Renderer* view;
    int x, y;
  };
  // Updates the views, copies their pictures to their places, and draws `ui` (in window pixels) over them. Returns the
  // number of pixels redrawn; 0 if nothing changed. The rest of the window is black.
  std::int64_t compose(std::span<const Placed> views, const ImDrawData& ui);
  std::int64_t compose(Renderer& view, int x, int y, const ImDrawData& ui) {
    const Placed placed{&view, x, y};
    return compose(std::span(&placed, 1), ui);
  }

  // Draws over the current image; the next compose() redraws everything.
  void draw_over(const ImDrawData& ui);

  // Copies the image to another framebuffer of the same size; 0 is the window's.
  void present(GLuint framebuffer) const;
  Image read_pixels() const;
  Size size() const { return target_.size(); }

 private:
  explicit Canvas(std::optional<Failure>& failure);
  void draw(const PixelRect& rect, std::span<const Placed> views, const ImDrawData& ui);

  UiPass ui_;
  UiDamage damage_;
  Framebuffer target_;
  std::vector<PixelRect> placed_;  // the last positions of the views
};

}  // namespace ryosen
