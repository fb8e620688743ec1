#include "render/gl/framebuffer.h"

#include <algorithm>

#include "ryosen/base/enum_table.h"

namespace ryosen {
namespace {

// Four bytes each.
struct FormatRow {
  PixelFormat pixels;
  GLint internal;
  GLenum format, type;
};
constexpr FormatRow format_rows[] = {
    {PixelFormat::rgba8, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {PixelFormat::r32ui, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
    {PixelFormat::r32f, GL_R32F, GL_RED, GL_FLOAT},
};
static_assert(rows_are_in_order(format_rows, &FormatRow::pixels));

const FormatRow& row(PixelFormat format) { return format_rows[static_cast<std::size_t>(format)]; }

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
    const FormatRow& r = row(format);
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
  const FormatRow& r = row(formats_[index]);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, object_.id());
  glReadBuffer(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index));
  read_top_down(rect, r.format, r.type, pixels);
}

void Framebuffer::read_depth(const PixelRect& rect, float* depths) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, object_.id());
  read_top_down(rect, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
}

void Framebuffer::read_top_down(const PixelRect& rect, GLenum format, GLenum type, void* pixels) const {
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(rect.x0, size_.height - rect.y1, rect.width(), rect.height(), format, type, pixels);
  const std::size_t width = static_cast<std::size_t>(rect.width());
  const auto row = [&](int y) { return static_cast<std::uint32_t*>(pixels) + width * static_cast<std::size_t>(y); };
  for (int y = 0; y < rect.height() / 2; ++y) std::swap_ranges(row(y), row(y) + width, row(rect.height() - 1 - y));
}

}  // namespace ryosen
