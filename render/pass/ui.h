// Draws what Dear ImGui has laid out.
#pragma once

#include "core/base/result.h"
#include "render/gl/buffer.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"

struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;

namespace ryosen {

// An ImTextureID is the number of an OpenGL texture with alpha multiplied in; the picture of a view can be used as one.
class UiPass {
 public:
  static Result<UiPass> make();

  // Copies the glyphs of an atlas to a texture and tells the atlas its number. Call it again after adding fonts.
  void set_fonts(ImFontAtlas& atlas);

  // Draws into a rectangle of `target`. Positions of the draw data are pixels of `target`, times FramebufferScale.
  void draw(const ImDrawData& data, const Framebuffer& target, const PixelRect& rect);

 private:
  explicit UiPass(Program program);
  void draw_list(const ImDrawList& list, const ImDrawData& data, Size size, const PixelRect& rect);

  Program program_;
  VertexArray vertex_array_;
  Buffer vertices_{"ui vertices"};
  Buffer indices_{"ui indices"};
  GlObject<TextureKind> fonts_;
};

}  // namespace ryosen
