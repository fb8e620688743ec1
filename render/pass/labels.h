// The labels pass: short texts over the picture of a view, each on a ground that sets it off.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "render/colour.h"
#include "render/pass/ui.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

struct DrawnLabel {
  glm::ivec2 corner{0};  // the upper left one, in pixels of the picture
  Size size;             // as of label_size
  std::string text;
  Rgba colour{}, ground{};
  friend bool operator==(const DrawnLabel&, const DrawnLabel&) = default;

  PixelRect rect() const { return {corner.x, corner.y, corner.x + size.width, corner.y + size.height}; }
};

// The size of a text in the first font of an atlas, with what its ground reaches beyond it.
Size label_size(const ImFontAtlas& atlas, const std::string& text);

class LabelsPass {
 public:
  explicit LabelsPass(std::optional<Failure>& failure) : ui_(failure) {}

  // Its first font is drawn with, until another one is set; the atlas must live as long.
  void set_fonts(ImFontAtlas& atlas);
  // Returns the rectangles that look different now.
  std::vector<PixelRect> set(std::span<const DrawnLabel> texts);
  // Draws what lies in a rectangle of the picture, in its pixels.
  void draw(const Framebuffer& picture, const PixelRect& rect);

 private:
  UiPass ui_;
  const ImFontAtlas* fonts_ = nullptr;
  std::vector<DrawnLabel> texts_;
};

}  // namespace ryosen
