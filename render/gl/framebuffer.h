// Framebuffers: the render targets of passes.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/gl/object.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

enum class PixelFormat { rgba8, r32ui, r32f };

// One colour texture per format, all of one size, and optionally a 24-bit depth buffer. Rows are bottom-up, as in
// OpenGL; PixelRect counts from the top and is converted here.
class Framebuffer {
 public:
  Framebuffer(const char* label, std::span<const PixelFormat> formats, bool with_depth);

  // Resizes all images; their content is undefined afterwards.
  void resize(Size size);
  Size size() const { return size_; }
  GLuint id() const { return object_.id(); }
  GLuint texture(std::size_t index = 0) const { return textures_[index].id(); }

  // Binds this as the render target, with the scissor set to a rectangle.
  void bind(const PixelRect& rect) const;
  // Reads a rectangle of one colour image into memory, rows top-down, without padding.
  void read(std::size_t index, const PixelRect& rect, void* pixels) const;
  // The same of the depths, from 0 to 1.
  void read_depth(const PixelRect& rect, float* depths) const;

 private:
  // Of four bytes each.
  void read_top_down(const PixelRect& rect, GLenum format, GLenum type, void* pixels) const;

  const char* label_;
  std::vector<PixelFormat> formats_;
  bool with_depth_;
  Size size_;
  GlObject<FramebufferKind> object_;
  std::vector<GlObject<TextureKind>> textures_;
  GlObject<RenderbufferKind> depth_;
};

// A picture that is drawn into a framebuffer, or the part of it that the framebuffer has room for. Rectangles are those
// of the picture.
class DrawTarget {
 public:
  explicit DrawTarget(const Framebuffer& buffer) : DrawTarget(buffer, buffer.size(), {0, 0}) {}
  // The part with this upper left pixel.
  DrawTarget(const Framebuffer& buffer, Size picture, glm::ivec2 upper_left)
      : buffer_(&buffer), picture_(picture), upper_left_(upper_left) {}

  void bind(const PixelRect& rect) const;
  void read_depth(const PixelRect& rect, float* depths) const;
  // What is to be added to the pixels of OpenGL, to have those of the picture from its lower left.
  glm::ivec2 lower_left() const { return {upper_left_.x, picture_.height - upper_left_.y - buffer_->size().height}; }

 private:
  PixelRect in_buffer(const PixelRect& rect) const {
    return {rect.x0 - upper_left_.x, rect.y0 - upper_left_.y, rect.x1 - upper_left_.x, rect.y1 - upper_left_.y};
  }

  const Framebuffer* buffer_;
  Size picture_;
  glm::ivec2 upper_left_;
};

}  // namespace ryosen
