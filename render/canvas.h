// The picture of the whole window: a view with the user interface over it.
#pragma once

#include <memory>

#include "render/pass/ui.h"
#include "render/pass/ui_damage.h"
#include "render/view.h"

namespace ryosen {

// Keeps the window's picture and redraws of it what has changed.
class Canvas {
 public:
  static Result<std::unique_ptr<Canvas>> make();

  void resize(Size size);
  // See UiPass::set_fonts.
  void set_fonts(ImFontAtlas& atlas);

  // Draws what the view has to draw, puts its picture at (x, y), and `ui`, in pixels of the window, over it. Returns
  // how many pixels were drawn anew; 0 when nothing changed. What neither covers is black.
  std::int64_t compose(View& view, int x, int y, const ImDrawData& ui);

  // Draws over the picture as it is; the next compose() draws all of it anew.
  void draw_over(const ImDrawData& ui);

  // Copies the picture to another framebuffer of the same size, the window's being number 0.
  void present(GLuint framebuffer) const;
  Image read_pixels() const;
  Size size() const { return target_.size(); }

 private:
  explicit Canvas(UiPass ui);
  void draw(const PixelRect& rect, const View& view, const ImDrawData& ui);

  UiPass ui_;
  UiDamage damage_;
  Framebuffer target_;
  PixelRect placed_;  // where the view was last
};

}  // namespace ryosen
