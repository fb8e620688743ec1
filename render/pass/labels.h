// The labels pass: the short texts over the picture of a view, and what of it changes with them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/pass/ui_labels.h"

namespace ryosen {

class LabelsPass {
 public:
  explicit LabelsPass(std::optional<Failure>& failure) : drawing_(failure) {}

  // See UiLabels::set_fonts.
  void set_fonts(ImFontAtlas& atlas) { drawing_.set_fonts(atlas); }
  // Returns the rectangles that look different now.
  std::vector<PixelRect> set(std::span<const DrawnLabel> texts);
  // Draws what lies in a rectangle of the picture, in its pixels.
  void draw(const Framebuffer& picture, const PixelRect& rect) { drawing_.draw(texts_, picture, rect); }

 private:
  UiLabels drawing_;
  std::vector<DrawnLabel> texts_;
};

}  // namespace ryosen
