#include "render/gl/framebuffer.h"

#include <cstring>

namespace ryosen {
namespace {

struct FormatRow {
  GLint internal;
  GLenum format;
  GLenum type;
  std::size_t bytes;
};

FormatRow row(PixelFormat format) {
  switch (format) {
    case PixelFormat::r32ui:
      return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
    case PixelFormat::r32f:
      return {GL_R32F, GL_RED, GL_FLOAT, 4};
    case PixelFormat::rgba8:
      break;
  }
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
}

}  // namespace

Framebuffer::Framebuffer(const char* label, std::span<const PixelFormat> formats, bool with_depth)
    : label_(label), formats_(formats.begin(), formats.end()), with_depth_(with_depth), object_(label) {}

void Framebuffer::resize(Size size) {
  if (size == size_) return;
  size_ = size;
  textures_.clear();
  glBindFramebuffer(GL_FRAMEBUFFER, object_.id());
  std::vector<GLenum> attachments;
  for (const PixelFormat format : formats_) {
    const FormatRow r = row(format);
    GlObject<TextureKind>& texture = textures_.emplace_back(label_);
    glTexImage2D(GL_TEXTURE_2D, 0, r.internal, size.width, size.height, 0, r.format, r.type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    attachments.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + attachments.size()));
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, texture.id(), 0);
  }
  if (with_depth_) {
    depth_ = GlObject<RenderbufferKind>(label_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  }
  glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
}

void Framebuffer::bind(const PixelRect& rect) const {
  glBindFramebuffer(GL_FRAMEBUFFER, object_.id());
  glViewport(0, 0, size_.width, size_.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(rect.x0, size_.height - rect.y1, rect.width(), rect.height());
}

void DrawTarget::bind(const PixelRect& rect) const {
  buffer_->bind(in_buffer(rect));
  glViewport(-lower_left().x, -lower_left().y, picture_.width, picture_.height);
}

void DrawTarget::read_depth(const PixelRect& rect, float* depths) const {
  buffer_->read_depth(in_buffer(rect), depths);
}

void Framebuffer::read(std::size_t index, const PixelRect& rect, void* pixels) const {
  const FormatRow r = row(formats_[index]);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, object_.id());
  glReadBuffer(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index));
  read_top_down(rect, r.format, r.type, r.bytes, pixels);
}

void Framebuffer::read_depth(const PixelRect& rect, float* depths) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, object_.id());
  read_top_down(rect, GL_DEPTH_COMPONENT, GL_FLOAT, sizeof(float), depths);
}

void Framebuffer::read_top_down(const PixelRect& rect, GLenum format, GLenum type, std::size_t bytes_each,
                                void* pixels) const {
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(rect.x0, size_.height - rect.y1, rect.width(), rect.height(), format, type, pixels);
  const std::size_t row_bytes = bytes_each * static_cast<std::size_t>(rect.width());
  auto* bytes = static_cast<unsigned char*>(pixels);
  std::vector<unsigned char> swap(row_bytes);
  for (int y = 0; y < rect.height() / 2; ++y) {
    unsigned char* upper = bytes + row_bytes * static_cast<std::size_t>(y);
    unsigned char* lower = bytes + row_bytes * static_cast<std::size_t>(rect.height() - 1 - y);
    std::memcpy(swap.data(), upper, row_bytes);
    std::memcpy(upper, lower, row_bytes);
    std::memcpy(lower, swap.data(), row_bytes);
  }
}

}  // namespace ryosen
