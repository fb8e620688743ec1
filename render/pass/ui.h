// The UI pass: renders Dear ImGui's draw data.
#pragma once

#include "render/gl/buffer.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "ryosen/base/result.h"

struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;

namespace ryosen {

// An ImTextureID is the name of an OpenGL texture with premultiplied alpha; the picture of a view can be used as one.
class UiPass {
 public:
  explicit UiPass(std::optional<Failure>& failure);

  // Uploads the glyphs of an atlas to a texture and sets the atlas's texture id. Call it again after adding fonts.
  void set_fonts(ImFontAtlas& atlas);

  // Draws into a rectangle of `target`. Positions in the draw data times FramebufferScale are pixels of `target`.
  void draw(const ImDrawData& data, const Framebuffer& target, const PixelRect& rect);

 private:
  void draw_list(const ImDrawList& list, const ImDrawData& data, Size size, const PixelRect& rect);

  Program program_;
  VertexArray vertex_array_{"ui"};
  Buffer vertices_{"ui vertices"};
  Buffer indices_{"ui indices"};
  GlObject<TextureKind> fonts_;
};

}  // namespace ryosen
