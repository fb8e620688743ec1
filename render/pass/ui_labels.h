// Labels: short texts over a picture in the font of the user interface, each on a ground that sets it off.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>

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

// Draws labels; no other pass needs to know the fonts of Dear ImGui.
class UiLabels {
 public:
  explicit UiLabels(std::optional<Failure>& failure) : ui_(failure) {}

  // Its first font is drawn with, until another one is set; the atlas must live as long.
  void set_fonts(ImFontAtlas& atlas);
  // Draws what lies in a rectangle of the picture, in its pixels; nothing before there are fonts.
  void draw(std::span<const DrawnLabel> labels, const Framebuffer& picture, const PixelRect& rect);

 private:
  UiPass ui_;
  const ImFontAtlas* fonts_ = nullptr;
};

}  // namespace ryosen
