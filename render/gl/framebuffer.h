// Images that passes draw into.
#pragma once

#include <span>
#include <vector>

#include "core/view/size.h"
#include "render/gl/object.h"

namespace ryosen {

enum class PixelFormat { rgba8, r32ui, r32f };

// One colour texture per format given, all of one size, and a depth buffer of 24 bits when asked for.
// Rows run from the bottom up, as OpenGL has them; PixelRect counts from the top and is turned here.
class Framebuffer {
 public:
  Framebuffer(const char* label, std::span<const PixelFormat> formats, bool with_depth);

  // Gives all images a new size and undefined content.
  void resize(Size size);
  Size size() const { return size_; }
  GLuint id() const { return object_.id(); }
  GLuint texture(std::size_t index = 0) const { return textures_[index].id(); }

  // Makes this the target of drawing, restricted to a rectangle of it.
  void bind(const PixelRect& rect) const;
  // Reads one rectangle of one colour image into memory, rows from the top down, without padding.
  void read(std::size_t index, const PixelRect& rect, void* pixels) const;

 private:
  const char* label_;
  std::vector<PixelFormat> formats_;
  bool with_depth_;
  Size size_;
  GlObject<FramebufferKind> object_;
  std::vector<GlObject<TextureKind>> textures_;
  GlObject<RenderbufferKind> depth_;
};

}  // namespace ryosen
